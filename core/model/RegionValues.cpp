// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/RegionValues.h"

#include "brickwall/core/model/Half.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>

namespace brickwall {
namespace {

Range rangeOfCells(const PaddedBrick& brick, const float* values, const vec3i& lower, const vec3i& upper)
{
    const vec3i n = brick.paddedSize();
    Range range;
    for (int z = lower.z; z < upper.z; ++z)
        for (int y = lower.y; y < upper.y; ++y) {
            const float* row = values + brick.begin + (lower.x + 1) +
                               std::size_t(n.x) * (std::size_t(y + 1) + std::size_t(n.y) * (z + 1));
            const auto [lo, hi] = std::minmax_element(row, row + (upper.x - lower.x));
            range.extend({*lo, *hi});
        }
    return range;
}

/// Calls visit(axis, row, stride, count) for every row of cells that have a neighbour `stride` further, along all axes.
template <class Visit>
void forNeighbours(const PaddedBrick& brick, const float* values, const vec3i& lower, const vec3i& upper,
                   const Visit& visit)
{
    const vec3i n = brick.paddedSize();
    const std::size_t stride[3] = {1, std::size_t(n.x), std::size_t(n.x) * n.y};
    for (int axis = 0; axis < 3; ++axis) {
        vec3i end = upper;
        --end[axis];
        for (int z = lower.z; z < end.z; ++z)
            for (int y = lower.y; y < end.y; ++y) {
                const float* row =
                    values + brick.begin + (lower.x + 1) + (std::size_t(y + 1) * n.x + std::size_t(z + 1) * stride[2]);
                visit(axis, row, stride[axis], end.x - lower.x);
            }
    }
}

/// The largest difference of neighbours along each axis, as the length of a vector.
float largestDifference(const PaddedBrick& brick, const float* values, const vec3i& lower, const vec3i& upper)
{
    vec3f largest(0.0f);
    forNeighbours(brick, values, lower, upper, [&](int axis, const float* row, std::size_t stride, int count) {
        float most = 0.0f;
        for (int x = 0; x < count; ++x)
            most = std::max(most, std::abs(row[x + stride] - row[x]));
        largest[axis] = std::max(largest[axis], most);
    });
    return static_cast<float>(glm::length(vec3d(largest))); // squares of floats may vanish
}

/// The same of the logarithms of positive values, from their bits, which rise with the logarithm at 1 to 2 times 2^23:
/// at least the mean change between two neighbours, and up to twice that.
float largestLogDifference(const PaddedBrick& brick, const float* values, const vec3i& lower, const vec3i& upper)
{
    vec3f largest(0.0f);
    forNeighbours(brick, values, lower, upper, [&](int axis, const float* row, std::size_t stride, int count) {
        std::int32_t most = 0;
        for (int x = 0; x < count; ++x)
            most = std::max(
                most, std::abs(std::bit_cast<std::int32_t>(row[x + stride]) - std::bit_cast<std::int32_t>(row[x])));
        largest[axis] = std::max(largest[axis], float(most) * 0x1p-23f);
    });
    return glm::length(largest);
}

struct RegionValues
{
    Range range;
    float slope = 0.0f;
    float logSlope = 0.0f;
};

/// Of the cells whose tents reach the region: the padded cells of a single brick's stencils, or the listed bricks' own
/// cells.
RegionValues valuesOfRegion(const Region& region, const RegionTree& tree, const float* values)
{
    RegionValues result;
    Range& range = result.range;
    for (std::uint32_t i = 0; i < region.brickCount; ++i) {
        const PaddedBrick& brick = tree.bricks[tree.brickLists[region.firstBrick + i]];
        const Box3i reaching = half::cellsReaching({region.lower, region.upper}, brick.level);
        const vec3i first = brick.lower / brick.cellWidth();
        const int pad = region.brickCount == 1 ? 1 : 0;
        const vec3i lower = glm::max(reaching.lower - first, vec3i(-pad));
        const vec3i upper = glm::min(reaching.upper - first, brick.size + pad);
        range.extend(rangeOfCells(brick, values, lower, upper));
        if (region.brickCount == 1) {
            const float width = static_cast<float>(brick.cellWidth());
            result.slope = largestDifference(brick, values, lower, upper) / width;
            if (range.lo > 0.0f)
                result.logSlope = largestLogDifference(brick, values, lower, upper) / width;
        }
    }
    if (region.brickCount > 1) { // the weights change by up to their own size per cell along each axis
        const float perWidth = 4.0f / static_cast<float>(1 << region.finestLevel);
        result.slope = perWidth * range.span();
        if (range.lo > 0.0f)
            result.logSlope = perWidth * std::log(range.hi / range.lo);
    }
    return result;
}

} // namespace

void findRegionValues(const RegionTree& tree, const Executor& executor, Progress& progress, PaddedField& padded)
{
    padded.regionRanges.resize(tree.regions.size());
    padded.regionSlopes.resize(tree.regions.size());
    padded.regionLogSlopes.resize(tree.regions.size());
    executor.forEach(tree.regions.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r) {
            if (r % 64 == 0)
                progress.check();
            const RegionValues found = valuesOfRegion(tree.regions[r], tree, padded.values.data());
            padded.regionRanges[r] = found.range;
            padded.regionSlopes[r] = found.slope;
            padded.regionLogSlopes[r] = found.logSlope;
        }
        progress.advance(end - begin);
    });
}

} // namespace brickwall
