// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/model/Regions.h"

#include <span>

namespace brickwall {

/// The reconstructed field at a point. Where no tent reaches, `valid` is false and the rest 0.
struct PointSample
{
    float value = 0.0f;
    vec3f gradient{0.0f}; ///< per world unit, if nothing else is said
    bool valid = false;
};

/// B and its gradient (here per voxel) at one point in voxel space, of regions whose bricks have passed
/// checkBrickSizes.
PointSample sampleVoxel(const RegionTree& regions, const PaddedField& field, const vec3d& voxel);

/// B and its gradient at points in world space, by the same code that integrates rays. `samples` is as long as
/// `points`.
void samplePoints(const RegionTree& regions, const PaddedField& field, const mat4d& worldFromVoxel,
                  std::span<const vec3d> points, std::span<PointSample> samples, const Executor& executor);

} // namespace brickwall
