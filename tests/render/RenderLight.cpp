// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// A light far away: what reaches the volume, surfaces and triangles through volume, surfaces and triangles.
#include "brickwall/core/base/Error.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace brickwall {
namespace {

using namespace test;

constexpr float ambient = 0.25f;
constexpr double sigma = 0.08;
/// A cube of 16 voxels; what can be seen of it reaches half a voxel further.
constexpr double lower = -0.5, upper = 16.5, width = upper - lower;

/// White, with the same extinction everywhere, or none.
Scene constantBox(double extinction)
{
    const auto bricks = cubeOfBricks(vec3i(0), 16, 8);
    return sceneOf(bricks, fieldOf(bricks, [](const vec3d&) { return 0.5; }),
                   extinctionRamp({0.0f, 1.0f}, float(extinction), float(extinction)));
}

std::shared_ptr<const TriangleScene> quad(const vec3f& corner, const vec3f& u, const vec3f& v)
{
    const TriangleMesh mesh{{corner, corner + u, corner + u + v, corner + v}, {{0, 1, 2}, {0, 2, 3}}};
    return std::make_shared<TriangleScene>(std::span(&mesh, 1));
}

/// What is left of colour whose light has come through so much extinction.
double lit(double opticalDepth)
{
    return ambient + (1.0 - ambient) * std::exp(-opticalDepth);
}

class LightFor : public testing::TestWithParam<Method>
{
protected:
    static RenderSettings settings(const vec3d& towards)
    {
        RenderSettings settings = settingsOf(0.125f);
        settings.method = GetParam();
        settings.bounded.tolerance = 1e-5f;
        settings.light = Light{towards, ambient, 1e-3f};
        return settings;
    }
    /// A Riemann sum is off by up to a step at either end of a ray, and so is what it knows of light.
    static double error() { return GetParam() == Method::fixed ? 2.5 * sigma * 0.125 : 1.1e-3; }
};

TEST_P(LightFor, AcrossTheRayIsDimmedByWhatIsAbove)
{
    const Scene scene = constantBox(sigma);
    const double alpha = 1.0 - std::exp(-sigma * width);
    for (const double height : {0.25, 5.5, 11.75, 16.0}) {
        const Frame frame = renderOne(scene, lookAlong({-20.0, height, 7.25}, 0, 1.0), settings({0, 3, 0}));
        EXPECT_NEAR(frame.color[0].g, alpha * lit(sigma * (upper - height)), error()) << height;
        EXPECT_NEAR(frame.color[0].a, alpha, error()) << "light has no part in opacity";
    }
}

TEST_P(LightFor, FromBehindTheEyeIsDimmedByWhatTheRayHasPassed)
{
    const Frame frame = renderOne(constantBox(sigma), lookAlong({-20.0, 5.25, 7.25}, 0, 1.0), settings({-1, 0, 0}));
    const double once = 1.0 - std::exp(-sigma * width), twice = 1.0 - std::exp(-2.0 * sigma * width);
    EXPECT_NEAR(frame.color[0].r, ambient * once + (1.0 - ambient) * 0.5 * twice, error());
}

TEST_P(LightFor, TheShadowOfATriangleHasItsEdgeWhereTheTriangleHas)
{
    for (const bool drawn : {true, false})
        for (const double edge : {3.0, 8.3}) {
            Scene scene = constantBox(sigma);
            auto& triangles = drawn ? scene.triangles : scene.occluders;
            triangles = quad({float(edge), 17.0f, -5.0f}, {30, 0, 0}, {0, 0, 30});
            const Frame frame = renderOne(scene, lookAlong({-20.0, 6.0, 7.25}, 0, 1.0), settings({0, 1, 0}));
            const double through = std::exp(-sigma * (edge - lower)), end = std::exp(-sigma * width);
            const double want = (1.0 - through) * lit(sigma * (upper - 6.0)) + (through - end) * ambient;
            EXPECT_NEAR(frame.color[0].b, want, error()) << edge << (drawn ? " drawn" : " drawn elsewhere");
        }
}

TEST_P(LightFor, ASurfaceHasTheCosineAndTheTransmittanceOfWhatIsBetween)
{
    // B = x: a plane that faces the eye, behind a faint volume, and a translucent sheet above.
    const auto bricks = cubeOfBricks(vec3i(0), 16, 8);
    Scene scene = sceneOf(bricks, fieldOf(bricks, [](const vec3d& p) { return p.x; }),
                          extinctionRamp({0.0f, 16.0f}, float(sigma), float(sigma)));
    scene.transferFunction.colors = {{0.0f, vec3f(0.0f)}}; // only the surface has a colour
    scene.surfaces = {{9.0f, {1.0f, 0.5f, 0.0f}, 1.0f}};
    const vec3d towards = glm::normalize(vec3d(-2.0, 1.0, 0.0));
    const Frame frame = renderOne(scene, lookAlong({-20.0, 6.0, 7.25}, 0, 1.0), settings(towards));
    const double toSurface = 9.0 - lower, toLight = (9.0 - lower) / -towards.x;
    const double shade = ambient + (1.0 - ambient) * -towards.x * std::exp(-sigma * toLight);
    EXPECT_NEAR(frame.color[0].r, std::exp(-sigma * toSurface) * shade, error());
    EXPECT_NEAR(frame.color[0].g, 0.5 * std::exp(-sigma * toSurface) * shade, error());
}

TEST_P(LightFor, FromTheOtherSideOfASurfaceLeavesWhatIsAmbient)
{
    const auto bricks = cubeOfBricks(vec3i(0), 16, 8);
    Scene scene =
        sceneOf(bricks, fieldOf(bricks, [](const vec3d& p) { return p.x; }), extinctionRamp({0.0f, 16.0f}, 0.0f, 0.0f));
    scene.surfaces = {{9.0f, {1.0f, 0.5f, 0.0f}, 1.0f}};
    const Frame frame = renderOne(scene, lookAlong({-20.0, 6.0, 7.25}, 0, 1.0), settings({1.0, 0.2, 0.0}));
    EXPECT_FLOAT_EQ(frame.color[0].r, ambient);
}

TEST_P(LightFor, ATranslucentSurfaceTakesItsOpacityFromTheLight)
{
    // B = y: the surface lies across the way of the light, and beside that of the rays.
    const auto bricks = cubeOfBricks(vec3i(0), 16, 8);
    Scene scene = sceneOf(bricks, fieldOf(bricks, [](const vec3d& p) { return p.y; }),
                          extinctionRamp({0.0f, 16.0f}, float(sigma), float(sigma)));
    scene.surfaces = {{12.0f, {1.0f, 1.0f, 1.0f}, 0.6f}};
    const double alpha = 1.0 - std::exp(-sigma * width);
    for (const double height : {6.0, 14.0}) {
        const Frame frame = renderOne(scene, lookAlong({-20.0, height, 7.25}, 0, 1.0), settings({0, 1, 0}));
        const double below = height < 12.0 ? 0.4 : 1.0;
        const double remains = ambient + (1.0 - ambient) * below * std::exp(-sigma * (upper - height));
        EXPECT_NEAR(frame.color[0].r, alpha * remains, error()) << height;
    }
}

TEST_P(LightFor, ATriangleBelowTheVolumeLiesInItsShadow)
{
    Scene scene = constantBox(sigma);
    scene.triangles = quad({-30, -4, -30}, {60, 0, 0}, {0, 0, 60});
    // Past the volume, onto the floor below it; and onto the floor beside it, where no ray sees data.
    const Frame below = renderOne(scene, lookAt({8.0, -3.0, -25.0}, {8.0, -4.0, 8.0}, 1, 1), settings({0, 1, 0}));
    const Frame beside = renderOne(scene, lookAt({25.0, 9.0, 8.0}, {25.0, -4.0, 8.001}, 1, 1), settings({0, 1, 0}));
    EXPECT_NEAR(below.color[0].r, 0.8 * lit(sigma * width), error());
    EXPECT_NEAR(beside.color[0].r, 0.8, 1e-5);
}

INSTANTIATE_TEST_SUITE_P(Methods, LightFor,
                         testing::Values(Method::bounded, Method::fixed, Method::midpoint, Method::bracket,
                                         Method::preintegrated, Method::reference),
                         [](const auto& info) { return methodNames[std::size_t(info.param)]; });

RenderSettings boundedSettings()
{
    RenderSettings settings;
    settings.shading = Shading::off;
    settings.light = Light{{0.3, 1.0, -0.4}, ambient};
    return settings;
}

TEST(Light, ASmoothSurfaceHasNoSpotsOfItsOwnShadow)
{
    // A ball across levels, lit from the eye: nothing that the eye sees lies in the shadow of the rest.
    for (const unsigned seed : {1u, 7u}) {
        const auto bricks = threeLevels(seed);
        Scene scene = sceneOf(bricks, fieldOf(bricks, [](const vec3d& p) { return glm::length(p - vec3d(16.0)); }),
                              extinctionRamp({0.0f, 28.0f}, 0.0f, 0.0f));
        scene.surfaces = {{11.0f, {1.0f, 1.0f, 1.0f}, 1.0f}};
        RenderSettings settings = boundedSettings();
        const vec3d eye(-300.0, 40.0, 90.0);
        settings.light->towards = eye - vec3d(16.0);
        const Frame lit = renderOne(scene, lookAt(eye, vec3d(16.0), 64, 64, 5.0), settings);
        settings.light.reset();
        settings.shading = Shading::headlight;
        const Frame head = renderOne(scene, lookAt(eye, vec3d(16.0), 64, 64, 5.0), settings);
        int seen = 0;
        for (std::size_t i = 0; i < lit.color.size(); ++i) {
            // At its rim the light, which is parallel, is not quite the ray.
            if (lit.color[i].a < 1.0f || head.color[i].r < 0.15f)
                continue;
            ++seen;
            ASSERT_NEAR(lit.color[i].r, ambient + (1.0f - ambient) * head.color[i].r, 0.04) << i;
        }
        EXPECT_GT(seen, 1000);
    }
}

/// Three levels, two surfaces, a triangle that is drawn and one that is not.
Scene crowded()
{
    const auto bricks = threeLevels(5);
    Scene scene = sceneOf(bricks, fieldOf(bricks, waves), colorful({-1.0f, 1.0f}));
    scene.surfaces = {{-0.3f, {1, 0.5f, 0}, 0.4f}, {0.6f, {0, 0.4f, 1}, 1.0f}};
    scene.triangles = quad({5, 25, 5}, {10, 1, 2}, {3, -4, 10});
    scene.occluders = quad({20, 8, 10}, {6, 1, 2}, {3, -4, 10});
    return scene;
}

TEST(Light, BoundedKeepsItsToleranceAndThatOfTheLight)
{
    const View view = lookAt({-30.0, 30.0, -25.0}, vec3d(16.0), 20, 18);
    RenderSettings settings = boundedSettings();
    settings.method = Method::reference;
    settings.light->tolerance = 2e-3f;
    const Frame want = renderOne(crowded(), view, settings);
    settings.method = Method::bounded;
    for (const float tolerance : {1.0f / 255.0f, 1.0f / 64.0f}) {
        settings.bounded.tolerance = settings.light->tolerance = tolerance;
        const Frame found = renderOne(crowded(), view, settings);
        int beyond = 0;
        for (std::size_t i = 0; i < want.color.size(); ++i)
            for (int c = 0; c < 4; ++c)
                beyond += std::abs(want.color[i][c] - found.color[i][c]) > 2.0f * tolerance + 2e-3f;
        EXPECT_LE(beyond, 2) << tolerance << ": rays past the edge of something opaque";
    }
}

TEST(Light, DoesNotChangeOpacityAndDepth)
{
    const View view = lookAt({-30.0, 30.0, -25.0}, vec3d(16.0), 40, 36);
    RenderSettings settings = boundedSettings();
    const Frame with = renderOne(crowded(), view, settings);
    settings.light.reset();
    const Frame without = renderOne(crowded(), view, settings);
    for (std::size_t i = 0; i < with.color.size(); ++i) {
        ASSERT_NEAR(with.color[i].a, without.color[i].a, 2.0 / 255.0) << i;
        ASSERT_NEAR(with.depth[i], without.depth[i], 1e-3) << i;
        ASSERT_LE(with.color[i].g, without.color[i].g + 2.0f / 255.0f) << "a shadow does not add light";
    }
}

TEST(Light, OutsideItsLimitsIsRefused)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (const Light& light :
         {Light{{0, 0, 0}}, Light{{nan, 0, 1}}, Light{{0, 1, 0}, -0.1f}, Light{{0, 1, 0}, 1.5f},
          Light{{0, 1, 0}, 0.2f, 0.0f}, Light{{0, 1, 0}, 0.2f, std::numeric_limits<float>::quiet_NaN()}}) {
        RenderSettings settings;
        settings.light = light;
        EXPECT_THROW(renderOne(constantBox(sigma), lookAlong({-20, 6, 7}, 0, 1.0), settings), Error);
    }
}

