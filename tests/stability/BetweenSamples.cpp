// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
// What lies between samples, and what samples lie on the edge of.
#include "Exhibit.h"

#include <gtest/gtest.h>

namespace brickwall::test {
namespace {

std::vector<Brick> cube16()
{
    return cubeOfBricks(vec3i(0), 16, 8);
}

View outside(int pixels = 24)
{
    return lookAt({-14.0, 21.0, 29.0}, vec3d(8.0), pixels, pixels, 38.0);
}

Scene sceneWith(const VoxelFunction& value, const TransferFunction& tf)
{
    const auto bricks = cube16();
    return sceneOf(bricks, fieldOf(bricks, value), tf);
}

/// The Q criterion of a straight vortex with a core of 5 cells: above 0 in the core.
double vortexQ(const vec3d& p)
{
    const double r2 = ((p.x - 8.3) * (p.x - 8.3) + (p.y - 7.6) * (p.y - 7.6)) / 25.0;
    return (1.0 - r2) * std::exp(-r2);
}

TEST(Stability, ThinShellOfAVortex)
{
    const Errors e = show({"thin shell around a vortex (Q = 0.3 +- 0.0005)",
                           sceneWith(vortexQ, spike({-0.2f, 1.0f}, 0.3f, 1e-3f, 600.0f)),
                           {outside()}});
    EXPECT_GT(e.most, 0.3);
    EXPECT_GT(e.midpoint, 0.1);
    EXPECT_GT(e.fixed, 0.1);
    EXPECT_GT(e.bracket, 0.1);
}

TEST(Stability, SpikeNarrowerThanAStep)
{
    const auto ramp = [](const vec3d& p) { return p.x + 0.3 * p.y; };
    const Errors e = show({"transfer-function spike of 1/100 of a cell",
                           sceneWith(ramp, spike({0.0f, 22.0f}, 9.13f, 0.01f, 150.0f)),
                           {outside()}});
    EXPECT_GT(e.most, 0.4);
    EXPECT_GT(e.midpoint, 0.1);
    EXPECT_GT(e.bracket, 0.1); // whose search ends at its own depth, and its sample in a triangle
}

TEST(Stability, SpikeLit)
{
    const auto ball = [](const vec3d& p) { return glm::distance(p, vec3d(8.2, 7.9, 8.4)); };
    Exhibit exhibit{
        "the same around a ball, lit", sceneWith(ball, spike({0.0f, 16.0f}, 5.01f, 0.02f, 80.0f)), {outside()}};
    exhibit.shading = Shading::headlight;
    const Errors e = show(exhibit);
    EXPECT_GT(e.midpoint, 0.1);
}

TEST(Stability, TangentShell)
{
    // Along a diagonal of a layer the saddle is a parabola, whose vertex the shell lies at.
    const auto saddle = [](const vec3d& p) { return (p.x - 8.0) * (p.y - 8.0); };
    const Errors e = show({"shell that rays touch (vertex of a saddle)",
                           sceneWith(saddle, spike({-64.0f, 64.0f}, 0.0f, 0.01f, 40.0f)),
                           {lookAt({-6.0, 22.0, 8.1}, {8.0, 8.0, 8.0}, 24, 24, 30.0)}});
    EXPECT_GT(e.midpoint, 0.1);
    EXPECT_GT(e.preintegrated, 0.1);
}

TEST(Stability, TangentSurface)
{
    // Cells of 0 .. 3 .. 0 along x: a ray along x through their centres touches the surface of 3 in one point.
    const auto tent = [](const vec3d& p) { return 3.0 - std::abs(p.x - 8.5) + 0.25 * std::abs(p.y - 8.5); };
    Scene scene = sceneWith(tent, extinctionRamp({-8.0f, 8.0f}, 0.0f, 0.0f));
    scene.surfaces = {{3.0f, {0.9f, 0.6f, 0.3f}, 0.75f}};
    const View along = lookAlong({-4.0, 8.5, 7.3}, 0, 1.0);
    const Frame touched = renderOne(scene, along, exhibitSettings(Method::bounded, 1e-3f, Shading::off));
    EXPECT_EQ(touched.color[0].a, 0.75f); // once, and not twice
    show({"surface that a ray touches", scene, {along, outside()}});
    show({"surfaces of a ball at its silhouette",
          [&] {
              Scene ball = sceneWith([](const vec3d& p) { return glm::distance(p, vec3d(8.2, 7.9, 8.4)); },
                                     extinctionRamp({0.0f, 16.0f}, 0.0f, 0.02f));
              ball.surfaces = {{5.0f, {0.9f, 0.6f, 0.3f}, 0.5f}, {5.01f, {0.2f, 0.4f, 0.9f}, 0.5f}};
              return ball;
          }(),
          {outside()},
          Shading::headlight});
}

TEST(Stability, OpacityOne)
{
    TransferFunction tf;
    tf.range = {-1.0f, 1.0f};
    tf.opacity = {{0.0f, 0.0f}, {0.55f, 0.0f}, {0.55f, 1.0f}, {1.0f, 1.0f}};
    tf.colors = {{0.5f, {1.0f, 0.1f, 0.0f}}, {0.7f, {0.0f, 0.2f, 1.0f}}};
    const Errors e = show({"opacity 1 behind a step", sceneWith(waves, tf), {outside()}});
    EXPECT_GT(e.most, 0.99);
    EXPECT_GT(e.midpoint, 0.05);
}

TEST(Stability, StepOfTwoDistantValues)
{
    // A shock: values jump by the whole range from one cell to the next, and the window between is crossed within
    // 1/100 of a cell.
    const auto shock = [](const vec3d& p) { return p.x + 0.2 * p.z < 9.0 ? 0.0 : 100.0; };
    const Errors e = show({"shock over one cell, window of 1/100 of it",
                           sceneWith(shock, spike({0.0f, 100.0f}, 37.0f, 1.0f, 150.0f)),
                           {outside()}});
    EXPECT_GT(e.midpoint, 0.1);
}

} // namespace
} // namespace brickwall::test
