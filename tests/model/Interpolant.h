// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Regions.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace brickwall {

/// The trilinear interpolant of one brick's padded values: what a single-brick region promises to be B.
inline double trilinear(const vec3d& p, const PaddedBrick& b, std::span<const float> padded)
{
    vec3i i0;
    vec3d f;
    for (int a = 0; a < 3; ++a) {
        const double q = (p[a] - 2.0 * b.lower[a]) / (2.0 * b.cellWidth()) - 0.5;
        i0[a] = std::min(std::max(int(std::floor(q)), -1), b.size[a] - 1);
        f[a] = q - i0[a];
    }
    const vec3i n = b.paddedSize();
    double sum = 0.0;
    for (int corner = 0; corner < 8; ++corner) {
        const vec3i o(corner & 1, corner >> 1 & 1, corner >> 2);
        const vec3i c = i0 + o + 1;
        double weight = 1.0;
        for (int a = 0; a < 3; ++a)
            weight *= o[a] ? f[a] : 1.0 - f[a];
        sum += weight * padded[b.begin + std::size_t(c.x) + std::size_t(n.x) * (c.y + std::size_t(n.y) * c.z)];
    }
    return sum;
}

/// Where a brick's tents reach, in half voxels.
inline Box3d supportBox(const Brick& b)
{
    const double h = b.cellWidth();
    return {2.0 * vec3d(b.lower) - h, 2.0 * vec3d(b.box().upper) + h};
}

} // namespace brickwall
