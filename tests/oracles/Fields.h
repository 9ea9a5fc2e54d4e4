// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Model.h"

#include <glm/geometric.hpp>

#include <functional>
#include <vector>

namespace brickwall::oracles {

/// value = offset + dot(gradient, voxel). Its reconstruction on one level is itself, wherever all eight cells around a
/// point are there.
struct AffineField
{
    double offset;
    vec3d gradient; ///< per voxel

    double operator()(const vec3d& voxel) const { return offset + glm::dot(gradient, voxel); }
};

/// A model of these bricks (their `begin` is set here) with one field, "f", of values at cell centres in voxel space.
Model modelOf(std::vector<Brick> bricks, const std::function<double(const vec3d& voxel)>& value,
              const mat4d& worldFromVoxel = mat4d(1.0));

/// The cells of a box of one level, cut into bricks of `brickCells` cells (fewer at the upper ends). `lower` counts
/// cells of that level, as `size` does.
std::vector<Brick> oneLevelBricks(const vec3i& lower, const vec3i& size, const vec3i& brickCells, int level);

} // namespace brickwall::oracles
