// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/Accumulation.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace brickwall {
namespace {

constexpr double plastic = 1.32471795724474602596; ///< the root of x^3 = x + 1

bool sameView(const View& a, const View& b)
{
    return a.name == b.name && a.eye == b.eye && a.lowerLeft == b.lowerLeft && a.lowerRight == b.lowerRight &&
           a.upperRight == b.upperRight && a.screenWidth == b.screenWidth && a.screenHeight == b.screenHeight &&
           a.window == b.window && a.clipFromWorld == b.clipFromWorld && a.sceneDepth == b.sceneDepth;
}

/// `frame` becomes the newest of `count` frames.
void average(const Frame& frame, int count, Frame& mean)
{
    const float share = 1.0f / static_cast<float>(count);
    for (std::size_t i = 0; i < mean.color.size(); ++i) {
        mean.color[i] += share * (frame.color[i] - mean.color[i]);
        if (mean.depth[i] == 1.0f)
            mean.depth[i] = frame.depth[i];
    }
}

} // namespace

PixelOffset pixelOffset(int n)
{
    const int pair = (n + 1) / 2;
    const double side = n % 2 == 1 ? 1.0 : -1.0;
    const auto part = [&](double step) {
        const double x = 0.5 + pair * step;
        return side * (x - std::floor(x) - 0.5);
    };
    return {part(1.0 / plastic), part(1.0 / (plastic * plastic))};
}

View movedByPixels(const View& view, const PixelOffset& offset)
{
    const vec3d right = (view.lowerRight - view.lowerLeft) / double(view.screenWidth);
    const vec3d up = (view.upperRight - view.lowerRight) / double(view.screenHeight);
    View moved = view;
    for (vec3d* corner : {&moved.lowerLeft, &moved.lowerRight, &moved.upperRight})
        *corner += offset.x * right + offset.y * up;
    return moved;
}

std::vector<View> Accumulation::next(std::span<const View> views)
{
    if (!std::equal(views.begin(), views.end(), views_.begin(), views_.end(), sameView)) {
        restart();
        views_.assign(views.begin(), views.end());
    }
    std::vector<View> moved;
    for (const View& view : views_)
        moved.push_back(count_ == 0 ? view : movedByPixels(view, pixelOffset(count_)));
    return moved;
}

std::vector<Frame> Accumulation::add(std::vector<Frame> frames)
{
    ++count_;
    if (count_ == 1) {
        means_ = std::move(frames);
        return means_;
    }
    for (std::size_t i = 0; i < frames.size(); ++i)
        average(frames[i], count_, means_[i]);
    return means_;
}

void Accumulation::restart()
{
    views_.clear();
    means_.clear();
    count_ = 0;
}

} // namespace brickwall
