// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Box.h"

#include <array>

namespace brickwall {

/// The eight corners; bit 0, 1, 2 of the index: the upper side along x, y, z.
inline std::array<vec3d, 8> cornersOf(const Box3d& box)
{
    std::array<vec3d, 8> corners;
    for (int i = 0; i < 8; ++i)
        corners[i] = {i & 1 ? box.upper.x : box.lower.x, i & 2 ? box.upper.y : box.lower.y,
                      i & 4 ? box.upper.z : box.lower.z};
    return corners;
}

/// The box around the transformed corners.
inline Box3d boundsOfTransformed(const mat4d& m, const Box3d& box)
{
    Box3d bounds;
    for (const vec3d& corner : cornersOf(box))
        bounds.extend(transformPoint(m, corner));
    return bounds;
}

} // namespace brickwall
