// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/VectorSampler.h"

#include "brickwall/core/model/Half.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

/// Memos are forgotten when they have grown to some tens of MB.
constexpr std::size_t memoLimit = 200000;

double largest(const vec3d& v)
{
    return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)});
}

std::vector<Box3i> supportsOf(std::span<const Brick> bricks)
{
    std::vector<Box3i> boxes;
    boxes.reserve(bricks.size());
    for (const Brick& brick : bricks)
        boxes.push_back(half::supportOf(brick).box);
    return boxes;
}

} // namespace

/// N of the components, D, and N of the cells' centres; with the cells and their weights, for the gradients.
struct VectorSampler::Sums
{
    struct Part
    {
        std::uint32_t brick;
        vec3i cell;
        double weight;
    };

    vec3d values{0.0}, centres{0.0};
    double weight = 0.0, coarsest = 0.0;
    std::array<Part, 8 * (maxLevel + 1)> parts; ///< at most eight of each level
    std::size_t count = 0;
    int level = -1; ///< of the cell that has the point
};

VectorSampler::VectorSampler(const Model& model, const std::array<std::size_t, 3>& components)
    : bricks_(model.bricks),
      voxelFromWorld_(glm::inverse(model.worldFromVoxel)),
      index_(model.bricks),
      supports_(supportsOf(model.bricks)),
      gradients_(bricks_, index_)
{
    for (int axis = 0; axis < 3; ++axis)
        values_[axis] = model.fields[components[axis]].values;
    const glm::dmat3 m(model.worldFromVoxel);
    worldPerVoxel_ = std::min({glm::length(m[0]), glm::length(m[1]), glm::length(m[2])});
}

std::optional<VectorSampler::Sample> VectorSampler::at(const vec3d& world, Memo& memo) const
{
    const vec3d voxel = transformPoint(voxelFromWorld_, world);
    if (!(largest(voxel) < coordinateLimit))
        return {};
    Sums sums;
    const vec3i corner(glm::floor(2.0 * voxel));
    supports_.overlapping({corner, corner + 1}, [&](std::uint32_t b, const Box3i&) { addBrick(b, voxel, sums); });
    if (sums.level < 0 || !(sums.weight > 0.0))
        return {};
    vec3d value = sums.values / sums.weight;
    const vec3d offset = voxel - sums.centres / sums.weight;
    if (largest(offset) > 1e-9 * sums.coarsest)
        value += correction(offset, sums, memo);
    return Sample{value, worldPerVoxel_ * (1 << sums.level)};
}

void VectorSampler::addBrick(std::uint32_t b, const vec3d& voxel, Sums& sums) const
{
    const Brick& brick = bricks_[b];
    const double width = brick.cellWidth();
    const vec3d q = (voxel - vec3d(brick.lower)) / width; // cell i is from i to i + 1
    if (Box3d{vec3d(0.0), vec3d(brick.size)}.contains(q))
        sums.level = brick.level;
    const vec3i low(glm::floor(q - 0.5));
    const vec3i first = glm::max(low, vec3i(0)), last = glm::min(low + 1, brick.size - 1);
    for (int z = first.z; z <= last.z; ++z)
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) {
                const vec3i cell(x, y, z);
                const vec3d tents = glm::max(1.0 - glm::abs(q - 0.5 - vec3d(cell)), vec3d(0.0));
                const double weight = tents.x * tents.y * tents.z;
                if (weight == 0.0)
                    continue;
                const std::uint64_t slot = brick.slotOf(cell);
                sums.values += weight * vec3d(values_[0][slot], values_[1][slot], values_[2][slot]);
                sums.centres += weight * (vec3d(brick.lower) + (vec3d(cell) + 0.5) * width);
                sums.weight += weight;
                sums.coarsest = std::max(sums.coarsest, width);
                sums.parts[sums.count++] = {b, cell, weight};
            }
}

/// The gradient at the point, reconstructed like a value, times the way to it from where B is exact.
vec3d VectorSampler::correction(const vec3d& offset, const Sums& sums, Memo& memo) const
{
    if (memo.size() > memoLimit)
        memo.clear();
    vec3d result(0.0);
    for (std::size_t i = 0; i < sums.count; ++i) {
        const Sums::Part& part = sums.parts[i];
        const Brick& brick = bricks_[part.brick];
        const std::uint64_t slot = brick.slotOf(part.cell);
        const auto [entry, isNew] = memo.try_emplace(slot);
        if (isNew)
            gradients_.at(part.brick, part.cell, values_, entry->second);
        for (int f = 0; f < 3; ++f)
            result[f] += part.weight * glm::dot(entry->second[f], offset);
    }
    return result / sums.weight;
}

} // namespace brickwall