TEST(Occluders, EndRaysAndAreNotDrawn)
{
    Scene elsewhere = crowded();
    elsewhere.occluders = elsewhere.triangles;
    elsewhere.triangles = nullptr;
    Scene here = crowded();
    here.occluders = nullptr;
    const View view = lookAt({-10.0, 60.0, -5.0}, {11, 25, 12}, 40, 36, 20.0);
    RenderSettings settings;
    settings.bounded.tolerance = 1e-4f;
    Scene alone = here;
    alone.surfaces.clear();
    alone.transferFunction = extinctionRamp({-1.0f, 1.0f}, 0.0f, 0.0f);
    const Frame want = renderOne(here, view, settings), drawn = renderOne(alone, view, settings);
    const Frame found = renderOne(elsewhere, view, settings);
    int on = 0;
    for (std::size_t i = 0; i < found.color.size(); ++i) {
        const vec4f over = found.color[i] + (1.0f - found.color[i].a) * drawn.color[i];
        for (int c = 0; c < 4; ++c)
            ASSERT_NEAR(over[c], want.color[i][c], 1e-5) << i << ' ' << c;
        if (drawn.color[i].a == 0.0f)
            continue;
        ++on;
        ASSERT_TRUE(found.depth[i] <= drawn.depth[i] || found.color[i].a == 0.0f) << i;
    }
    EXPECT_GT(on, 50);
}

} // namespace
} // namespace brickwall
