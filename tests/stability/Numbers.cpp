// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
// Values, coordinates and steps near the ends of what floats can hold.
#include "Exhibit.h"

#include "brickwall/tests/common/ErrorOf.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <fmt/format.h>

#include <limits>

namespace brickwall::test {
namespace {

View outside(const vec3d& at = vec3d(0.0))
{
    return lookAt(at + vec3d(-20.0, 40.0, 55.0), at + vec3d(16.0), 24, 24, 38.0);
}

Scene scaledWaves(double scale, const vec3i& lower = vec3i(0), const mat4d& worldFromVoxel = mat4d(1.0))
{
    const auto bricks = threeLevels(5, lower);
    const auto value = [&](const vec3d& p) { return scale * (1.5 + waves(p - vec3d(lower))); };
    return sceneOf(bricks, fieldOf(bricks, value), colorful({float(0.5 * scale), float(2.5 * scale)}), worldFromVoxel);
}

TEST(Stability, DensitiesOfAnyScale)
{
    for (const double scale : {1e-24, 1.0, 1e24, 1e30})
        for (const Shading shading : {Shading::off, Shading::headlight}) {
            const Errors e = show({fmt::format("densities of {:g}{}", scale, shading == Shading::off ? "" : ", lit"),
                                   scaledWaves(scale),
                                   {outside()},
                                   shading});
            EXPECT_GT(e.most, 0.9) << scale;
            EXPECT_LT(e.midpoint, 0.1) << scale;
        }
}

TEST(Stability, SurfacesInDensitiesOfAnyScale)
{
    for (const double scale : {1e-24, 1e24}) {
        Scene scene = scaledWaves(scale);
        scene.transferFunction.opacityScale = 0.0f;
        scene.surfaces = {{float(1.4 * scale), {0.9f, 0.6f, 0.3f}, 0.5f}};
        const Errors e =
            show({fmt::format("surface in densities of {:g}, lit", scale), scene, {outside()}, Shading::headlight});
        EXPECT_GT(e.most, 0.4) << scale;
    }
}

TEST(Stability, DenormalValues)
{
    const auto bricks = threeLevels(5);
    const double least = std::numeric_limits<float>::denorm_min();
    for (const double scale : {64.0 * least, 65536.0 * least})
        for (const Shading shading : {Shading::off, Shading::headlight}) {
            const auto value = [&](const vec3d& p) { return scale * (1.5 + waves(p)); };
            Exhibit exhibit{
                fmt::format("denormal values around {:.0e}{}", 1.5 * scale, shading == Shading::off ? "" : ", lit"),
                sceneOf(bricks, fieldOf(bricks, value), extinctionRamp({0.0f, 1.0f}, 0.05f, 0.2f)),
                {outside()},
                shading};
            // Few bits are left of such values, too few for a gradient.
            exhibit.keeps = shading == Shading::off;
            EXPECT_GT(show(exhibit).most, 0.5);
        }
}

TEST(Stability, FarFromTheOrigin)
{
    constexpr int far = 10000000;
    show({"1e7 cells from the origin", scaledWaves(1.0, vec3i(far, -far, far)), {outside(vec3d(far, -far, far))}});
    const vec3d shift(1e7, 2e7, -3e7);
    show({"worldFromVoxel shifts by 1e7",
          scaledWaves(1.0, vec3i(0), glm::translate(mat4d(1.0), shift)),
          {outside(shift)}});
}

TEST(Stability, FarFromTheEye)
{
    View view = viewOfCamera("far", {-6e5, 6e5, 5.3e5}, vec3d(16.0), {0, 1, 0}, 3.5e-3, 24, 24, 1.0, 1e7);
    const Errors e = show({"region boundaries at t = 1e6", scaledWaves(1.0), {view}});
    EXPECT_GT(e.most, 0.9);
    // The data's far end a million cells behind its near one: there t itself is 1e6 in floats.
    const auto bricks = numbered(oracles::oneLevelBricks(vec3i(0), {62500, 1, 1}, {64, 1, 1}, 4));
    const auto faint = [](const vec3d& p) { return p.x < 999000.0 ? 0.0 : 1.0 + 0.5 * std::sin(p.x / 40.0); };
    const Scene rod = sceneOf(bricks, fieldOf(bricks, faint), extinctionRamp({0.5f, 2.0f}, 1e-4f, 4e-3f));
    const Errors long_ =
        show({"a rod of a million cells, visible at its end",
              rod,
              {lookAlong({-20.0, 7.0, 9.0}, 0, 1.0),
               viewOfCamera("near it", {-20.0, 8.0, 8.0}, {1e6, 8.01, 7.99}, {0, 1, 0}, 5e-4, 3, 3, 1.0, 1e7)}});
    EXPECT_GT(long_.most, 0.3);
}

TEST(Stability, ConstantOverALevel)
{
    const auto bricks = threeLevels(5);
    for (const double constant : {0.5, 0.3}) {
        const auto value = [&](const vec3d&) { return constant; };
        Scene scene = sceneOf(bricks, fieldOf(bricks, value), colorful({0.0f, 1.0f}));
        const Errors e = show({fmt::format("a field of {} everywhere", constant), scene, {outside()}});
        EXPECT_LT(e.midpoint, 1e-3);
        scene.surfaces = {{float(constant), {0.9f, 0.6f, 0.3f}, 0.5f}};
        scene.transferFunction.opacityScale = 0.0f;
        show({fmt::format("the surface of {} in it", constant), scene, {outside()}});
    }
    const auto fine = [](const vec3d& p) { return p.x < 16.0 ? 0.5 : 0.5 + 0.5 * std::sin(p.y); };
    show({"a field of 0.5 over half the data",
          sceneOf(bricks, fieldOf(bricks, fine), colorful({0.0f, 1.0f})),
          {outside()}});
}

TEST(Stability, StepsOfNoLengthAreAnError)
{
    const Scene scene = scaledWaves(1.0);
    for (const Method method : {Method::fixed, Method::midpoint, Method::bracket, Method::preintegrated})
        for (const float dt :
             {0.0f, -1.0f, std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity(), 1e-30f})
            EXPECT_NE(errorOf([&] {
                          renderOne(scene, outside(), exhibitSettings(method, dt, Shading::off));
                      }).find("dt: expected a step of more than"),
                      std::string::npos);
    for (const float tolerance : {0.0f, -1.0f, 2.0f, std::numeric_limits<float>::quiet_NaN()})
        EXPECT_NE(errorOf([&] {
                      renderOne(scene, outside(), exhibitSettings(Method::bounded, tolerance, Shading::off));
                  }).find("tolerance: expected more than 0"),
                  std::string::npos);
}

TEST(Stability, StepsOfGreatLength)
{
    Exhibit exhibit{"dt = 1e9", scaledWaves(1.0), {outside()}};
    exhibit.dt = 1e9f;
    const Errors e = show(exhibit);
    EXPECT_GT(e.fixed, 0.1);
}

} // namespace
} // namespace brickwall::test
