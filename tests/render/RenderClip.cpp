// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// What is cut away by planes, box and sphere, and planes on which the field is shown.
#include "brickwall/core/base/Error.h"
#include "brickwall/core/trace/SamplePoints.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace brickwall {
namespace {

using namespace test;

constexpr double sigma = 0.08;

Scene constantBox()
{
    const auto bricks = cubeOfBricks(vec3i(0), 16, 8);
    return sceneOf(bricks, fieldOf(bricks, [](const vec3d&) { return 0.5; }),
                   extinctionRamp({0.0f, 1.0f}, float(sigma), float(sigma)));
}

class ClipFor : public testing::TestWithParam<Method>
{
protected:
    static RenderSettings settings()
    {
        RenderSettings settings = settingsOf(0.125f);
        settings.method = GetParam();
        settings.bounded.tolerance = 1e-5f;
        return settings;
    }
    static double error() { return GetParam() == Method::fixed ? 2.0 * sigma * 0.125 : 2e-5; }
};

TEST_P(ClipFor, LeavesTheOpacityOfWhatIsInside)
{
    // Along x at y = 6, z = 7: the length that is left.
    const std::vector<std::pair<ClipRegion, double>> rows = {
        {{{{{1, 0, 0}, 4.25}}, {}, {}}, 12.25},
        {{{{{-2, 0, 0}, -20.0}}, {}, {}}, 10.5},
        {{{{{1, 0, 0}, 4.0}, {{-1, 0, 0}, -9.0}}, {}, {}}, 5.0},
        {{{{{1, 1, 0}, 10.0}}, {}, {}}, 12.5},
        {{{{{0, 1, 0}, 6.5}}, {}, {}}, 0.0},
        {{{{{0, 1, 0}, 5.5}}, {}, {}}, 17.0},
        {{{}, Box3d{vec3d(2.0, 0.0, 0.0), vec3d(7.5, 16.0, 16.0)}, {}}, 5.5},
        {{{}, Box3d{vec3d(2.0, 6.5, 0.0), vec3d(7.5, 16.0, 16.0)}, {}}, 0.0},
        {{{}, {}, Sphere{{8.0, 6.0, 11.0}, 5.0}}, 6.0},
        {{{}, {}, Sphere{{8.0, 6.0, 13.0}, 5.0}}, 0.0},
        {{{{{1, 0, 0}, 8.0}}, Box3d{vec3d(2.0, 0.0, 0.0), vec3d(10.0, 16.0, 16.0)}, Sphere{{8.0, 6.0, 11.0}, 5.0}},
         2.0}};
    for (std::size_t i = 0; i < rows.size(); ++i) {
        Scene scene = constantBox();
        scene.clip = rows[i].first;
        const Frame frame = renderOne(scene, lookAlong({-20.0, 6.0, 7.0}, 0, 1.0), settings());
        EXPECT_NEAR(frame.color[0].a, 1.0 - std::exp(-sigma * rows[i].second), error()) << "row " << i;
    }
}

TEST_P(ClipFor, CutsSurfacesToo)
{
    const auto bricks = cubeOfBricks(vec3i(0), 16, 8);
    Scene scene =
        sceneOf(bricks, fieldOf(bricks, [](const vec3d& p) { return p.x; }), extinctionRamp({0.0f, 16.0f}, 0.0f, 0.0f));
    scene.surfaces = {{4.0f, {1, 0, 0}, 1.0f}, {9.0f, {0, 1, 0}, 1.0f}};
    scene.clip.planes = {{{1, 0, 0}, 5.0}};
    const Frame frame = renderOne(scene, lookAlong({-20.0, 6.0, 7.0}, 0, 1.0), settings());
    EXPECT_EQ(frame.color[0], vec4f(0, 1, 0, 1));
}

TEST_P(ClipFor, AContourPlaneHasTheColourOfTheFieldThere)
{
    const auto bricks = threeLevels(3);
    const Field field = fieldOf(bricks, waves);
    Scene scene = sceneOf(bricks, field, extinctionRamp({-1.0f, 1.0f}, 0.0f, 0.0f));
    scene.transferFunction.colors = colorful({-1.0f, 1.0f}).colors;
    scene.planes = {{{{0.2, 0.4, 1.0}, 25.0}, 1.0f}};
    const View view = lookAt({10.0, 20.0, -30.0}, vec3d(16.0), 24, 20);
    const Frame frame = renderOne(scene, view, settings());
    int on = 0;
    for (int y = 0; y < 20; ++y)
        for (int x = 0; x < 24; ++x) {
            const vec3d along = rayDirection(view, x, y), normal = scene.planes[0].plane.normal;
            const vec3d at = view.eye + (25.0 - glm::dot(normal, view.eye)) / glm::dot(normal, along) * along;
            PointSample sample;
            samplePoints(*scene.regions, *scene.field, mat4d(1.0), {&at, 1}, {&sample, 1}, Executor(1));
            const vec4f& found = frame.color[frame.index(x, y)];
            ASSERT_EQ(found.a, sample.valid ? 1.0f : 0.0f) << x << ' ' << y;
            if (!sample.valid)
                continue;
            ++on;
            const vec3d want = colorAt(scene.transferFunction, sample.value);
            for (int c = 0; c < 3; ++c)
                ASSERT_NEAR(found[c], want[c], 1e-4) << x << ' ' << y;
            const vec3d ndc = transformPoint(view.clipFromWorld, at);
            ASSERT_NEAR(frame.depth[frame.index(x, y)], 0.5 * ndc.z + 0.5, 1e-5);
        }
    EXPECT_GT(on, 150);
}

TEST_P(ClipFor, AContourPlaneOnAClipPlaneHasNoHoles)
{
    // Rounding had thrown half of its pixels out.
    Scene scene = constantBox();
    const Plane plane{{0.2, 0.4, 1.0}, 9.3};
    scene.planes = {{plane, 1.0f}};
    const View view = lookAt({9.0, 10.0, -30.0}, vec3d(8.0), 16, 16, 10.0);
    const Frame whole = renderOne(scene, view, settings());
    for (const double side : {1.0, -1.0}) {
        scene.clip.planes = {{side * plane.normal, side * plane.offset}};
        const Frame cut = renderOne(scene, view, settings());
        for (std::size_t i = 0; i < cut.color.size(); ++i)
            ASSERT_EQ(cut.color[i].a, whole.color[i].a) << i;
    }
}

TEST_P(ClipFor, PlanesAreCompositedInOrderWithVolumeAndSurfaces)
{
    const auto bricks = cubeOfBricks(vec3i(0), 16, 8);
    Scene scene = sceneOf(bricks, fieldOf(bricks, [](const vec3d& p) { return p.x; }),
                          extinctionRamp({0.0f, 16.0f}, float(sigma), float(sigma)));
    scene.transferFunction.colors = {{0.0f, {0, 0, 1}}};
    scene.surfaces = {{9.0f, {0, 1, 0}, 1.0f}};
    scene.planes = {{{{1, 0, 0}, 12.0}, 1.0f}, {{{-1, 0, 0}, -5.0}, 0.25f}}; // one is hidden by the surface
    const Frame frame = renderOne(scene, lookAlong({-20.0, 6.0, 7.0}, 0, 1.0), settings());
    const double toPlane = std::exp(-sigma * 5.5), toSurface = 0.75 * std::exp(-sigma * 9.5);
    EXPECT_NEAR(frame.color[0].g, toSurface, error());
    EXPECT_NEAR(frame.color[0].b, (1.0 - toPlane) + 0.25 * toPlane + (0.75 * toPlane - toSurface), error());
    EXPECT_EQ(frame.color[0].a, 1.0f);
}

INSTANTIATE_TEST_SUITE_P(Methods, ClipFor,
                         testing::Values(Method::bounded, Method::fixed, Method::midpoint, Method::bracket,
                                         Method::preintegrated, Method::reference),
                         [](const auto& info) { return methodNames[std::size_t(info.param)]; });

TEST(Clip, IsInWorldSpace)
{
    Scene scene = constantBox();
    scene.worldFromVoxel = glm::scale(glm::translate(mat4d(1.0), vec3d(100.0, 0.0, 0.0)), vec3d(2.0));
    scene.clip.planes = {{{1, 0, 0}, 110.0}}; // x = 5 in voxels
    RenderSettings settings = settingsOf(0.25f);
    settings.method = Method::reference;
    const Frame frame = renderOne(scene, lookAlong({50.0, 12.0, 14.0}, 0, 1.0), settings);
    EXPECT_NEAR(frame.color[0].a, 1.0 - std::exp(-sigma * 11.5), 1e-5);
}

TEST(Clip, WhatIsCutAwayCastsNoShadow)
{
    Scene scene = constantBox();
    scene.clip.planes = {{{0, -1, 0}, -8.0}}; // y <= 8
    RenderSettings settings = settingsOf(0.25f);
    settings.light = Light{{0, 1, 0}, 0.0f, 1e-4f};
    const Frame frame = renderOne(scene, lookAlong({-20.0, 6.0, 7.25}, 0, 1.0), settings);
    EXPECT_NEAR(frame.color[0].r, (1.0 - std::exp(-sigma * 17.0)) * std::exp(-sigma * 2.0), 2e-4);
}

TEST(Clip, OutsideItsLimitsIsRefused)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const std::vector<ClipRegion> bad = {{{{{0, 0, 0}, 1.0}}, {}, {}},
                                         {{{{1, 0, 0}, nan}}, {}, {}},
                                         {{}, Box3d{vec3d(1.0), vec3d(1.0)}, {}},
                                         {{}, Box3d{vec3d(nan), vec3d(1.0)}, {}},
                                         {{}, {}, Sphere{vec3d(0.0), 0.0}},
                                         {{}, {}, Sphere{vec3d(nan), 1.0}}};
    for (const ClipRegion& region : bad) {
        Scene scene = constantBox();
        scene.clip = region;
        EXPECT_THROW(Renderer(scene, Executor(1)), Error);
    }
    for (const ContourPlane& plane : {ContourPlane{{{0, 0, 0}, 1.0}, 1.0f}, ContourPlane{{{1, 0, 0}, 1.0}, 0.0f}}) {
        Scene scene = constantBox();
        scene.planes = {plane};
        EXPECT_THROW(Renderer(scene, Executor(1)), Error);
    }
}

} // namespace
} // namespace brickwall
