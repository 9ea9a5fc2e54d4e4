// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Progress.h"
#include "brickwall/core/render/Renderer.h"
#include "brickwall/core/render/View.h"

#include <span>

namespace brickwall {

/// What views have to do, before they are rendered: to be told to FrameTime, so that a frame that has more to do is no
/// surprise. Their pixels, each with the regions that its ray visits and a constant part, in an arbitrary unit. The
/// regions are those of 8 x 6 rays of each view, which the renderer traces at its largest tolerance: less than a
/// millisecond per view, and within some 5 % of what all rays visit (docs/decisions/0043). Depths of scenes, light and
/// averaged data are not asked.
///
/// Throws as Renderer::render does; from the thread that may call that.
double workOf(const Renderer& renderer, std::span<const View> views, Progress& progress);

} // namespace brickwall
