// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/BorderGradients.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace brickwall {
namespace {

/// The unknowns: six second derivatives, then the gradient, so that back substitution finds it first.
constexpr int unknowns = 9, firstSlope = 6;
using Row = std::array<double, unknowns>;

/// Next to nothing of each unknown is added to what is minimised, so that those that no cell tells anything of become
/// 0; more of the second derivatives, so that two cells in a row are a straight line.
constexpr double slopeRidge = 1e-9, curvatureRidge = 1e-6;

Row monomials(const vec3d& d)
{
    return {d.x * d.x, d.y * d.y, d.z * d.z, d.x * d.y, d.x * d.z, d.y * d.z, d.x, d.y, d.z};
}

/// What one neighbour says, or the mean of several: the polynomial there is the own value plus `row` times the
/// unknowns.
struct Neighbour
{
    Row row{};
    vec3d values{0.0}; ///< of up to three fields, less the own cell's
    double cells = 0.0;

    void add(const vec3d& offset, const vec3d& difference)
    {
        const Row m = monomials(offset);
        for (int i = 0; i < unknowns; ++i)
            row[i] += m[i];
        values += difference;
        cells += 1.0;
    }

    void mean()
    {
        for (double& r : row)
            r /= cells;
        values /= cells;
        cells = 1.0;
    }
};

/// Weighted least squares by normal equations; the lower triangle.
class Fit
{
public:
    Fit()
    {
        for (int i = 0; i < unknowns; ++i)
            a_[i][i] = i < firstSlope ? curvatureRidge : slopeRidge;
    }

    void add(const Neighbour& n)
    {
        const vec3d at(n.row[firstSlope], n.row[firstSlope + 1], n.row[firstSlope + 2]);
        const double d2 = glm::dot(at, at), weight = 1.0 / (d2 * d2 * d2);
        for (int i = 0; i < unknowns; ++i) {
            const double w = weight * n.row[i];
            b_[i] += w * n.values;
            for (int j = 0; j <= i; ++j)
                a_[i][j] += w * n.row[j];
        }
    }

    /// The slopes of all fields: slopes[axis][field]. By Cholesky's decomposition.
    std::array<vec3d, 3> slopes()
    {
        for (int i = 0; i < unknowns; ++i)
            for (int j = 0; j <= i; ++j) {
                double sum = a_[i][j];
                for (int k = 0; k < j; ++k)
                    sum -= a_[i][k] * a_[j][k];
                a_[i][j] = i == j ? std::sqrt(std::max(sum, slopeRidge * slopeRidge)) : sum / a_[j][j];
            }
        for (int i = 0; i < unknowns; ++i) {
            for (int k = 0; k < i; ++k)
                b_[i] -= a_[i][k] * b_[k];
            b_[i] /= a_[i][i];
        }
        for (int i = unknowns - 1; i >= firstSlope; --i) {
            for (int k = i + 1; k < unknowns; ++k)
                b_[i] -= a_[k][i] * b_[k];
            b_[i] /= a_[i][i];
        }
        return {b_[firstSlope], b_[firstSlope + 1], b_[firstSlope + 2]};
    }

private:
    double a_[unknowns][unknowns] = {};
    std::array<vec3d, unknowns> b_{}; ///< a right-hand side per field
};

/// The cells around one cell, put into its fit.
class Around
{
public:
    Around(std::span<const Brick> bricks, const BrickIndex& index, std::size_t brick, const vec3i& cell,
           FieldValues fields)
        : bricks_(bricks), fields_(fields), level_(bricks[brick].level), width_(bricks[brick].cellWidth())
    {
        const Brick& own = bricks[brick];
        lower_ = own.lower + cell * width_;
        value_ = valuesAt(own.slotOf(cell));
        index.overlapping({lower_ - 2 * width_, lower_ + 3 * width_},
                          [&](std::uint32_t b, const Box3i&) { near_.push_back(b); });
    }

    std::array<vec3d, 3> slopes()
    {
        for (int z = -1; z <= 1; ++z)
            for (int y = -1; y <= 1; ++y)
                for (int x = -1; x <= 1; ++x)
                    if (x != 0 || y != 0 || z != 0)
                        add({x, y, z});
        return fit_.slopes();
    }

private:
    vec3d valuesAt(std::uint64_t slot) const
    {
        vec3d values(0.0);
        for (std::size_t f = 0; f < fields_.size(); ++f)
            values[int(f)] = fields_[f][slot];
        return values;
    }

    /// The cell's neighbour at this offset; if there is nothing beyond a face, what is two widths the other way, too.
    void add(const vec3i& offset)
    {
        const vec3i squares = offset * offset;
        if (!addBox(offset) && squares.x + squares.y + squares.z == 1)
            addBox(-2 * offset);
    }

    bool addBox(const vec3i& offset)
    {
        const Box3i box{lower_ + offset * width_, lower_ + (offset + 1) * width_};
        Neighbour neighbour;
        for (const std::uint32_t b : near_) {
            const Brick& brick = bricks_[b];
            const Box3i common = brick.box().intersection(box);
            if (common.empty())
                continue;
            if (brick.level > level_) {
                addCoarser(brick, box);
                return true;
            }
            addCells(neighbour, brick, common);
        }
        if (neighbour.cells == 0.0)
            return false;
        neighbour.mean();
        fit_.add(neighbour);
        return true;
    }

    /// The one cell that has the box, once.
    void addCoarser(const Brick& brick, const Box3i& box)
    {
        const vec3i cell = (box.lower - brick.lower) / brick.cellWidth();
        const std::uint64_t slot = brick.slotOf(cell);
        if (std::find(coarser_.begin(), coarser_.end(), slot) != coarser_.end())
            return;
        coarser_.push_back(slot);
        Neighbour neighbour;
        addCell(neighbour, brick, cell);
        fit_.add(neighbour);
    }

    void addCells(Neighbour& neighbour, const Brick& brick, const Box3i& common) const
    {
        const vec3i lower = (common.lower - brick.lower) / brick.cellWidth();
        const vec3i upper = (common.upper - brick.lower) / brick.cellWidth();
        for (int z = lower.z; z < upper.z; ++z)
            for (int y = lower.y; y < upper.y; ++y)
                for (int x = lower.x; x < upper.x; ++x)
                    addCell(neighbour, brick, {x, y, z});
    }

    void addCell(Neighbour& neighbour, const Brick& brick, const vec3i& cell) const
    {
        const int w = brick.cellWidth();
        const vec3d offset = (vec3d(brick.lower + cell * w - lower_) + 0.5 * (w - width_)) / double(width_);
        neighbour.add(offset, valuesAt(brick.slotOf(cell)) - value_);
    }

    std::span<const Brick> bricks_;
    FieldValues fields_;
    int level_, width_;
    vec3i lower_;
    vec3d value_;
    std::vector<std::uint32_t> near_;
    std::vector<std::uint64_t> coarser_; ///< cells that are in the fit
    Fit fit_;
};

} // namespace

void BorderGradients::at(std::size_t brick, const vec3i& cell, FieldValues fields,
                         std::array<vec3d, 3>& gradients) const
{
    const std::array<vec3d, 3> slopes = Around(bricks_, index_, brick, cell, fields).slopes();
    const double perVoxel = 1.0 / bricks_[brick].cellWidth();
    for (int f = 0; f < 3; ++f)
        gradients[f] = perVoxel * vec3d(slopes[0][f], slopes[1][f], slopes[2][f]);
}

} // namespace brickwall
