// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Box.h"

namespace brickwall::oracles {

/// Where a ray enters and leaves a box, as t along the direction that was given (any length); tFar <= tNear if it
/// misses. t starts at 0: what lies behind the origin does not count.
struct BoxRay
{
    double tNear, tFar;

    BoxRay(const Box3d& box, const vec3d& origin, const vec3d& direction);

    /// The length inside, in the units of `direction`'s space; 0 if the ray misses.
    double length(const vec3d& direction) const;
};

/// 1 - exp(-sigma d): the opacity of a way of length d through a constant extinction sigma, independent of brick cuts,
/// steps and levels. For a constant field, d is the ray's length inside the union of the supports.
double constantOpacity(double sigma, double length);

/// Premultiplied radiance of the same way, with emission of colour c per unit of opacity: c (1 - exp(-sigma d)).
vec3d constantRadiance(const vec3d& color, double sigma, double length);

/// The extinction of an opacity per reference length, -ln(1 - a) / length, for a < 1.
double extinctionOf(double opacity, double referenceLength);

} // namespace brickwall::oracles
