// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/Differentiate.h"

#include "brickwall/core/base/LargeArray.h"

#include <glm/common.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>

namespace brickwall {
namespace {

/// Marks cells of a tile's border that no cell of its level is at. Values are finite, so none is mistaken for it.
constexpr float absent = std::numeric_limits<float>::quiet_NaN();

/// A part of a brick that is worked on at a time: with three fields and their border it fits a core's cache.
constexpr vec3i tileSize(64, 16, 16);

struct Tile
{
    std::uint32_t brick;
    vec3i lower, size; ///< in the brick's cells
};

std::vector<Tile> tilesOf(std::span<const Brick> bricks)
{
    std::vector<Tile> tiles;
    for (std::size_t b = 0; b < bricks.size(); ++b)
        for (int z = 0; z < bricks[b].size.z; z += tileSize.z)
            for (int y = 0; y < bricks[b].size.y; y += tileSize.y)
                for (int x = 0; x < bricks[b].size.x; x += tileSize.x) {
                    const vec3i lower(x, y, z);
                    tiles.push_back({std::uint32_t(b), lower, glm::min(tileSize, bricks[b].size - lower)});
                }
    return tiles;
}

/// A tile's values with one layer of cells of the same level around.
class PaddedTile
{
public:
    void fill(const Tile& tile, std::span<const Brick> bricks, const BrickIndex& index, FieldValues fields)
    {
        const Brick& own = bricks[tile.brick];
        const int width = own.cellWidth();
        const vec3i corner = own.lower + (tile.lower - 1) * width;
        size_ = tile.size + 2;
        for (std::size_t f = 0; f < fields.size(); ++f)
            values_[f].assign(std::size_t(size_.x) * size_.y * size_.z, absent);
        index.overlapping({corner, corner + size_ * width}, [&](std::uint32_t b, const Box3i& box) {
            if (bricks[b].level == own.level)
                copy(bricks[b], (box.lower - corner) / width, fields);
        });
    }

    /// Of field f, at a cell of the tile.
    const float* at(std::size_t f, int x, int y, int z) const
    {
        return values_[f].data() + slot({x + 1, y + 1, z + 1});
    }
    std::ptrdiff_t stride(int axis) const
    {
        return axis == 0 ? 1 : axis == 1 ? size_.x : std::ptrdiff_t(size_.x) * size_.y;
    }

private:
    std::size_t slot(const vec3i& c) const { return c.x + std::size_t(size_.x) * (c.y + std::size_t(size_.y) * c.z); }

    /// `offset` is where the brick begins in the padded tile.
    void copy(const Brick& source, const vec3i& offset, FieldValues fields)
    {
        const vec3i lower = glm::max(vec3i(0), offset), upper = glm::min(size_, offset + source.size);
        for (int z = lower.z; z < upper.z; ++z)
            for (int y = lower.y; y < upper.y; ++y) {
                const vec3i c = vec3i(lower.x, y, z) - offset;
                const std::uint64_t from = source.slotOf(c);
                for (std::size_t f = 0; f < fields.size(); ++f)
                    std::copy_n(fields[f].data() + from, upper.x - lower.x, values_[f].data() + slot({lower.x, y, z}));
            }
    }

    vec3i size_{0};
    std::array<std::vector<float>, 3> values_;
};

template <FlowOperator op>
class Differentiator
{
public:
    static constexpr std::size_t components = componentsOf(op);

    Differentiator(std::span<const Brick> bricks, FieldValues fields, const mat4d& worldFromVoxel,
                   std::vector<float>& out)
        : bricks_(bricks),
          fields_(fields),
          index_(bricks),
          border_(bricks, index_),
          worldFromGradient_(glm::transpose(glm::dmat3(glm::inverse(worldFromVoxel)))),
          out_(out)
    {
    }

