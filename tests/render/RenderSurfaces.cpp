// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Depth, shading, triangles, and what a renderer refuses.
#include "brickwall/core/base/Error.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brickwall {
namespace {

using namespace test;

float windowDepth(const View& view, const vec3d& p)
{
    return float(0.5 + 0.5 * transformPoint(view.clipFromWorld, p).z);
}

TransferFunction constant(float sigma)
{
    return extinctionRamp({0.0f, 1.0f}, sigma, sigma);
}

struct Cube
{
    std::vector<Brick> bricks = cubeOfBricks(vec3i(0), 16, 8);
    Field field = fieldOf(bricks, [](const vec3d&) { return 0.5; });
};

TEST(RenderDepth, OfAnOpaqueBoxIsThatOfItsFrontFace)
{
    const Cube cube;
    const View view = lookAlong({-4, 7.25, 8.5}, 0, 1.0);
    const Frame frame = renderOne(sceneOf(cube.bricks, cube.field, constant(200.0f)), view, settingsOf(0.5f));
    EXPECT_NEAR(frame.color[0].a, 1.0, 1e-6);
    // The mean free path, 1 / 200, lies beyond the face at -1/2.
    EXPECT_NEAR(frame.depth[0], windowDepth(view, {-0.5 + 0.005, 7.25, 8.5}), 1e-6);
}

TEST(RenderDepth, OfFogIsItsOpacityWeightedMean)
{
    const Cube cube;
    const View view = lookAlong({-4, 7.25, 8.5}, 0, 1.0);
    for (const double sigma : {0.001, 0.05, 0.7}) {
        const Frame frame = renderOne(sceneOf(cube.bricks, cube.field, constant(float(sigma))), view, settingsOf(0.5f));
        const double depth = sigma * 17.0, mean = 17.0 * (1.0 / depth - std::exp(-depth) / (1.0 - std::exp(-depth)));
        EXPECT_NEAR(frame.depth[0], windowDepth(view, {-0.5 + mean, 7.25, 8.5}), 1e-6) << sigma;
    }
}

TEST(RenderDepth, IsExactlyOneWhereNothingWasHit)
{
    const Cube cube;
    const View view = lookAt({-30, 8, 8}, {8, 8, 8}, 32, 8, 120.0);
    const Frame frame = renderOne(sceneOf(cube.bricks, cube.field, constant(0.1f)), view, settingsOf(0.5f));
    EXPECT_EQ(frame.depth[frame.index(0, 4)], 1.0f);
    EXPECT_EQ(frame.color[frame.index(0, 4)], vec4f(0.0f));
    EXPECT_LT(frame.depth[frame.index(16, 4)], 1.0f);
    const Frame clear = renderOne(sceneOf(cube.bricks, cube.field, constant(0.0f)), view, settingsOf(0.5f));
    EXPECT_EQ(clear.depth, std::vector<float>(clear.depth.size(), 1.0f));
}

TEST(RenderShading, IsTheCosineInWorldSpaceForStretchedAndShearedCells)
{
    const auto bricks = cubeOfBricks(vec3i(0), 16, 16);
    const vec3d g(0.3, -0.2, 0.5);
    const Field field = fieldOf(bricks, [&](const vec3d& p) { return glm::dot(g, p); });
    const mat4d m(vec4d(1.0, 0.2, 0.0, 0.0), vec4d(0.0, 2.0, 0.3, 0.0), vec4d(0.1, 0.0, 3.0, 0.0), vec4d(5, 6, 7, 1));
    const vec3d eye = transformPoint(m, {7, 8, 9}); // inside, where the field is affine as far as the fog can be seen
    const View view = lookAt(eye, transformPoint(m, {9, 3, 10}), 9, 9, 70.0);
    const Frame frame = renderOne(sceneOf(bricks, field, extinctionRamp(field.range, 9.0f, 9.0f), m), view,
                                  settingsOf(0.5f, Shading::headlight));
    const vec3d worldGradient = glm::transpose(glm::inverse(glm::dmat3(m))) * g;
    for (int y = 0; y < 9; ++y)
        for (int x = 0; x < 9; ++x) {
            const vec3d dir = rayDirection(view, x, y);
            const double cosine =
                std::abs(glm::dot(dir, worldGradient)) / glm::length(dir) / glm::length(worldGradient);
            const vec4f c = frame.color[frame.index(x, y)];
            EXPECT_NEAR(c.r / c.a, cosine, 1e-4);
        }
}

TEST(RenderTriangles, EndRaysAndAreSeenThroughWhatIsLeft)
{
    const Cube cube;
    const std::vector<TriangleMesh> meshes{{{{6, -50, -50}, {6, 50, -50}, {6, 0, 90}}, {{0, 1, 2}}}};
    Scene scene = sceneOf(cube.bricks, cube.field, constant(0.1f));
    scene.triangles = std::make_shared<TriangleScene>(meshes);
    const View view = lookAlong({-4, 7.25, 8.5}, 0, 1.0);
    const Frame frame = renderOne(scene, view, settingsOf(0.5f));
    const double through = std::exp(-0.1 * 6.5), depth = 0.65;
    EXPECT_NEAR(frame.color[0].r, (1.0 - through) + through * 0.8, 1e-5);
    EXPECT_NEAR(frame.color[0].a, 1.0, 1e-6);
    const double mean = 6.5 * (1.0 / depth - through / (1.0 - through));
    const double x = (1.0 - through) * (-0.5 + mean) + through * 6.0;
    EXPECT_NEAR(frame.depth[0], windowDepth(view, {x, 7.25, 8.5}), 1e-6);
}

TEST(RenderTriangles, BesideAndInFrontOfTheDataAreOpaque)
{
    const Cube cube;
    const std::vector<TriangleMesh> meshes{{{{-2, -50, -50}, {-2, 50, -50}, {-2, 0, 90}}, {{0, 1, 2}}}};
    Scene scene = sceneOf(cube.bricks, cube.field, constant(0.1f));
    scene.triangles = std::make_shared<TriangleScene>(meshes);
    for (const vec3d eye : {vec3d(-4, 7.25, 8.5), vec3d(-4, 25, 8.5)}) {
        const View view = lookAlong(eye, 0, 1.0);
        const Frame frame = renderOne(scene, view, settingsOf(0.5f));
        EXPECT_NEAR(frame.color[0].g, 0.8, 1e-6);
        EXPECT_NEAR(frame.depth[0], windowDepth(view, {-2, eye.y, 8.5}), 1e-6);
    }
}

TEST(RenderTermination, EndsRaysEarlyAndKeepsWhatTheyHave)
{
    const Cube cube;
    const Scene scene = sceneOf(cube.bricks, cube.field, constant(0.5f));
    const View view = lookAlong({-4, 7.25, 8.5}, 0, 1.0);
    RenderSettings settings = settingsOf(0.5f);
    settings.step.terminationOpacity = 0.9f;
    const Executor serial(1);
    Progress silent;
    std::vector<ViewStatistics> early, late;
    const Renderer renderer(scene, serial);
    const Frame frame = renderer.render({&view, 1}, settings, silent, &early).front();
    renderer.render({&view, 1}, settingsOf(0.5f), silent, &late);
    EXPECT_GE(frame.color[0].a, 0.9f);
    EXPECT_LT(frame.color[0].a, 1.0f - 0.1f * std::exp(-0.26f));
    EXPECT_LT(2 * early[0].counts.samples, late[0].counts.samples);
    EXPECT_GE(late[0].counts.samples, 34u); // 17 voxels in steps of 1/2, and a little more at faces
    EXPECT_LE(late[0].counts.samples, 42u);
}

TEST(RenderRefusal, NamesWhatIsWrong)
{
    const Cube cube;
    const Executor serial(1);
    Progress silent;
    const Scene scene = sceneOf(cube.bricks, cube.field, constant(0.5f));
    const Renderer renderer(scene, serial);
    const View view = lookAlong({-4, 7.25, 8.5}, 0, 1.0);
    for (const float dt : {0.0f, -1.0f, 1e-9f, std::nanf("")})
        EXPECT_THROW(renderer.render({&view, 1}, settingsOf(dt), silent), Error) << dt;
    View behind = view;
    behind.eye.x += 5.0;
    EXPECT_THROW(renderer.render({&behind, 1}, settingsOf(0.5f), silent), Error);
    View empty = view;
    empty.window.width = 0;
    EXPECT_THROW(renderer.render({&empty, 1}, settingsOf(0.5f), silent), Error);

    EXPECT_THROW(renderOne(scene, lookAlong({-1e15, 7, 8}, 0, 1.0), settingsOf(0.5f)), Error);
    Scene flat = scene;
    flat.worldFromVoxel[2][2] = 0.0;
    EXPECT_THROW(renderOne(flat, view, settingsOf(0.5f)), Error);

    Scene mismatched = scene;
    mismatched.field = std::make_shared<PaddedField>();
    EXPECT_THROW(Renderer(mismatched, serial), Error);
    EXPECT_THROW(Renderer(Scene{}, serial), Error);
}

TEST(RenderRefusal, StopsWhenCancelled)
{
    const Cube cube;
    const Executor two(2);
    Progress progress;
    progress.cancel();
    const View view = lookAlong({-4, 7.25, 8.5}, 0, 1.0);
    const Renderer renderer(sceneOf(cube.bricks, cube.field, constant(0.5f)), two);
    EXPECT_THROW(renderer.render({&view, 1}, settingsOf(0.5f), progress), Cancelled);
}

} // namespace
} // namespace brickwall
