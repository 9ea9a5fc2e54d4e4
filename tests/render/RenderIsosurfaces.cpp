// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Isosurfaces in pictures: in order with the volume and with triangles, whatever the method.
#include "brickwall/core/base/Error.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace brickwall {
namespace {

using namespace test;

constexpr double sigma = 0.05;

/// B = x over [0, 16], seen along +x from x = -4: what lies at x is x + 4 from the eye, the data begin at -1/2.
Scene rampWithSurfaces(std::vector<IsoSurface> surfaces)
{
    const auto bricks = cubeOfBricks(vec3i(0), 16, 8);
    Scene scene = sceneOf(bricks, fieldOf(bricks, [](const vec3d& p) { return p.x; }),
                          extinctionRamp({0.0f, 16.0f}, float(sigma), float(sigma)));
    scene.surfaces = std::move(surfaces);
    return scene;
}

RenderSettings settingsFor(int method)
{
    RenderSettings settings = settingsOf(0.25f);
    settings.method = static_cast<Method>(method);
    settings.bounded.tolerance = 1e-5f;
    return settings;
}

class IsosurfacesInVolume : public testing::TestWithParam<int>
{
};

TEST_P(IsosurfacesInVolume, AreCompositedInOrderWithWhatIsBetweenThem)
{
    // Given out of order; white fog before, between and behind.
    const Scene scene =
        rampWithSurfaces({{9.25f, {0, 1, 0}, 0.5f}, {4.75f, {1, 0, 0}, 0.25f}, {12.5f, {0, 0, 1}, 0.75f}});
    const View view = lookAlong({-4, 7.25, 8.5}, 0, 1.0);
    const Frame frame = renderOne(scene, view, settingsFor(GetParam()));

    const double at[] = {-0.5, 4.75, 9.25, 12.5, 16.5}, opacity[] = {0.25, 0.5, 0.75, 0.0};
    double through = 1.0;
    vec3d color(0.0);
    for (int i = 0; i < 4; ++i) {
        const double fog = 1.0 - std::exp(-sigma * (at[i + 1] - at[i]));
        color += through * fog * vec3d(1.0);
        through *= 1.0 - fog;
        if (i < 3)
            color[i] += through * opacity[i];
        through *= 1.0 - opacity[i];
    }
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(frame.color[0][c], color[c], 2e-6);
    EXPECT_NEAR(frame.color[0].a, 1.0 - through, 2e-6);
}

TEST_P(IsosurfacesInVolume, HideWhatIsBehindIfOpaque)
{
    const Scene scene = rampWithSurfaces({{4.75f, {1, 0, 0}, 1.0f}, {9.25f, {0, 1, 0}, 1.0f}});
    const Frame frame = renderOne(scene, lookAlong({-4, 7.25, 8.5}, 0, 1.0), settingsFor(GetParam()));
    const double fog = 1.0 - std::exp(-sigma * 5.25);
    EXPECT_NEAR(frame.color[0].r, 1.0, 2e-6);
    EXPECT_NEAR(frame.color[0].g, fog, 2e-6);
    EXPECT_EQ(frame.color[0].a, 1.0f);
}

TEST_P(IsosurfacesInVolume, AreMetFromBothSidesAndByAnEyeInside)
{
    const Scene scene = rampWithSurfaces({{4.75f, {1, 0, 0}, 1.0f}, {9.25f, {0, 1, 0}, 1.0f}});
    const Frame fromBehind = renderOne(scene, lookAlong({20, 7.25, 8.5}, 0, -1.0), settingsFor(GetParam()));
    EXPECT_NEAR(fromBehind.color[0].g, 1.0, 2e-6);
    const Frame inside = renderOne(scene, lookAlong({7, 7.25, 8.5}, 0, 1.0), settingsFor(GetParam()));
    EXPECT_NEAR(inside.color[0].g, 1.0, 2e-6);
    EXPECT_NEAR(inside.color[0].r, 1.0 - std::exp(-sigma * 2.25), 2e-6);
}

INSTANTIATE_TEST_SUITE_P(Methods, IsosurfacesInVolume, testing::Range(0, int(methodNames.size())),
                         [](const auto& info) { return methodNames[std::size_t(info.param)]; });

TEST(Isosurfaces, HaveTheDepthOfTheirPoint)
{
    Scene scene = rampWithSurfaces({{4.75f, {1, 0, 0}, 1.0f}});
    scene.transferFunction = extinctionRamp({0.0f, 16.0f}, 0.0f, 0.0f);
    const View view = lookAlong({-4, 7.25, 8.5}, 0, 1.0);
    const Frame frame = renderOne(scene, view, RenderSettings{});
    EXPECT_NEAR(frame.depth[0], 0.5 + 0.5 * transformPoint(view.clipFromWorld, {4.75, 7.25, 8.5}).z, 1e-7);
}

TEST(Isosurfaces, EndAtTriangles)
{
    Scene scene = rampWithSurfaces({{9.25f, {0, 1, 0}, 1.0f}});
    const std::vector<TriangleMesh> wall{{{{7, -20, -20}, {7, 40, -20}, {7, 10, 60}}, {{0, 1, 2}}}};
    scene.triangles = std::make_shared<TriangleScene>(wall);
    const View view = lookAlong({-4, 7.25, 8.5}, 0, 1.0);
    const Frame frame = renderOne(scene, view, RenderSettings{});
    EXPECT_NEAR(frame.depth[0], 0.5 + 0.5 * transformPoint(view.clipFromWorld, {7, 7.25, 8.5}).z, 0.01);
    EXPECT_NEAR(frame.color[0].r, frame.color[0].g, 1e-6) << "grey, not green";
}

TEST(Isosurfaces, ThatMakeNoSenseAreRefused)
{
    const Executor serial(1);
    for (const IsoSurface& wrong :
         {IsoSurface{std::numeric_limits<float>::quiet_NaN(), vec3f(1.0f), 1.0f}, IsoSurface{1.0f, vec3f(1.0f), 0.0f},
          IsoSurface{1.0f, vec3f(1.0f), 1.5f}, IsoSurface{1.0f, vec3f(2.0f), 1.0f}})
        EXPECT_THROW(Renderer(rampWithSurfaces({wrong}), serial), Error);
    RenderSettings settings;
    settings.bounded.tolerance = 0.0f;
    EXPECT_THROW(renderOne(rampWithSurfaces({}), lookAlong({-4, 7.25, 8.5}, 0, 1.0), settings), Error);
}

} // namespace
} // namespace brickwall
