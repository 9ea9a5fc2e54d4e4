// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/oracles/ReferenceIntegral.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/geometric.hpp>

namespace brickwall::oracles {

BoxRay::BoxRay(const Box3d& box, const vec3d& origin, const vec3d& direction)
    : tNear(0.0), tFar(std::numeric_limits<double>::infinity())
{
    for (int axis = 0; axis < 3; ++axis) {
        if (direction[axis] == 0.0) {
            if (origin[axis] < box.lower[axis] || origin[axis] > box.upper[axis])
                tFar = -1.0;
            continue;
        }
        const double a = (box.lower[axis] - origin[axis]) / direction[axis];
        const double b = (box.upper[axis] - origin[axis]) / direction[axis];
        tNear = std::max(tNear, std::min(a, b));
        tFar = std::min(tFar, std::max(a, b));
    }
}

double BoxRay::length(const vec3d& direction) const
{
    return std::max(0.0, tFar - tNear) * glm::length(direction);
}

double constantOpacity(double sigma, double length)
{
    return -std::expm1(-sigma * length);
}

vec3d constantRadiance(const vec3d& color, double sigma, double length)
{
    return constantOpacity(sigma, length) * color;
}

double extinctionOf(double opacity, double referenceLength)
{
    return -std::log1p(-opacity) / referenceLength;
}

} // namespace brickwall::oracles
