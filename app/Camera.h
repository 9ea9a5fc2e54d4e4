// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Box.h"
#include "brickwall/core/render/View.h"

#include <string>
#include <vector>

namespace brickwall {

struct PixelSize
{
    int width = 0;
    int height = 0;
};

/// "WxH", each from 1 to 32768. Throws Error naming `option`.
PixelSize parsePixelSize(const std::string& text, const std::string& option);

/// All of the data from a little to the left and above, +y up: the distance at which the box just fits.
View overview(const Box3d& bounds, const PixelSize& size);

/// From inside the data along their x axis, a little downwards, with a wide angle.
View insideView(const Box3d& bounds, const PixelSize& size);

/// A pinhole camera from nine numbers (eye, at, up); near and far enclose the bounds.
View cameraView(const std::vector<double>& eyeAtUp, double fovDegrees, const Box3d& bounds, const PixelSize& size);

} // namespace brickwall
