// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/CellSample.h"

#include "brickwall/core/base/SplitMix.h"

#include <algorithm>
#include <span>

namespace brickwall {
namespace {

/// valueOf(brick, cell of it) is asked in the order of the bricks.
template <class ValueOf>
std::vector<SampledCell> sample(std::span<const Brick> bricks, std::uint64_t cells, std::uint64_t count,
                                const ValueOf& valueOf)
{
    const std::uint64_t stride = std::max<std::uint64_t>(1, cells / std::max<std::uint64_t>(1, count));
    std::vector<SampledCell> sample;
    sample.reserve(std::size_t(cells / stride + 1));
    std::size_t brick = 0;
    for (std::uint64_t first = 0; first < cells; first += stride) {
        const std::uint64_t group = std::min(stride, cells - first);
        const std::uint64_t cell = first + splitMix(first) % group;
        while (cell >= bricks[brick].begin + bricks[brick].cellCount())
            ++brick;
        const double width = bricks[brick].cellWidth();
        sample.push_back({valueOf(brick, cell - bricks[brick].begin), width * width * width * double(group)});
    }
    return sample;
}

} // namespace

std::vector<SampledCell> sampleCells(const Model& model, const Field& field, std::uint64_t count)
{
    const std::uint64_t cells = std::min<std::uint64_t>(model.cellCount, field.values.size());
    return sample(model.bricks, cells, count, [&](std::size_t brick, std::uint64_t cell) {
        return field.values[model.bricks[brick].begin + cell];
    });
}

std::vector<SampledCell> sampleCells(const Model& model, const RegionTree& tree, const PaddedField& padded,
                                     std::uint64_t count)
{
    return sample(model.bricks, model.cellCount, count, [&](std::size_t b, std::uint64_t cell) {
        const PaddedBrick& brick = tree.bricks[b];
        const vec3i n = brick.paddedSize();
        const std::uint64_t x = cell % brick.size.x, y = cell / brick.size.x % brick.size.y;
        const std::uint64_t z = cell / brick.size.x / brick.size.y;
        return padded.values[brick.begin + (x + 1) + n.x * ((y + 1) + n.y * (z + 1))];
    });
}

} // namespace brickwall
