// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/FrameWork.h"

#include <algorithm>
#include <vector>

namespace brickwall {
namespace {

constexpr int columns = 8, rows = 6;    ///< of rays
constexpr double regionsPerPixel = 3.0; ///< that a pixel without any costs as much as

/// The same eye and screen; all of the screen's part that the view shows, in few pixels.
View probeOf(const View& view)
{
    View probe = view;
    const PixelRect& w = view.window;
    const vec3d right = (view.lowerRight - view.lowerLeft) / double(view.screenWidth);
    const vec3d up = (view.upperRight - view.lowerRight) / double(view.screenHeight);
    probe.lowerLeft = view.lowerLeft + double(w.x) * right + double(w.y) * up;
    probe.lowerRight = probe.lowerLeft + double(w.width) * right;
    probe.upperRight = probe.lowerRight + double(w.height) * up;
    probe.screenWidth = std::min(columns, w.width);
    probe.screenHeight = std::min(rows, w.height);
    probe.window = {0, 0, probe.screenWidth, probe.screenHeight};
    probe.sceneDepth = nullptr;
    return probe;
}

} // namespace

double workOf(const Renderer& renderer, std::span<const View> views, Progress& progress)
{
    RenderSettings cheapest;
    cheapest.bounded.tolerance = 1.0f;
    cheapest.shading = Shading::off;
    std::vector<View> probes;
    for (const View& view : views)
        probes.push_back(probeOf(view));
    std::vector<ViewStatistics> statistics;
    renderer.render(probes, cheapest, progress, &statistics);
    double work = 0.0;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const double regions = double(statistics[i].counts.regionsVisited) / double(statistics[i].rays);
        work += double(views[i].window.width) * views[i].window.height * (regionsPerPixel + regions);
    }
    return work;
}

} // namespace brickwall
