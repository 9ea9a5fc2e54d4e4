// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/LeveredViews.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/base/SplitMix.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <vector>

namespace brickwall::test {
namespace {

/// Off-axis, slanted, with odd numbers of pixels.
View slanted()
{
    return viewOfScreen("slanted", {0.3, -0.2, 2.0}, {-1.0, -0.7, 0.1}, {1.1, -0.6, -0.2}, {1.0, 0.9, -0.1}, 101, 67,
                        0.1, 100.0);
}

vec3d windowPoint(const View& view, const vec3d& world)
{
    const glm::dvec4 clip = view.clipFromWorld * glm::dvec4(world, 1.0);
    return vec3d(clip) / clip.w;
}

TEST(LeveredViews, FewerPixelsShowTheSamePartOfTheScreenUpright)
{
    for (const View& view : {slanted(), tileOf(slanted(), {30, 12, 43, 29})})
        for (int eighths = 1; eighths <= 8; ++eighths) {
            const View scaled = scaledView(view, eighths);
            EXPECT_NEAR(scaled.window.width, view.window.width * eighths / 8.0, 0.5);
            EXPECT_NEAR(scaled.window.height, view.window.height * eighths / 8.0, 0.5);
            const PixelRect &a = view.window, &b = scaled.window;
            for (const double u : {0.0, 0.25, 0.6, 1.0})
                for (const double v : {0.0, 0.3, 1.0}) {
                    const vec3d full = rayDirection(view, a.x + u * a.width - 0.5, a.y + v * a.height - 0.5);
                    const vec3d fewer = rayDirection(scaled, b.x + u * b.width - 0.5, b.y + v * b.height - 0.5);
                    EXPECT_LE(glm::length(full - fewer), 1e-12) << eighths << "/8 at " << u << ", " << v;
                    // Where the window's own clip space has that point, whose depth has not changed.
                    const vec3d seen = windowPoint(scaled, view.eye + 1.7 * full);
                    if (eighths < 8) {
                        EXPECT_NEAR(seen.x, 2.0 * u - 1.0, 1e-9);
                        EXPECT_NEAR(seen.y, 2.0 * v - 1.0, 1e-9);
                    }
                    EXPECT_NEAR(seen.z, windowPoint(view, view.eye + 1.7 * full).z, 1e-9);
                }
        }
}

TEST(LeveredViews, AViewOfOnePixelStaysOne)
{
    const View view = tileOf(slanted(), {7, 5, 1, 1});
    EXPECT_EQ(scaledView(view, 1).window, (PixelRect{0, 0, 1, 1}));
}

// What is drawn over a scene may not be hidden by a part of it that is nearer than the middle of a larger pixel.
TEST(LeveredViews, OfASceneEachPixelHasTheNearestDepthThatItCovers)
{
    View view = tileOf(slanted(), {30, 12, 43, 29});
    const PixelRect &w = view.window, depthWindow{25, 10, 50, 40};
    SceneDepth scene{depthWindow, {}};
    for (int i = 0; i < depthWindow.width * depthWindow.height; ++i)
        scene.depth.push_back(i % 3 == 0 ? 1.0f : std::ldexp(float(splitMix(std::uint64_t(i)) >> 44), -20));
    view.sceneDepth = std::make_shared<SceneDepth>(scene);
    const auto overlap = [](int pixel, int pixels, int coarse, int coarsePixels) {
        return pixel * coarsePixels < (coarse + 1) * pixels && (pixel + 1) * coarsePixels > coarse * pixels;
    };
    for (int eighths = 1; eighths < 8; ++eighths) {
        const View scaled = scaledView(view, eighths);
        const PixelRect& s = scaled.window;
        ASSERT_EQ(scaled.sceneDepth->window, s);
        std::vector<float> nearest(std::size_t(s.width) * s.height, 1.0f);
        for (int y = 0; y < w.height; ++y)
            for (int x = 0; x < w.width; ++x)
                for (int i = 0; i < int(nearest.size()); ++i)
                    if (overlap(x, w.width, i % s.width, s.width) && overlap(y, w.height, i / s.width, s.height))
                        nearest[i] = std::min(
                            nearest[i],
                            scene.depth[(w.y + y - depthWindow.y) * depthWindow.width + w.x + x - depthWindow.x]);
        EXPECT_EQ(scaled.sceneDepth->depth, nearest) << eighths << "/8";
    }
    EXPECT_EQ(scaledView(view, 8).sceneDepth, view.sceneDepth);
    view.sceneDepth = std::make_shared<SceneDepth>();
    EXPECT_THROW(scaledView(view, 4), Error);
}

TEST(LeveredViews, EachMethodHasItsOwnLevers)
{
    RenderSettings settings;
    settings.bounded.tolerance = 0.01f;
    ASSERT_EQ(leversOf(settings).size(), 2u);
    EXPECT_EQ(leversOf(settings)[0].lever, Lever::tolerance);
    EXPECT_FLOAT_EQ(float(leversOf(settings)[0].finest), 0.01f);
    settings.method = Method::midpoint;
    settings.step.dt = 0.25f;
    EXPECT_EQ(leversOf(settings)[0].lever, Lever::dt);
    EXPECT_EQ(leversOf(settings)[0].finest, 0.25);
    settings.method = Method::reference;
    ASSERT_EQ(leversOf(settings).size(), 1u);
    EXPECT_EQ(leversOf(settings)[0].lever, Lever::imageScale);

    FrameLevers levers;
    levers.tolerance = 0.05;
    levers.dt = 2.0;
    EXPECT_FLOAT_EQ(withLevers(settings, levers).bounded.tolerance, 0.05f);
    EXPECT_FLOAT_EQ(withLevers(settings, levers).step.dt, 2.0f);
}

} // namespace
} // namespace brickwall::test
