// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/FrameLevers.h"
#include "brickwall/core/render/Renderer.h"

#include <span>
#include <vector>

namespace brickwall {

/// The levers of a renderer with these settings, whose values are the finest: the tolerance of bounded, dt of the
/// methods that take steps, and the image's scale.
LeverTable leversOf(const RenderSettings& settings);

/// The settings, as accurate as the levers say.
RenderSettings withLevers(RenderSettings settings, const FrameLevers& levers);

/// The view with fewer pixels: the same eye and exactly the same part of the screen in `eighths` / 8 as many columns
/// and rows, rounded, at least one; row 0 at the bottom. It has no pixels outside of its window, of which its screen
/// now consists. Of a scene's depth each pixel has the nearest one of those that it covers: what is drawn over the
/// scene is never hidden by it. Throws Error as checkSceneDepth does.
View scaledView(const View& view, int eighths);

/// All of them; what a renderer is asked for at these levers.
std::vector<View> scaledViews(std::span<const View> views, const FrameLevers& levers);

/// Pixels of all views: what a frame's work grows with.
double pixelsOf(std::span<const View> views);

} // namespace brickwall
