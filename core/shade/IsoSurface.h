// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"

namespace brickwall {

/// The surface where a field has one value, seen from both sides.
struct IsoSurface
{
    float value = 0.0f;
    vec3f color{0.8f};    ///< linear RGB, not premultiplied, before shading
    float opacity = 1.0f; ///< in (0, 1]: what a ray loses that crosses it once
    /// Has the colours of the transfer function's colour field (TransferFunction.h) in place of `color`, if there is
    /// one.
    bool coloredByField = false;
};

} // namespace brickwall
