// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/LargeArray.h"
#include "brickwall/core/model/BrickIndex.h"
#include "brickwall/core/model/Half.h"
#include "brickwall/core/model/Regions.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace brickwall {
namespace {

/// Marks pad cells without a neighbour until they are clamped. Fields are finite, so no value is mistaken for it.
constexpr float absent = std::numeric_limits<float>::quiet_NaN();

/// One brick's padded values. Cells count from -1 to size per axis.
class Padded
{
public:
    Padded(const PaddedBrick& brick, float* values) : brick_(brick), values_(values) {}

    float& at(const vec3i& c) const
    {
        const vec3i n = brick_.paddedSize();
        return values_[std::size_t(c.x + 1) + std::size_t(n.x) * (std::size_t(c.y + 1) + std::size_t(n.y) * (c.z + 1))];
    }

    void fillAbsent() const
    {
        const vec3i n = brick_.paddedSize();
        std::fill_n(values_, std::size_t(n.x) * n.y * n.z, absent);
    }

    /// Copies the cells that a brick of the same level has in the padded box.
    void copyFrom(const Brick& source, const float* sourceValues) const
    {
        const vec3i offset = (source.lower - brick_.lower) / brick_.cellWidth();
        const vec3i lower = glm::max(vec3i(-1), offset);
        const vec3i upper = glm::min(brick_.size + 1, offset + source.size);
        for (int z = lower.z; z < upper.z; ++z)
            for (int y = lower.y; y < upper.y; ++y) {
                const vec3i c = vec3i(lower.x, y, z) - offset;
                const float* row = sourceValues + source.begin + c.x +
                                   std::size_t(source.size.x) * (c.y + std::size_t(source.size.y) * c.z);
                std::copy_n(row, upper.x - lower.x, &at({lower.x, y, z}));
            }
    }

    /// Gives every absent pad cell a value from inside. Corners first, then edges, then faces: each looks at cells that
    /// lie outside along fewer axes, which have to be as they were copied.
    void clampAbsent() const
    {
        for (int outside = 3; outside >= 1; --outside)
            for (int z = -1; z <= brick_.size.z; ++z)
                for (int y = -1; y <= brick_.size.y; ++y) {
                    const int outsideYZ = isOutside(y, brick_.size.y) + isOutside(z, brick_.size.z);
                    if (outsideYZ == outside - 1) {
                        clampIfAbsent({-1, y, z});
                        clampIfAbsent({brick_.size.x, y, z});
                    } else if (outsideYZ == outside) {
                        for (int x = 0; x < brick_.size.x; ++x)
                            clampIfAbsent({x, y, z});
                    }
                }
    }

private:
    static bool isOutside(int i, int size) { return i < 0 || i >= size; }

    /// N / D at a missing layer is the clamped value: an axis along which the neighbour is missing is clamped, the
    /// others are kept.
    void clampIfAbsent(const vec3i& c) const
    {
        if (!std::isnan(at(c)))
            return;
        const vec3i inside = glm::clamp(c, vec3i(0), brick_.size - 1);
        vec3i kept = inside;
        for (int a = 0; a < 3; ++a) {
            vec3i neighbour = inside;
            neighbour[a] = c[a];
            if (!std::isnan(at(neighbour)))
                kept[a] = c[a];
        }
        at(c) = std::isnan(at(kept)) ? at(inside) : at(kept);
    }

    const PaddedBrick& brick_;
    float* values_;
};

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

PaddedField padField(const Field& field, std::span<const Brick> bricks, const RegionTree& tree,
                     const Executor& executor, Progress& progress)
{
    PaddedField padded;
    padded.range = field.range;
    padded.values = makeLargeArray(tree.paddedCellCount, executor);
    progress.begin("padding bricks", bricks.size());
    const BrickIndex index(bricks);
    executor.forEach(bricks.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t b = begin; b < end; ++b) {
            progress.check();
            const Padded target(tree.bricks[b], padded.values.data() + tree.bricks[b].begin);
            target.fillAbsent();
            const Box3i box = bricks[b].box();
            const int w = bricks[b].cellWidth();
            index.overlapping({box.lower - w, box.upper + w}, [&](std::uint32_t n, const Box3i&) {
                if (bricks[n].level == bricks[b].level)
                    target.copyFrom(bricks[n], field.values.data());
            });
            target.clampAbsent();
        }
        progress.advance(end - begin);
    });

    padded.regionRanges.resize(tree.regions.size());
    padded.regionSlopes.resize(tree.regions.size());
    padded.regionLogSlopes.resize(tree.regions.size());
    progress.begin("finding value ranges", tree.regions.size());
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
    progress.end();
    return padded;
}

} // namespace brickwall
