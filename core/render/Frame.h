// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"
#include "brickwall/core/render/View.h"

#include <cstddef>
#include <vector>

namespace brickwall {

/// Colour and depth of one view, with the view they were made for. Row 0 is the bottom row.
struct Frame
{
    View view;
    int width = 0;
    int height = 0;
    std::vector<vec4f> color; ///< linear, premultiplied RGBA, width * height; the background is not in it
    /// Window depth in [0, 1] by the view's own matrices; exactly 1 where nothing was hit. For semi-transparent pixels
    /// the opacity-weighted mean distance.
    std::vector<float> depth;

    std::size_t index(int x, int y) const { return std::size_t(y) * width + x; }
};

/// Nothing is to be seen in it.
Frame emptyFrame(const View& view);

} // namespace brickwall
