// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/LeveredViews.h"

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace brickwall {
namespace {

/// Makes the clip space of the window from that of the screen.
mat4d windowFromScreen(const View& view)
{
    const PixelRect& w = view.window;
    const vec3d scale(double(view.screenWidth) / w.width, double(view.screenHeight) / w.height, 1.0);
    const vec3d center((2.0 * w.x + w.width) / view.screenWidth - 1.0, (2.0 * w.y + w.height) / view.screenHeight - 1.0,
                       0.0);
    return glm::scale(mat4d(1.0), scale) * glm::translate(mat4d(1.0), -center);
}

/// Of those of the window's `from` pixels that pixel i of `to` covers, the first; in whole or in part.
int firstOf(int i, int from, int to)
{
    return int(std::int64_t(i) * from / to);
}

int endOf(int i, int from, int to)
{
    return int((std::int64_t(i + 1) * from + to - 1) / to);
}

/// The depth of the view's scene for fewer pixels of its window, `to`; null without one.
std::shared_ptr<const SceneDepth> nearestDepths(const View& view, const PixelRect& to)
{
    if (!view.sceneDepth)
        return nullptr;
    checkSceneDepth(view);
    const SceneDepth& scene = *view.sceneDepth;
    const PixelRect& w = view.window;
    auto result = std::make_shared<SceneDepth>(SceneDepth{to, {}});
    result->depth.reserve(std::size_t(to.width) * to.height);
    std::vector<float> nearest; // of the rows that a row covers
    for (int row = 0; row < to.height; ++row) {
        nearest.assign(std::size_t(w.width), 1.0f);
        for (int y = firstOf(row, w.height, to.height); y < endOf(row, w.height, to.height); ++y) {
            const float* depths =
                &scene.depth[std::size_t(w.y - scene.window.y + y) * scene.window.width + (w.x - scene.window.x)];
            for (int x = 0; x < w.width; ++x)
                nearest[x] = std::min(nearest[x], depths[x]);
        }
        for (int column = 0; column < to.width; ++column)
            result->depth.push_back(*std::min_element(nearest.begin() + firstOf(column, w.width, to.width),
                                                      nearest.begin() + endOf(column, w.width, to.width)));
    }
    return result;
}

int scaled(int pixels, int eighths)
{
    return std::max(1, int(std::lround(pixels * eighths / 8.0)));
}

} // namespace

LeverTable leversOf(const RenderSettings& settings)
{
    if (settings.method == Method::bounded)
        return leversForTolerance(settings.bounded.tolerance);
    LeverTable table = leversForDt(settings.step.dt);
    if (settings.method == Method::reference)
        table.erase(table.begin());
    return table;
}

RenderSettings withLevers(RenderSettings settings, const FrameLevers& levers)
{
    settings.bounded.tolerance = static_cast<float>(levers.tolerance);
    settings.step.dt = static_cast<float>(levers.dt);
    return settings;
}

View scaledView(const View& view, int eighths)
{
    if (eighths >= 8 || view.window.width <= 0 || view.window.height <= 0)
        return view;
    const vec3d right = view.lowerRight - view.lowerLeft, up = view.upperRight - view.lowerRight;
    const auto at = [&](int x, int y) {
        return view.lowerLeft + right * (double(x) / view.screenWidth) + up * (double(y) / view.screenHeight);
    };
    const PixelRect& w = view.window;
    View result = view;
    result.lowerLeft = at(w.x, w.y);
    result.lowerRight = at(w.x + w.width, w.y);
    result.upperRight = at(w.x + w.width, w.y + w.height);
    result.clipFromWorld = windowFromScreen(view) * view.clipFromWorld;
    result.screenWidth = scaled(w.width, eighths);
    result.screenHeight = scaled(w.height, eighths);
    result.window = {0, 0, result.screenWidth, result.screenHeight};
    result.sceneDepth = nearestDepths(view, result.window);
    return result;
}

std::vector<View> scaledViews(std::span<const View> views, const FrameLevers& levers)
{
    std::vector<View> result;
    for (const View& view : views)
        result.push_back(scaledView(view, levers.imageEighths));
    return result;
}

double pixelsOf(std::span<const View> views)
{
    double pixels = 0.0;
    for (const View& view : views)
        pixels += double(view.window.width) * view.window.height;
    return pixels;
}

} // namespace brickwall
