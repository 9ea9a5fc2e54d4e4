// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"

#include <cstdint>

namespace brickwall {

/// Gradient noise (Perlin, "Improving Noise", 2002) on the unit lattice, with directions from an integer hash instead
/// of a table. Within -1.1..1.1, mean 0, twice continuously differentiable. Only + - * and integers, so that it is the
/// same on every machine that does not contract them. Coordinates stay below 2^31.
double gradientNoise(const vec3d& p, std::uint32_t seed);

/// Three noises that know nothing of each other, for less than the price of three.
vec3d gradientNoise3(const vec3d& p, std::uint32_t seed);

/// 0 up to `from`, 1 beyond `to`, a cubic in between (from < to).
double smoothStep(double from, double to, double x);

/// 2^x from a polynomial (relative error below 1e-12), because the mathematical libraries of two machines differ in the
/// last bit. x in [-1000, 1000].
double portableExp2(double x);

inline double portableExp(double x)
{
    return portableExp2(x * 1.4426950408889634);
}

} // namespace brickwall
