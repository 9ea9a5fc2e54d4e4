// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/RigLayout.h"

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

struct Placement
{
    double scale;
    int x;
    int y;
};

Placement placementOf(const Window& window, const WindowSize& size)
{
    const double scale = std::min(double(size.width) / window.width, double(size.height) / window.height);
    return {scale, (size.width - int(std::lround(window.width * scale))) / 2,
            (size.height - int(std::lround(window.height * scale))) / 2};
}

/// Edges are rounded, not sizes, so that neighbours stay neighbours.
PixelRect scaled(const PixelRect& rect, double scale)
{
    const auto edge = [scale](int value) { return int(std::lround(value * scale)); };
    const PixelRect result{edge(rect.x), edge(rect.y), edge(rect.x + rect.width) - edge(rect.x),
                           edge(rect.y + rect.height) - edge(rect.y)};
    return {result.x, result.y, std::max(result.width, 1), std::max(result.height, 1)};
}

void scalePart(Rig& rig, Channel& channel, double scale)
{
    Screen screen = rig.screens[channel.screen];
    if (scale == 1.0 || screen.pixelWidth == 0)
        return;
    const PixelRect whole = scaled({0, 0, screen.pixelWidth, screen.pixelHeight}, scale);
    screen.pixelWidth = whole.width;
    screen.pixelHeight = whole.height;
    if (channel.part.width > 0)
        channel.part = scaled(channel.part, scale);
    channel.screen = int(rig.screens.size());
    rig.screens.push_back(screen);
}

} // namespace

Rig layoutOf(const Rig& rig, std::span<const WindowSize> sizes)
{
    Rig result = rig;
    for (Channel& channel : result.channels) {
        const Placement place = placementOf(rig.windows[channel.window], sizes[channel.window]);
        channel.viewport = scaled(channel.viewport, place.scale);
        channel.viewport.x += place.x;
        channel.viewport.y += place.y;
        scalePart(result, channel, place.scale);
        if (channel.fixedViewer) {
            result.viewers.push_back(rig.viewers[channel.viewer]);
            channel.viewer = int(result.viewers.size()) - 1;
        }
    }
    for (std::size_t i = 0; i < result.windows.size(); ++i) {
        result.windows[i].width = sizes[i].width;
        result.windows[i].height = sizes[i].height;
    }
    return result;
}

std::vector<WindowSize> windowSizes(const Rig& rig, double factor)
{
    std::vector<WindowSize> sizes;
    for (const Window& window : rig.windows)
        sizes.push_back({std::max(1, int(std::lround(window.width * factor))),
                         std::max(1, int(std::lround(window.height * factor)))});
    return sizes;
}

} // namespace brickwall
