// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/LeveredViews.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <memory>

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

TEST(LeveredViews, AViewOfOnePixelStaysOneAndOneWithTheDepthOfASceneIsLeftAsItIs)
{
    View view = tileOf(slanted(), {7, 5, 1, 1});
    EXPECT_EQ(scaledView(view, 1).window, (PixelRect{0, 0, 1, 1}));
    view = slanted();
    view.sceneDepth = std::make_shared<SceneDepth>();
    EXPECT_EQ(scaledView(view, 4).window, view.window);
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
