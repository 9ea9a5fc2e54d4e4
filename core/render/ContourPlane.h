// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/ClipRegion.h"

namespace brickwall {

/// A plane through the data on which the field's value is shown in the transfer function's colour, as exactly as the
/// field is reconstructed. It is not shaded: the colour is to be read. Values outside the transfer function's range
/// have the colour of its end; if the function's colours are of another field (TransferFunction.h), its values are
/// shown. Where there are no data there is no plane; it casts no shadow.
struct ContourPlane
{
    Plane plane;
    float opacity = 1.0f; ///< in (0, 1]

    bool operator==(const ContourPlane&) const = default;
};

} // namespace brickwall
