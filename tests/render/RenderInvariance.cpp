// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// What must not change a picture, mostly to the bit.
#include "brickwall/core/render/RayTiles.h"
#include "brickwall/core/simd/Target.h"
#include "brickwall/core/trace/VisibleNodes.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace brickwall {
namespace {

using namespace test;

class RenderInvariance : public testing::Test
{
protected:
    std::vector<Brick> bricks = threeLevels(5);
    Field field = fieldOf(bricks, waves);
    Scene scene = sceneOf(bricks, field, colorful({-1.0f, 1.0f}));
    View view = lookAt({-25, 40, -30}, {16, 15, 18}, 53, 37, 50.0);
    RenderSettings settings = settingsOf(0.5f, Shading::headlight);
};

void expectSameBits(const Frame& a, const Frame& b)
{
    EXPECT_EQ(a.color, b.color);
    EXPECT_EQ(a.depth, b.depth);
}

TEST_F(RenderInvariance, TilesHaveTheBitsOfTheWhole)
{
    const Frame whole = renderOne(scene, view, settings);
    for (const PixelRect rect : {PixelRect{0, 0, 53, 1}, {7, 3, 17, 19}, {52, 36, 1, 1}, {21, 5, 32, 32}}) {
        const Frame tile = renderOne(scene, tileOf(view, rect), settings);
        ASSERT_EQ(tile.width, rect.width);
        ASSERT_EQ(tile.height, rect.height);
        for (int y = 0; y < rect.height; ++y)
            for (int x = 0; x < rect.width; ++x) {
                ASSERT_EQ(tile.color[tile.index(x, y)], whole.color[whole.index(rect.x + x, rect.y + y)]);
                ASSERT_EQ(tile.depth[tile.index(x, y)], whole.depth[whole.index(rect.x + x, rect.y + y)]);
            }
    }
}

TEST_F(RenderInvariance, AHostThatMirrorsGetsTheMirroredPicture)
{
    // A negative scale in a host's modelview turns the corners round; that was refused as an eye behind its screen.
    settings.step.interleave = false;
    const vec3d eye{-25, 40, -30};
    const mat4d modelview = glm::lookAt(eye, vec3d{16, 15, 18}, vec3d{0, 1, 0});
    const mat4d projection = glm::perspective(0.9, 53.0 / 37.0, 1.0, 200.0);
    const mat4d mirror = glm::scale(mat4d(1.0), vec3d(-1, 1, 1));
    const Frame plain = renderOne(scene, viewOfMatrices("plain", modelview, projection, 53, 37), settings);
    const Frame mirrored =
        renderOne(scene, viewOfMatrices("mirrored", mirror * modelview, projection, 53, 37), settings);
    double alpha = 0.0;
    for (int y = 0; y < plain.height; ++y)
        for (int x = 0; x < plain.width; ++x) {
            const vec4f& a = plain.color[plain.index(x, y)];
            const vec4f& b = mirrored.color[mirrored.index(plain.width - 1 - x, y)];
            for (int i = 0; i < 4; ++i)
                ASSERT_NEAR(a[i], b[i], 1e-4) << x << ' ' << y;
            alpha += a.a;
        }
    EXPECT_GT(alpha, 100.0);
}

TEST_F(RenderInvariance, TheUnitOfLengthDoesNotChangeTheBits)
{
    // Squares of gradients per centimetre of a galaxy vanished in floats, and with them the headlight.
    scene.surfaces = {{0.3f, {0.9f, 0.6f, 0.3f}, 0.5f}};
    const auto inUnitsOf = [&](double unit, Method method) {
        Scene scaled = scene;
        scaled.worldFromVoxel = glm::scale(mat4d(1.0), vec3d(unit)) * scene.worldFromVoxel;
        settings.method = method;
        const View v = viewOfCamera("test", unit * vec3d(-25, 40, -30), unit * vec3d(16, 15, 18), {0, 1, 0}, 50.0, 19,
                                    13, 0.1 * unit, 1e7 * unit);
        return renderOne(scaled, v, settings);
    };
    for (const Method method : {Method::bounded, Method::midpoint, Method::reference}) {
        const Frame expected = inUnitsOf(1.0, method);
        for (const double unit : {0x1p-80, 0x1p80})
            expectSameBits(inUnitsOf(unit, method), expected);
        settings.shading = Shading::off;
        EXPECT_GT(difference(inUnitsOf(1.0, method), expected), 0.1);
        settings.shading = Shading::headlight;
    }
}

TEST_F(RenderInvariance, ThreadsDoNotChangeTheBits)
{
    expectSameBits(renderOne(scene, view, settings, 1), renderOne(scene, view, settings, 2));
}

TEST_F(RenderInvariance, ViewsRenderedTogetherHaveTheBitsOfViewsRenderedAlone)
{
    const std::vector<View> views{view, lookAt({16, 17, 15}, {30, 2, 9}, 21, 33, 90.0),
                                  lookAt({70, 12, 3}, {16, 16, 16}, 8, 5)};
    const Executor executor(2);
    Progress silent;
    std::vector<ViewStatistics> statistics;
    const auto together = Renderer(scene, executor).render(views, settings, silent, &statistics);
    ASSERT_EQ(together.size(), views.size());
    ASSERT_EQ(statistics.size(), views.size());
    for (std::size_t i = 0; i < views.size(); ++i) {
        expectSameBits(together[i], renderOne(scene, views[i], settings));
        EXPECT_EQ(statistics[i].rays, std::uint64_t(views[i].window.width) * views[i].window.height);
        EXPECT_GT(statistics[i].counts.samples, 0u);
        EXPECT_GT(statistics[i].counts.regionsVisited, 0u);
    }
}

TEST_F(RenderInvariance, ANewTransferFunctionIsLikeANewRenderer)
{
    const Executor executor(1);
    Progress silent;
    TransferFunction other = extinctionRamp({0.2f, 0.8f}, 0.0f, 0.7f, false);
    Renderer renderer(scene, executor);
    renderer.setTransferFunction(other);
    Scene changed = scene;
    changed.transferFunction = other;
    expectSameBits(renderer.render({&view, 1}, settings, silent).front(), renderOne(changed, view, settings));
    EXPECT_EQ(renderer.scene().transferFunction.range, other.range);
}

TEST_F(RenderInvariance, InstructionSetsDifferByRoundingAlone)
{
    const Frame best = renderOne(scene, view, settings);
    for (const std::string& target : laneTargets()) {
        chooseLaneTarget(target);
        EXPECT_EQ(Renderer::target(), target);
        EXPECT_LT(difference(renderOne(scene, view, settings), best), 2e-5) << target;
        expectSameBits(renderOne(scene, tileOf(view, {21, 5, 7, 7}), settings),
                       renderOne(scene, tileOf(view, {21, 5, 7, 7}), settings, 2));
    }
    chooseLaneTarget("");
}

TEST_F(RenderInvariance, SkippedRegionsChangeNothing)
{
    const Executor serial(1);
    // Most of the data is transparent, and most regions therefore invisible.
    const TransferFunction tf = extinctionRamp({0.85f, 0.95f}, 0.0f, 0.7f, false);
    const TransferTable table = tabulate(tf);
    const auto visible = visibleNodes(*scene.regions, regionBounds(*scene.field, integrate(tf), serial), serial);
    const ViewRays rays(view, scene.regions->bounds, mat4d(1.0), true);
    TraceScene s;
    s.regions = scene.regions.get();
    s.field = scene.field.get();
    s.table = &table;
    s.origin = rays.origin();
    TilePixels pixels;
    RayTile tile;
    TileResult all, skipped;
    rays.fill(16, 16, pixels, tile);
    s.nodes = scene.regions->nodes;
    traceMidpoint(s, {0.5f, 1.0f, true}, tile, all);
    s.nodes = visible;
    traceMidpoint(s, {0.5f, 1.0f, true}, tile, skipped);
    EXPECT_EQ(all.color, skipped.color);
    EXPECT_EQ(all.transmittance, skipped.transmittance);
    EXPECT_LT(2 * skipped.counts.samples, all.counts.samples);
    EXPECT_LT(2 * skipped.counts.regionsVisited, all.counts.regionsVisited);
    EXPECT_GT(skipped.counts.samples, 0u);
}

TEST_F(RenderInvariance, BricksMayBeCutInAnyWay)
{
    const auto oneBrick = cubeOfBricks(vec3i(0), 16, 16);
    const auto many = cubeOfBricks(vec3i(0), 16, 4);
    const View at = lookAt({-12, 20, -15}, {8, 8, 8}, 40, 40);
    const Frame a =
        renderOne(sceneOf(oneBrick, fieldOf(oneBrick, waves), scene.transferFunction), at, settingsOf(0.1f));
    const Frame b = renderOne(sceneOf(many, fieldOf(many, waves), scene.transferFunction), at, settingsOf(0.1f));
    EXPECT_LT(difference(a, b), 2e-3); // other regions have other segments at their faces
}

TEST_F(RenderInvariance, FarFromTheOriginThePictureIsTheSame)
{
    const vec3i offset(1'000'000, -1'000'000, 1'000'000);
    const auto farBricks = threeLevels(5, offset);
    const Field farField = fieldOf(farBricks, [&](const vec3d& p) { return waves(p - vec3d(offset)); });
    const View farView = lookAt(vec3d(-25, 40, -30) + vec3d(offset), vec3d(16, 15, 18) + vec3d(offset), 53, 37, 50.0);
    EXPECT_LT(difference(renderOne(sceneOf(farBricks, farField, scene.transferFunction), farView, settings),
                         renderOne(scene, view, settings)),
              1e-4);
}

TEST_F(RenderInvariance, ADistantEyeLosesNoPrecision)
{
    // The same picture through a long lens: rays are nearly parallel, and differ little from those of an eye twice as
    // far.
    const vec3d at(16, 15, 18), from = glm::normalize(vec3d(-2, 1.5, -3));
    const Frame a = renderOne(scene, lookAt(at + 1e6 * from, at, 32, 32, 0.0025), settings);
    const Frame b = renderOne(scene, lookAt(at + 2e6 * from, at, 32, 32, 0.00125), settings);
    EXPECT_LT(difference(a, b), 2e-2);
    EXPECT_GT(a.color[a.index(16, 16)].a, 0.2f);
}

TEST_F(RenderInvariance, WorldSpaceDoesNotChangeColours)
{
    // A rotation, a uniform scale and a shift of the data, with the eye moved along.
    mat4d m = glm::translate(mat4d(1.0), vec3d(3, -7, 11));
    m = glm::rotate(m, 0.7, glm::normalize(vec3d(1, 2, 3)));
    m = glm::scale(m, vec3d(0.01));
    View moved = view;
    moved.eye = transformPoint(m, view.eye);
    moved.lowerLeft = transformPoint(m, view.lowerLeft);
    moved.lowerRight = transformPoint(m, view.lowerRight);
    moved.upperRight = transformPoint(m, view.upperRight);
    Scene there = scene;
    there.worldFromVoxel = m;
    EXPECT_LT(difference(renderOne(there, moved, settings), renderOne(scene, view, settings)), 1e-4);
}

TEST_F(RenderInvariance, UnitsOfTheFieldDoNotChangeColours)
{
    // Densities of 1e-26 have gradients whose squares are no floats.
    const float tiny = 0x1p-86f;
    const Field small = fieldOf(bricks, [&](const vec3d& p) { return tiny * double(float(waves(p))); });
    EXPECT_LT(difference(renderOne(sceneOf(bricks, small, colorful({-tiny, tiny})), view, settings),
                         renderOne(scene, view, settings)),
              1e-5);
}

} // namespace
} // namespace brickwall
