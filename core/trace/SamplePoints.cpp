// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/SamplePoints.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "brickwall/core/trace/SamplePoints.cpp"
#include "brickwall/core/simd/ForEachTarget.h"

#include "brickwall/core/trace/Reconstruct.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// Each point may lie in another region, so that all lanes do the same one: slower than rays, but the very same code.
PointSample pointKernel(const RegionTree& tree, const PaddedField& field, std::uint32_t index, const vec3d& voxel)
{
    const Region& region = tree.regions[index];
    const vec3d local = voxel - 0.5 * vec3d(region.lower);
    const PointN p{FloatN(static_cast<float>(local.x)), FloatN(static_cast<float>(local.y)),
                   FloatN(static_cast<float>(local.z))};
    const float* values = field.values.data();
    const PaddedBrick& brick = tree.bricks[tree.brickLists[region.firstBrick]];
    const Range range = field.regionRanges[index];
    const SampleN s = region.brickCount == 1 ? sampleBrick<true>(BrickView(brick, values, region.lower), p)
                                             : sampleBricks<true>(tree, region, values, region.lower, p, range.lo);
    if (none(s.valid))
        return {};
    alignas(64) float lanes[4][16];
    store(clamp(s.value, range.lo, range.hi), lanes[0]);
    store(s.gradient.x, lanes[1]);
    store(s.gradient.y, lanes[2]);
    store(s.gradient.z, lanes[3]);
    return {lanes[0][0], {lanes[1][0], lanes[2][0], lanes[3][0]}, true};
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

#include "brickwall/core/trace/BrickLimits.h"

#include <glm/matrix.hpp>

namespace brickwall {

HWY_EXPORT(pointKernel);

PointSample sampleVoxel(const RegionTree& regions, const PaddedField& field, const vec3d& voxel)
{
    const std::int64_t region = findRegion(regions, 2.0 * voxel);
    if (region < 0)
        return {};
    return HWY_DYNAMIC_DISPATCH(pointKernel)(regions, field, static_cast<std::uint32_t>(region), voxel);
}

void samplePoints(const RegionTree& regions, const PaddedField& field, const mat4d& worldFromVoxel,
                  std::span<const vec3d> points, std::span<PointSample> samples, const Executor& executor)
{
    checkBrickSizes(regions);
    const mat4d voxelFromWorld = glm::inverse(worldFromVoxel);
    const glm::dmat3 worldFromGradient = glm::transpose(glm::dmat3(voxelFromWorld));
    executor.forEach(points.size(), 64, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            samples[i] = sampleVoxel(regions, field, transformPoint(voxelFromWorld, points[i]));
            samples[i].gradient = vec3f(worldFromGradient * vec3d(samples[i].gradient));
        }
    });
}

} // namespace brickwall
#endif
