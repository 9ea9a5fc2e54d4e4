// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/ReferencePieces.h"

#include <algorithm>
#include <limits>

#include <glm/common.hpp>

namespace brickwall::reference {
namespace {

/// The tents' weights of a block along one axis at position f.
std::array<double, 2> weightsAt(const CellBlock& block, int axis, double f)
{
    return {block.own[axis][0] ? 1.0 - f : 0.0, block.own[axis][1] ? f : 0.0};
}

std::array<double, 2> slopesOf(const CellBlock& block, int axis)
{
    return {block.own[axis][0] ? -1.0 / block.width : 0.0, block.own[axis][1] ? 1.0 / block.width : 0.0};
}

using AxisWeights = std::array<std::array<double, 2>, 3>;

struct Sums
{
    double n, d;
};

Sums sum(const CellBlock& block, const AxisWeights& w)
{
    double n = 0.0;
    for (int k = 0; k < 2; ++k)
        for (int j = 0; j < 2; ++j) {
            const double* v = &block.values[4 * k + 2 * j];
            n += w[2][k] * w[1][j] * (w[0][0] * v[0] + w[0][1] * v[1]);
        }
    return {n, (w[0][0] + w[0][1]) * (w[1][0] + w[1][1]) * (w[2][0] + w[2][1])};
}

AxisWeights allWeights(const CellBlock& block, double s)
{
    AxisWeights w;
    for (int axis = 0; axis < 3; ++axis)
        w[axis] = weightsAt(block, axis, block.f0[axis] + s * (block.f1[axis] - block.f0[axis]));
    return w;
}

/// Adds a block's share of N and D. A product of three linear functions has as its Bernstein coefficients the means
/// of its blossom's values: of the products with k of the three taken at s = 1, the others at s = 0.
void addBlossom(const CellBlock& block, Cubic& n, Cubic& d)
{
    std::array<AxisWeights, 2> ends{allWeights(block, 0.0), allWeights(block, 1.0)};
    for (int corner = 0; corner < 8; ++corner) {
        const int x = corner & 1, y = (corner >> 1) & 1, z = corner >> 2, atOne = x + y + z;
        const Sums s = sum(block, {ends[x][0], ends[y][1], ends[z][2]});
        const double share = atOne == 0 || atOne == 3 ? 1.0 : 1.0 / 3.0;
        n.b[atOne] += share * s.n;
        d.b[atOne] += share * s.d;
    }
}

bool isOwn(const CellBlock& block, int corner)
{
    return block.own[0][corner & 1] && block.own[1][(corner >> 1) & 1] && block.own[2][corner >> 2];
}

} // namespace

void Piece::finish()
{
    n = {}, d = {};
    spread = 0.0;
    bool first = true;
    for (CellBlock& block : blocks)
        for (int corner = 0; corner < 8; ++corner) {
            double& v = block.values[corner];
            if (isOwn(block, corner) && std::exchange(first, false))
                reference = v;
            v = isOwn(block, corner) ? v - reference : 0.0;
            spread = std::max(spread, std::abs(v));
        }
    for (const CellBlock& block : blocks)
        addBlossom(block, n, d);
    dMax_ = *std::max_element(d.b.begin(), d.b.end());
    clearVanishingEnds();
    lo = std::numeric_limits<double>::infinity();
    hi = -lo;
    for (int i = 0; i < 4; ++i)
        if (d.b[i] > 0.0) {
            lo = std::min(lo, reference + n.b[i] / d.b[i]);
            hi = std::max(hi, reference + n.b[i] / d.b[i]);
        }
}

/// Where a ray enters or leaves what supports cover, D starts or ends with zeros but for rounding, which N / D would
/// blow up.
void Piece::clearVanishingEnds()
{
    const double vanishing = 1e-12 * dMax_;
    for (int i = 0; i < 4 && d.b[i] <= vanishing; ++i)
        n.b[i] = d.b[i] = 0.0;
    for (int i = 3; i >= 0 && d.b[i] <= vanishing; --i)
        n.b[i] = d.b[i] = 0.0;
}

double Piece::rounding() const
{
    return 8.0 * std::numeric_limits<double>::epsilon() * (spread + std::abs(reference));
}

double Piece::relativeValue(double s) const
{
    const auto positive = [](double c) { return c > 0.0; };
    if (s == 0.0 && vanishesAtStart()) {
        const auto i = std::find_if(d.b.begin(), d.b.end(), positive);
        return n.b[i - d.b.begin()] / *i;
    }
    if (s == 1.0 && vanishesAtEnd()) {
        const auto i = std::find_if(d.b.rbegin(), d.b.rend(), positive);
        return n.b[d.b.rend() - i - 1] / *i;
    }
    return n(s) / d(s);
}

/// Along the axis, every block has but one cell, at one place: its weight is a factor of N and D alike, which B does
/// not depend on. That is so at the outer faces of the data.
bool Piece::flatAlong(int axis) const
{
    const CellBlock& first = blocks.front();
    return std::all_of(blocks.begin(), blocks.end(), [&](const CellBlock& b) {
        return b.own[axis] == first.own[axis] && b.own[axis][0] != b.own[axis][1] && b.width == first.width &&
               b.f0[axis] == first.f0[axis] && b.f1[axis] == first.f1[axis];
    });
}

vec3d Piece::gradient(double s) const
{
    const std::array<bool, 3> flat{flatAlong(0), flatAlong(1), flatAlong(2)};
    double sumN = 0.0, sumD = 0.0;
    vec3d gradN(0.0), gradD(0.0);
    for (const CellBlock& block : blocks) {
        AxisWeights w = allWeights(block, s);
        for (int axis = 0; axis < 3; ++axis)
            if (flat[axis]) // without the factor there is nothing that vanishes
                w[axis] = {block.own[axis][0] ? 1.0 : 0.0, block.own[axis][1] ? 1.0 : 0.0};
        const Sums here = sum(block, w);
        sumN += here.n;
        sumD += here.d;
        for (int axis = 0; axis < 3; ++axis) {
            if (flat[axis])
                continue;
            AxisWeights slope = w;
            slope[axis] = slopesOf(block, axis);
            const Sums change = sum(block, slope);
            gradN[axis] += change.n;
            gradD[axis] += change.d;
        }
    }
    return sumD > 0.0 ? (gradN - gradD * (sumN / sumD)) / sumD : vec3d(0.0);
}

PieceWalk::PieceWalk(const Supports& supports, std::span<const PaddedBrick> bricks, const float* values,
                     const Line& line, double tNear, double tFar)
    : bricks_(bricks), values_(values), line_(line)
{
    supports.cross(line, tNear, tFar, crossings_);
    std::sort(crossings_.begin(), crossings_.end(),
              [](const Crossing& a, const Crossing& b) { return a.t0 != b.t0 ? a.t0 < b.t0 : a.brick < b.brick; });
    for (const Crossing& crossing : crossings_)
        addBreaks(crossing);
    std::sort(breaks_.begin(), breaks_.end());
    breaks_.erase(std::unique(breaks_.begin(), breaks_.end()), breaks_.end());
}

void PieceWalk::addBreaks(const Crossing& crossing)
{
    breaks_.push_back(crossing.t0);
    breaks_.push_back(crossing.t1);
    const double width = bricks_[crossing.brick].cellWidth();
    const vec3d u0 = line_.at(crossing.t0) / width - 0.5, u1 = line_.at(crossing.t1) / width - 0.5;
    for (int axis = 0; axis < 3; ++axis) {
        if (line_.dir[axis] == 0.0)
            continue;
        const double last = std::ceil(std::max(u0[axis], u1[axis]));
        for (double k = std::floor(std::min(u0[axis], u1[axis])); k <= last; ++k) {
            const double t = ((k + 0.5) * width - line_.org[axis]) / line_.dir[axis];
            if (t > crossing.t0 && t < crossing.t1)
                breaks_.push_back(t);
        }
    }
}

bool PieceWalk::next(Piece& piece)
{
    if (nextBreak_ >= breaks_.size())
        return false;
    piece.t0 = breaks_[nextBreak_ - 1];
    piece.t1 = breaks_[nextBreak_++];
    std::erase_if(active_, [&](const Crossing& c) { return c.t1 <= piece.t0; });
    for (; nextCrossing_ < crossings_.size() && crossings_[nextCrossing_].t0 <= piece.t0; ++nextCrossing_)
        active_.push_back(crossings_[nextCrossing_]);

    const vec3d p0 = line_.at(piece.t0), p1 = line_.at(piece.t1), middle = line_.at(0.5 * (piece.t0 + piece.t1));
    double finest = std::numeric_limits<double>::infinity();
    piece.blocks.clear();
    for (const Crossing& crossing : active_) {
        piece.blocks.push_back(blockOf(bricks_[crossing.brick], p0, middle, p1));
        finest = std::min(finest, piece.blocks.back().width);
    }
    const vec3d reach = glm::max(glm::max(glm::abs(p0), glm::abs(p1)), glm::abs(line_.org));
    piece.positionNoise =
        std::numeric_limits<double>::epsilon() * std::max({reach.x, reach.y, reach.z, piece.t1}) / finest;
    piece.finish();
    return true;
}

CellBlock PieceWalk::blockOf(const PaddedBrick& brick, const vec3d& p0, const vec3d& middle, const vec3d& p1) const
{
    CellBlock block;
    block.width = brick.cellWidth();
    vec3i index;
    for (int axis = 0; axis < 3; ++axis) {
        const double first = brick.lower[axis] / block.width; // exact: bricks are aligned
        const double cell = std::floor(middle[axis] / block.width - 0.5);
        const double lower = std::clamp(cell, first - 1.0, first + brick.size[axis] - 1.0);
        index[axis] = int(lower - first);
        block.own[axis] = {index[axis] >= 0, index[axis] + 1 < brick.size[axis]};
        block.f0[axis] = std::clamp(p0[axis] / block.width - 0.5 - lower, 0.0, 1.0);
        block.f1[axis] = std::clamp(p1[axis] / block.width - 0.5 - lower, 0.0, 1.0);
    }
    const std::size_t strideY = std::size_t(brick.size.x) + 2, strideZ = strideY * (std::size_t(brick.size.y) + 2);
    const float* corner = values_ + brick.begin + (index.x + 1) + strideY * (index.y + 1) + strideZ * (index.z + 1);
    for (int i = 0; i < 8; ++i)
        block.values[i] = corner[(i & 1) + ((i >> 1) & 1) * strideY + (i >> 2) * strideZ];
    return block;
}

} // namespace brickwall::reference
