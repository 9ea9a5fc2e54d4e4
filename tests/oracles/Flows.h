// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/FlowOperators.h"
#include "brickwall/core/model/Model.h"

#include <array>
#include <functional>
#include <string>
#include <vector>

namespace brickwall::oracles {

/// A velocity in world space that knows its own derivatives.
struct Flow
{
    std::string name;
    std::function<vec3d(const vec3d& world)> velocity;
    std::function<std::array<vec3d, 3>(const vec3d& world)> gradients; ///< of each component

    double value(FlowOperator op, const vec3d& world) const { return flowValue(op, gradients(world)); }
};

/// (sin x cos y cos z, -cos x sin y cos z, 0) (Taylor and Green 1937). Q lies in [-1, 1].
Flow taylorGreenFlow();

/// (A sin z + C cos y, B sin x + A cos z, C sin y + B cos x) with A = 1, B = 0.8, C = 0.6 (Arnold 1965).
Flow abcFlow();

/// A vortex along z, of core radius 1, that is stretched (Burgers 1948): rotation with a speed of
/// 2 (1 - exp(-r^2)) / r at the distance r, inflow 0.1 r, outflow 0.2 z.
Flow burgersVortex();

/// All three.
std::vector<Flow> flows();

/// (-y, x, 0): circles, and no error inside of a level.
Flow solidRotation();

/// A model of these bricks (their `begin` is set here) with the fields "u", "v", "w": the velocity at cells' centres.
Model modelOf(std::vector<Brick> bricks, const Flow& flow, const mat4d& worldFromVoxel);

} // namespace brickwall::oracles
