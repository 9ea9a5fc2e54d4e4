// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cmath>
#include <concepts>

namespace brickwall {

/// sRGB transfer curve (IEC 61966-2-1), both ways, per component in [0, 1]; whoever has more clamps first.
template <std::floating_point T>
T linearFromSrgb(T s)
{
    return s <= T(0.04045) ? s / T(12.92) : std::pow((s + T(0.055)) / T(1.055), T(2.4));
}

template <std::floating_point T>
T srgbFromLinear(T l)
{
    return l <= T(0.0031308) ? l * T(12.92) : T(1.055) * std::pow(l, T(1) / T(2.4)) - T(0.055);
}

} // namespace brickwall
