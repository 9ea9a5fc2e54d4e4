// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// White spots and ambient occlusion of isosurfaces and triangles, against closed forms.
#include "brickwall/core/base/Error.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace brickwall {
namespace {

using namespace test;

constexpr double farAway = std::numeric_limits<double>::infinity();

enum class Levels { one, three };

/// No volume can be seen of it. Of several levels for what is smooth, of one where a plane has to be one.
Scene surfacesOf(Levels levels, const VoxelFunction& value, std::vector<IsoSurface> surfaces,
                 const mat4d& worldFromVoxel = mat4d(1.0))
{
    const auto bricks = levels == Levels::three ? threeLevels(3) : cubeOfBricks(vec3i(0), 32, 8);
    Scene scene = sceneOf(bricks, fieldOf(bricks, value), extinctionRamp({0.0f, 32.0f}, 0.0f, 0.0f), worldFromVoxel);
    scene.surfaces = std::move(surfaces);
    return scene;
}

/// A plane x = 16 that a ray along x meets at a right angle.
Scene wallAcross(const vec3f& color)
{
    return surfacesOf(Levels::one, [](const vec3d& p) { return p.x; }, {{16.0f, color, 1.0f}});
}

const View ahead = lookAlong({-20.0, 15.25, 15.75}, 0, 1.0);

std::shared_ptr<const TriangleScene> triangles(const TriangleMesh& mesh)
{
    return std::make_shared<TriangleScene>(std::span(&mesh, 1));
}

/// Two triangles, as long in both directions.
TriangleMesh quad(const vec3f& corner, const vec3f& u, const vec3f& v)
{
    return {{corner, corner + u, corner + u + v, corner + v}, {{0, 1, 2}, {0, 2, 3}}};
}

RenderSettings lookOf(Shading shading, Specular specular, std::optional<AmbientOcclusion> occlusion = {})
{
    RenderSettings settings;
    settings.shading = shading;
    settings.specular = specular;
    settings.ambientOcclusion = occlusion;
    return settings;
}

class LookFor : public testing::TestWithParam<Method>
{
};

TEST_P(LookFor, TheSpotIsPhongsPowerOfTheMirroredLight)
{
    for (const double degrees : {0.0, 20.0, 40.0, 70.0}) {
        const double angle = degrees * std::numbers::pi / 180.0; // between the light and the normal, that is, the eye
        RenderSettings settings = lookOf(Shading::off, {0.5f, 8.0f});
        settings.method = GetParam();
        settings.light = Light{{-std::cos(angle), std::sin(angle), 0.0}, 0.25f};
        const Frame frame = renderOne(wallAcross({0.5f, 0.25f, 0.0f}), ahead, settings);
        const double spot = 0.5 * std::pow(std::cos(angle), 8.0), diffuse = 0.25 + 0.75 * std::cos(angle);
        EXPECT_NEAR(frame.color[0].r, std::min(1.0, 0.5 * diffuse + spot), 1e-5) << degrees;
        EXPECT_NEAR(frame.color[0].g, 0.25 * diffuse + spot, 1e-5) << degrees;
        EXPECT_NEAR(frame.color[0].b, spot, 1e-5) << degrees << ": white, whatever the colour";
        EXPECT_EQ(frame.color[0].a, 1.0f);
    }
}

TEST_P(LookFor, InACornerHalfOfTheDirectionsOfAWallAreClosed)
{
    // Right beside an endless floor, a half of what comes from everywhere comes from below it.
    Scene scene = wallAcross(vec3f(1.0f));
    scene.triangles = triangles(quad({-900, 15.25f, -900}, {1800, 0, 0}, {0, 0, 1800}));
    RenderSettings settings = lookOf(Shading::off, {}, AmbientOcclusion{farAway, 1024});
    settings.method = GetParam();
    const Frame frame = renderOne(scene, lookAlong({-20.0, 15.26, 15.75}, 0, 1.0), settings);
    EXPECT_NEAR(frame.color[0].r, 0.5, 0.02);
}

INSTANTIATE_TEST_SUITE_P(Methods, LookFor,
                         testing::Values(Method::bounded, Method::fixed, Method::midpoint, Method::bracket,
                                         Method::preintegrated, Method::reference),
                         [](const auto& info) { return methodNames[std::size_t(info.param)]; });

TEST(Specular, OfTheHeadlightFallsWithTwiceTheAngle)
{
    // B = x cos + y sin: the surface's normal is turned away from the ray.
    for (const double angle : {0.0, 0.2, 0.5}) {
        const vec3d normal(std::cos(angle), std::sin(angle), 0.0);
        const Scene scene =
            surfacesOf(Levels::one, [&](const vec3d& p) { return glm::dot(normal, p); }, {{14.0f, vec3f(0.0f), 1.0f}});
        const Frame frame = renderOne(scene, ahead, lookOf(Shading::headlight, {0.75f, 4.0f}));
        EXPECT_NEAR(frame.color[0].r, 0.75 * std::pow(std::cos(2.0 * angle), 4.0), 1e-4) << angle;
    }
}

TEST(Specular, IsNotSeenInTheShadowNorFromBehind)
{
    Scene scene = wallAcross(vec3f(0.0f));
    RenderSettings settings = lookOf(Shading::off, {1.0f, 2.0f});
    settings.light = Light{{-1.0, 0.1, 0.0}, 0.0f};
    EXPECT_GT(renderOne(scene, ahead, settings).color[0].r, 0.9f);
    settings.light->towards = {1.0, 0.1, 0.0};
    EXPECT_EQ(renderOne(scene, ahead, settings).color[0].r, 0.0f);
    settings.light->towards = {-1.0, 0.1, 0.0};
    scene.occluders = triangles(quad({-40, 10, -90}, {0, 30, 0}, {0, 0, 190}));
    EXPECT_EQ(renderOne(scene, ahead, settings).color[0].r, 0.0f);
}

TEST(Specular, OfATranslucentSurfaceIsAsTranslucent)
{
    Scene scene = wallAcross(vec3f(0.25f));
    scene.surfaces.front().opacity = 0.4f;
    const Frame frame = renderOne(scene, ahead, lookOf(Shading::headlight, {0.5f, 4.0f}));
    EXPECT_NEAR(frame.color[0].r, 0.4 * 0.75, 1e-5);
    EXPECT_NEAR(frame.color[0].a, 0.4, 1e-6);
}

TEST(Specular, OfATriangleIsAtTheSameAngleAsOfASurface)
{
    Scene scene = wallAcross(vec3f(1.0f));
    scene.surfaces.clear();
    scene.triangles = triangles(quad({3, -900, -900}, {0, 1800, 0}, {0, 0, 1800}));
    RenderSettings settings = lookOf(Shading::off, {});
    settings.light = Light{{-1.0, 0.5, 0.0}, 0.0f};
    const double cosine = 1.0 / std::sqrt(1.25);
    const double without = renderOne(scene, ahead, settings).color[0].r;
    settings.specular = {0.2f, 3.0f};
    EXPECT_NEAR(renderOne(scene, ahead, settings).color[0].r - without, 0.2 * std::pow(cosine, 3.0), 1e-5);
}

TEST(AmbientOcclusion, BelowABallIsTheSquareOfItsSine)
{
    // Where a ball's middle is straight above a floor, the part of the floor's cosine-weighted directions that it takes
    // is (radius / height)^2 (the form factor of a sphere).
    const vec3d middle(16.0, 16.0, 16.0);
    const double radius = 6.0, height = 10.0;
    Scene scene = surfacesOf(Levels::one, [&](const vec3d& p) { return glm::length(p - middle); },
                             {{float(radius), vec3f(1.0f), 1.0f}});
    const float floor = float(middle.y - height);
    scene.triangles = triangles(quad({-900, floor, -900}, {1800, 0, 0}, {0, 0, 1800}));
    const View view = lookAt({-14.0, 9.0, 16.0}, {16.0, floor, 16.0}, 1, 1);
    RenderSettings settings = lookOf(Shading::off, {});
    const double open = renderOne(scene, view, settings).color[0].r;
    settings.ambientOcclusion = AmbientOcclusion{farAway, 1024};
    const double expected = 1.0 - radius * radius / (height * height);
    EXPECT_NEAR(renderOne(scene, view, settings).color[0].r / open, expected, 0.015);

    scene.surfaces.front().opacity = 0.5f; // and a ray meets it twice
    EXPECT_NEAR(renderOne(scene, view, settings).color[0].r / open, 1.0 - 0.75 * (1.0 - expected), 0.015);

    settings.ambientOcclusion->distance = 3.9; // the ball begins at 4
    EXPECT_NEAR(renderOne(scene, view, settings).color[0].r, open, 1e-6);
}

TEST(AmbientOcclusion, HasItsDistanceInWorldSpace)
{
    const mat4d tenTimes(10.0, 0, 0, 0, 0, 10.0, 0, 0, 0, 0, 10.0, 0, 0, 0, 0, 1);
    Scene scene = surfacesOf(
        Levels::one, [](const vec3d& p) { return p.x; }, {{16.0f, vec3f(1.0f), 1.0f}}, tenTimes);
    scene.occluders = triangles(quad({100, 142.5, -9000}, {200, 0, 0}, {0, 0, 18000})); // a floor 10 below the ray
    const View view = lookAlong({-20.0, 152.5, 157.5}, 0, 1.0);
    for (const auto& [distance, closes] : {std::pair(9.5, false), std::pair(30.0, true)}) {
        const Frame frame = renderOne(scene, view, lookOf(Shading::off, {}, AmbientOcclusion{distance, 64}));
        EXPECT_EQ(frame.color[0].r < 0.99f, closes) << distance;
    }
}

TEST(AmbientOcclusion, DarkensOnlyTheAmbientPartOfALight)
{
    Scene scene = wallAcross(vec3f(1.0f));
    scene.triangles = triangles(quad({-900, 15.25f, -900}, {1800, 0, 0}, {0, 0, 1800}));
    const View view = lookAlong({-20.0, 15.26, 15.75}, 0, 1.0);
    RenderSettings settings = lookOf(Shading::off, {}, AmbientOcclusion{farAway, 1024});
    settings.light = Light{{-1.0, 0.0, 0.0}, 0.5f};
    EXPECT_NEAR(renderOne(scene, view, settings).color[0].r, 0.5 * 0.5 + 0.5, 0.01);
}

TEST(AmbientOcclusion, AFlatSurfaceAndABallFromOutsideAreNotInTheirOwnWay)
{
    const Scene ball = surfacesOf(Levels::three, [](const vec3d& p) { return glm::length(p - vec3d(16.0)); },
                                  {{9.0f, vec3f(1.0f), 1.0f}});
    const View view = lookAt({-40.0, 30.0, 5.0}, vec3d(16.0), 24, 24, 12.0);
    const Frame frame = renderOne(ball, view, lookOf(Shading::off, {}, AmbientOcclusion{farAway, 16}));
    double sum = 0.0;
    int pixels = 0;
    for (const vec4f& color : frame.color)
        if (color.a == 1.0f) {
            sum += color.r;
            ++pixels;
            // Between the cells of the coarsest level it has flat facets and kinks inwards.
            EXPECT_GE(color.r, 0.6f);
        }
    EXPECT_GT(pixels, 400);
    EXPECT_GT(sum / pixels, 0.97);
}

TEST(AmbientOcclusion, ErrsLessWithMoreRaysAndNotOnAverage)
{
    Scene scene = wallAcross(vec3f(1.0f));
    scene.triangles = triangles(quad({-900, 10.0f, -900}, {1800, 0, 0}, {0, 0, 1800}));
    const View view = lookAt({-20.0, 15.0, 15.75}, {16.0, 13.0, 15.75}, 24, 24, 2.0);
    const auto errorOf = [&](int rays) {
        const Frame truth = renderOne(scene, view, lookOf(Shading::off, {}, AmbientOcclusion{farAway, 1024}));
        const Frame frame = renderOne(scene, view, lookOf(Shading::off, {}, AmbientOcclusion{farAway, rays}));
        double squares = 0.0, sum = 0.0;
        for (std::size_t i = 0; i < frame.color.size(); ++i) {
            const double d = frame.color[i].r - truth.color[i].r;
            squares += d * d;
            sum += d;
        }
        const double n = double(frame.color.size());
        EXPECT_NEAR(sum / n, 0.0, 0.02) << rays;
        return std::sqrt(squares / n);
    };
    const double four = errorOf(4), sixteen = errorOf(16), sixtyFour = errorOf(64);
    EXPECT_LT(sixteen, 0.5 * four);
    EXPECT_LT(sixtyFour, 0.5 * sixteen);
}

TEST(SurfaceLook, OutsideItsLimitsIsRefused)
{
    const float nan = std::numeric_limits<float>::quiet_NaN();
    for (const Specular& specular :
         {Specular{-0.1f}, Specular{1.1f}, Specular{nan}, Specular{0.5f, 0.0f}, Specular{0.5f, nan}})
        EXPECT_THROW(renderOne(wallAcross(vec3f(1.0f)), ahead, lookOf(Shading::off, specular)), Error);
    for (const AmbientOcclusion& occlusion : {AmbientOcclusion{0.0}, AmbientOcclusion{-1.0}, AmbientOcclusion{nan},
                                              AmbientOcclusion{1.0, 0}, AmbientOcclusion{1.0, 1025}})
        EXPECT_THROW(renderOne(wallAcross(vec3f(1.0f)), ahead, lookOf(Shading::off, {}, occlusion)), Error);
}

} // namespace
} // namespace brickwall
