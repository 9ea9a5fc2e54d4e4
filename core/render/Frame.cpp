// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/Frame.h"

namespace brickwall {

Frame emptyFrame(const View& view)
{
    Frame frame{view, view.window.width, view.window.height, {}, {}};
    const std::size_t pixels = std::size_t(frame.width) * frame.height;
    frame.color.resize(pixels, vec4f(0.0f));
    frame.depth.resize(pixels, 1.0f);
    return frame;
}

} // namespace brickwall
