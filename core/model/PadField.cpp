// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/PadField.h"

#include "brickwall/core/base/LargeArray.h"
#include "brickwall/core/model/BrickIndex.h"
#include "brickwall/core/model/RegionValues.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <utility>

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

    /// Takes the brick's own cells and leaves the layer around them absent.
    void fill(const float* own) const
    {
        const vec3i n = brick_.paddedSize();
        std::fill_n(values_, std::size_t(n.x) * n.y * n.z, absent);
        for (int z = 0; z < brick_.size.z; ++z)
            for (int y = 0; y < brick_.size.y; ++y, own += brick_.size.x)
                std::copy_n(own, brick_.size.x, &at({0, y, z}));
    }

    /// Copies the own cells of another brick of the same level that lie in this one's layer. They are written to by
    /// nobody, so that any number of bricks may do this at the same time.
    void copyFrom(const Padded& other) const
    {
        const vec3i offset = (other.brick_.lower - brick_.lower) / brick_.cellWidth();
        const vec3i lower = glm::max(vec3i(-1), offset);
        const vec3i upper = glm::min(brick_.size + 1, offset + other.brick_.size);
        for (int z = lower.z; z < upper.z; ++z)
            for (int y = lower.y; y < upper.y; ++y)
                std::copy_n(&other.at(vec3i(lower.x, y, z) - offset), upper.x - lower.x, &at({lower.x, y, z}));
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

/// How many padded values are made at a time while those of the field are given back.
constexpr std::uint64_t valuesAtOnce = std::uint64_t(16) << 20;

/// The field's values with absent ones around each brick's, brick by brick in their order. `release` gives them back.
std::vector<float> spread(const std::vector<float>& values, std::span<const Brick> bricks, const RegionTree& tree,
                          const std::function<void(std::uint64_t begin, std::uint64_t end)>& release,
                          const Executor& executor, Progress& progress)
{
    std::vector<float> padded = roomForLargeArray(tree.paddedCellCount);
    for (std::size_t first = 0, last = 0; first < bricks.size(); first = last) {
        const auto endOf = [&](std::size_t brick) {
            return brick + 1 < bricks.size() ? tree.bricks[brick + 1].begin : tree.paddedCellCount;
        };
        while (last < bricks.size() && (last == first || endOf(last) <= tree.bricks[first].begin + valuesAtOnce))
            ++last;
        growLargeArray(padded, endOf(last - 1), executor);
        executor.forEach(last - first, 16, [&](std::size_t begin, std::size_t end) {
            progress.check();
            for (std::size_t b = first + begin; b < first + end; ++b)
                Padded(tree.bricks[b], padded.data() + tree.bricks[b].begin).fill(values.data() + bricks[b].begin);
        });
        release(bricks[first].begin, bricks[last - 1].begin + bricks[last - 1].cellCount());
        progress.advance(last - first);
    }
    return padded;
}

void fillLayers(std::vector<float>& padded, std::span<const Brick> bricks, const RegionTree& tree,
                const Executor& executor, Progress& progress)
{
    const BrickIndex index(bricks);
    const auto valuesOf = [&](std::size_t b) { return Padded(tree.bricks[b], padded.data() + tree.bricks[b].begin); };
    executor.forEach(bricks.size(), 16, [&](std::size_t begin, std::size_t end) {
        progress.check();
        for (std::size_t b = begin; b < end; ++b) {
            const Padded target = valuesOf(b);
            const Box3i box = bricks[b].box();
            const int w = bricks[b].cellWidth();
            index.overlapping({box.lower - w, box.upper + w}, [&](std::uint32_t n, const Box3i&) {
                if (n != b && bricks[n].level == bricks[b].level)
                    target.copyFrom(valuesOf(n));
            });
            target.clampAbsent();
        }
        progress.advance(end - begin);
    });
}

PaddedField pad(const Field& field, std::span<const Brick> bricks, const RegionTree& tree,
                const std::function<void(std::uint64_t, std::uint64_t)>& release, const Executor& executor,
                Progress& progress)
{
    PaddedField padded;
    padded.range = field.range;
    progress.begin("padding bricks", 2 * bricks.size());
    padded.values = spread(field.values, bricks, tree, release, executor, progress);
    fillLayers(padded.values, bricks, tree, executor, progress);
    progress.begin("finding value ranges", tree.regions.size());
    findRegionValues(tree, executor, progress, padded);
    progress.end();
    return padded;
}

} // namespace

PaddedField padField(const Field& field, std::span<const Brick> bricks, const RegionTree& tree,
                     const Executor& executor, Progress& progress)
{
    return pad(
        field, bricks, tree, [](std::uint64_t, std::uint64_t) {}, executor, progress);
}

PaddedField padField(Field&& field, std::span<const Brick> bricks, const RegionTree& tree, const Executor& executor,
                     Progress& progress)
{
    Field taken = std::move(field);
    const auto release = [&](std::uint64_t begin, std::uint64_t end) {
        releaseValues(std::span(taken.values).subspan(begin, end - begin));
    };
    return pad(taken, bricks, tree, release, executor, progress);
}

} // namespace brickwall