    void tile(const Tile& tile, PaddedTile& padded) const
    {
        const Brick& brick = bricks_[tile.brick];
        padded.fill(tile, bricks_, index_, fields_);
        const glm::dmat3 fromDifferences = worldFromGradient_ * (0.5 / brick.cellWidth());
        for (int z = 0; z < tile.size.z; ++z)
            for (int y = 0; y < tile.size.y; ++y) {
                const vec3i c = tile.lower + vec3i(0, y, z);
                float* out = out_.data() + brick.slotOf(c);
                for (int x = 0; x < tile.size.x; ++x) {
                    std::array<vec3d, 3> gradients;
                    if (centralDifferences(padded, {x, y, z}, gradients))
                        toWorld(fromDifferences, gradients);
                    else
                        fromCellsAround(tile.brick, c + vec3i(x, 0, 0), gradients);
                    out[x] = static_cast<float>(flowValue(op, gradients));
                }
            }
    }

private:
    /// False if a neighbour is missing.
    static bool centralDifferences(const PaddedTile& padded, const vec3i& c, std::array<vec3d, 3>& differences)
    {
        for (std::size_t f = 0; f < components; ++f) {
            const float* v = padded.at(f, c.x, c.y, c.z);
            for (int axis = 0; axis < 3; ++axis) {
                const std::ptrdiff_t stride = padded.stride(axis);
                differences[f][axis] = double(v[stride]) - v[-stride];
            }
        }
        return !std::isnan(differences[0].x + differences[0].y + differences[0].z);
    }

    static void toWorld(const glm::dmat3& m, std::array<vec3d, 3>& gradients)
    {
        for (std::size_t f = 0; f < components; ++f)
            gradients[f] = m * gradients[f];
    }

    void fromCellsAround(std::size_t brick, const vec3i& cell, std::array<vec3d, 3>& gradients) const
    {
        border_.at(brick, cell, fields_, gradients);
        toWorld(worldFromGradient_, gradients);
    }

    std::span<const Brick> bricks_;
    FieldValues fields_;
    BrickIndex index_;
    BorderGradients border_;
    glm::dmat3 worldFromGradient_;
    std::vector<float>& out_;
};

template <FlowOperator op>
void run(std::span<const Brick> bricks, FieldValues fields, const mat4d& worldFromVoxel, std::vector<float>& out,
         const Executor& executor, Progress& progress)
{
    const Differentiator<op> differentiator(bricks, fields, worldFromVoxel, out);
    const std::vector<Tile> tiles = tilesOf(bricks);
    executor.forEach(tiles.size(), 4, [&](std::size_t begin, std::size_t end) {
        PaddedTile padded;
        for (std::size_t t = begin; t < end; ++t) {
            progress.check();
            differentiator.tile(tiles[t], padded);
            progress.advance(std::uint64_t(tiles[t].size.x) * tiles[t].size.y * tiles[t].size.z);
        }
    });
}

} // namespace

std::vector<float> differentiate(FlowOperator op, std::span<const Brick> bricks, FieldValues fields,
                                 const mat4d& worldFromVoxel, const Executor& executor, Progress& progress)
{
    const std::size_t cells = bricks.empty() ? 0 : bricks.back().begin + bricks.back().cellCount();
    std::vector<float> out = makeLargeArray(cells, executor);
    const auto with = [&](auto run) {
        run(bricks, fields.first(componentsOf(op)), worldFromVoxel, out, executor, progress);
    };
    switch (op) {
    case FlowOperator::qCriterion:
        with(run<FlowOperator::qCriterion>);
        break;
    case FlowOperator::lambda2:
        with(run<FlowOperator::lambda2>);
        break;
    case FlowOperator::vorticityMagnitude:
        with(run<FlowOperator::vorticityMagnitude>);
        break;
    case FlowOperator::divergence:
        with(run<FlowOperator::divergence>);
        break;
    case FlowOperator::gradientMagnitude:
        with(run<FlowOperator::gradientMagnitude>);
        break;
    }
    return out;
}

} // namespace brickwall
