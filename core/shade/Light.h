// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"

namespace brickwall {

/// One white light, so far away that it comes from the same direction everywhere, and casts shadows.
///
/// Of a point's colour remains `ambient` + (1 - `ambient`) V, where V is the transmittance from there towards the
/// light: through the volume and isosurfaces, and 0 behind triangles. Isosurfaces and triangles have V times the cosine
/// between the normal on the viewer's side and the light (Lambert) instead of V. It comes on top of the volume's own
/// Shading, and takes its place on surfaces.
struct Light
{
    vec3d towards{0.0, 1.0, 0.0}; ///< where the light comes from, in world space; any length above 0
    float ambient = 0.2f;         ///< in [0, 1]: of the light, what comes from everywhere
    /// In (0, 1]: how wrong a component of a pixel may be because V is not known at every point of the volume. Of
    /// things with a sharp shadow that are smaller than a sixteenth of what a ray sees of the data, some may be missed.
    float tolerance = 1.0f / 64.0f;

    bool operator==(const Light&) const = default;
};

} // namespace brickwall
