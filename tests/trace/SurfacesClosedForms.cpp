// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/trace/SurfacesTesting.h"

#include <gtest/gtest.h>

// Fields whose surfaces are known.
namespace brickwall {
namespace {

using namespace test;
using oracles::AffineField;
using oracles::modelOf;
using oracles::oneLevelBricks;

/// 16^3 voxels of one level in bricks of 4^3 cells.
std::vector<Brick> cube(int level = 0)
{
    return oneLevelBricks(vec3i(0), vec3i(16 >> level), vec3i(4), level);
}

/// The lower half in x of level 0, the upper one of level 1 or 2.
std::vector<Brick> twoLevels(int level)
{
    std::vector<Brick> bricks = oneLevelBricks(vec3i(0), vec3i(8, 16, 16), vec3i(4), 0);
    const auto coarse = oneLevelBricks(vec3i(8 >> level, 0, 0), vec3i(8, 16, 16) / (1 << level), vec3i(4), level);
    bricks.insert(bricks.end(), coarse.begin(), coarse.end());
    oracles::numberCells(bricks);
    return bricks;
}

void expectHits(const std::vector<SurfaceHit>& hits, const std::vector<std::pair<int, double>>& wanted,
                double distance = 1e-12)
{
    ASSERT_EQ(hits.size(), wanted.size()) << toString(hits);
    for (std::size_t i = 0; i < hits.size(); ++i) {
        EXPECT_EQ(hits[i].surface, wanted[i].first) << toString(hits);
        EXPECT_NEAR(hits[i].t, wanted[i].second, distance) << toString(hits);
    }
}

TEST(Surfaces, OfAnAffineFieldArePlanes)
{
    const AffineField f{0.5, {0.25, 0.5, -0.125}};
    const SurfaceScene scene(modelOf(cube(), f), {4.0f, 3.0f, 4.0f, 2.0f});
    const vec3d org(1.0, 2.0, 3.0), dir(1.0, 0.5, 0.25);
    const double slope = glm::dot(f.gradient, dir);
    const auto at = [&](double value) { return (value - f(org)) / slope; };
    expectHits(scene.along(org, dir, 13.0), {{3, at(2.0)}, {1, at(3.0)}, {0, at(4.0)}, {2, at(4.0)}}, 1e-6);
    expectHits(scene.along({14.0, 2.0, 4.0}, {-1.0, 0.0, 0.0}, 13.0), {{0, 2.0}, {2, 2.0}, {1, 6.0}, {3, 10.0}});
}

TEST(Surfaces, AreExactWhereFloatsAre)
{
    const SurfaceScene scene(modelOf(cube(), AffineField{0.0, {1.0, 0.0, 0.0}}), {5.25f});
    expectHits(scene.along({-0.5, 7.25, 7.75}, {1.0, 0.0, 0.0}, 17.0), {{0, 5.75}}, 1e-15);
    expectHits(scene.along({16.5, 7.25, 7.75}, {-1.0, 0.0, 0.0}, 17.0), {{0, 11.25}}, 2e-15);
}

TEST(Surfaces, OnPlanesFacesAndCornersAreHitOnce)
{
    // Planes through cell centres (k + 1/2), faces of bricks (4, 8) and of supports: rays through all of them, along
    // axes, edges and diagonals.
    const SurfaceScene scene(modelOf(cube(), AffineField{0.0, {1.0, 0.0, 0.0}}), {2.5f, 4.0f, 4.5f, 7.5f, 8.0f, 8.5f});
    const std::vector<vec3d> starts{{1, 1, 1}, {1, 4, 4}, {1, 4.5, 4.5}, {1, 8, 3.5}, {1, 8, 8}, {1, 3.5, 8.25}};
    const std::vector<vec3d> directions{{1, 0, 0}, {1, 1, 0}, {1, 0, 1}, {1, 1, 1}, {1, -0.125, 0.25}};
    for (const vec3d& start : starts)
        for (const vec3d& direction : directions) {
            if (glm::any(glm::greaterThan(start + 8.0 * direction, vec3d(15.0))))
                continue;
            SCOPED_TRACE(testing::Message() << start.y << ' ' << start.z << ", " << direction.y << ' ' << direction.z);
            expectHits(scene.along(start, direction, 8.0), {{0, 1.5}, {1, 3.0}, {2, 3.5}, {3, 6.5}, {4, 7.0}, {5, 7.5}},
                       1e-6);
        }
}

TEST(Surfaces, OnLevelBoundariesAreHitOnce)
{
    for (const int level : {1, 2}) {
        // Monotone in x, but not affine across levels; every surface near the boundary at x = 8 is crossed once.
        std::vector<float> values;
        for (int i = 0; i < 60; ++i)
            values.push_back(5.0f + 0.125f * float(i));
        const SurfaceScene scene(modelOf(twoLevels(level), [](const vec3d& p) { return p.x; }), values);
        const double step = 0.5 / 8.0;
        for (double y = 6.0; y < 9.0; y += step) {
            const auto hits = scene.along({0.0, y, 8.0}, {1.0, 0.0, 0.0}, 16.0);
            ASSERT_EQ(hits.size(), values.size()) << y << ": " << toString(hits);
            for (std::size_t i = 0; i < hits.size(); ++i)
                ASSERT_EQ(hits[i].surface, int(i)) << y << ": " << toString(hits);
        }
    }
}

TEST(Surfaces, OfABallAreMetTwice)
{
    const vec3d center(8.0);
    const SurfaceScene scene(modelOf(cube(), [&](const vec3d& p) { return glm::length(p - center); }), {5.0f, 3.0f});
    const auto hits = scene.along({0.1, 8.1, 7.9}, {1.0, 0.0, 0.0}, 15.5);
    expectHits(hits, {{0, 3.0}, {1, 5.0}, {1, 11.0}, {0, 13.0}}, 0.2); // linear interpolation of a curved field
    EXPECT_NEAR(hits[0].t + hits[3].t, 2.0 * 7.9, 0.2);
}

TEST(Surfaces, ThatAreTouchedAreHitOnce)
{
    // A ridge: B is largest in the plane x = 8.5 through cell centres, where it has a kink.
    const SurfaceScene ridge(modelOf(cube(), [](const vec3d& p) { return -std::abs(p.x - 8.5); }), {0.0f});
    expectHits(ridge.along({2.0, 5.0, 6.0}, {1.0, 0.0, 0.0}, 12.0), {{0, 6.5}});
    expectHits(ridge.along({2.0, 5.0, 6.0}, {1.0, 0.25, 0.5}, 12.0), {{0, 6.5}}, 1e-6);
    expectHits(ridge.along({14.0, 5.0, 6.0}, {-1.0, 0.0, 0.0}, 12.0), {{0, 5.5}});

    // A saddle, B = x y in one piece: along (1, -1) it is 1/4 - s^2 about the middle and touches 1/4.
    const auto saddle = [](const vec3d& p) { return (p.x - 6.5) * (p.y - 6.5); };
    const SurfaceScene touching(modelOf(cube(), saddle), {0.25f});
    const double half = std::sqrt(0.5);
    const auto hits = touching.along({6.5, 7.5, 7.0}, {half, -half, 0.0}, std::sqrt(2.0));
    expectHits(hits, {{0, half}}, 1e-3);
}

TEST(Surfaces, NextToATouchAreMetTwiceOrNotAtAll)
{
    const auto saddle = [](const vec3d& p) { return (p.x - 6.5) * (p.y - 6.5); };
    const SurfaceScene scene(modelOf(cube(), saddle), {0.2499f, 0.2501f});
    const auto hits = scene.along({6.5, 7.5, 7.0}, {1.0, -1.0, 0.0}, 1.0);
    expectHits(hits, {{0, 0.49}, {0, 0.51}}, 1e-5);
}

TEST(Surfaces, OfThinShellsAreInOrder)
{
    // A hundredth of a cell apart: there in order, back in reverse.
    const SurfaceScene scene(modelOf(cube(), [](const vec3d& p) { return -std::abs(p.x - 8.5); }), {-3.0f, -2.99f});
    const double a = double(-3.0f) + 8.5, b = double(-2.99f) + 8.5, c = 8.5 - double(-2.99f), d = 8.5 - double(-3.0f);
    expectHits(scene.along({0.0, 5.0, 6.0}, {1.0, 0.0, 0.0}, 16.0), {{0, a}, {1, b}, {1, c}, {0, d}});
}

TEST(Surfaces, WhereBIsConstantCountOnceAtTheStart)
{
    const auto plateau = [](const vec3d& p) { return std::max(0.0, std::abs(p.x - 8.0) - 2.5); };
    const SurfaceScene scene(modelOf(cube(), plateau), {0.0f, 1.0f});
    expectHits(scene.along({0.0, 5.0, 6.0}, {1.0, 0.0, 0.0}, 16.0), {{1, 4.5}, {0, 5.5}, {1, 11.5}});
    expectHits(scene.along({8.0, 5.0, 6.0}, {1.0, 0.0, 0.0}, 8.0), {{0, 0.0}, {1, 3.5}});

    const SurfaceScene constant(modelOf(twoLevels(2), [](const vec3d&) { return 3.0; }), {3.0f});
    expectHits(constant.along({-0.25, 5.0, 6.0}, {1.0, 0.0, 0.0}, 20.0), {{0, 0.0}});
}

TEST(Surfaces, DoNotReachAcrossHoles)
{
    // B is 1 before a hole of six cells and 3 behind it: nothing in between has the value 2.
    std::vector<Brick> bricks = oneLevelBricks(vec3i(0), vec3i(4), vec3i(4), 0);
    const auto behind = oneLevelBricks({10, 0, 0}, vec3i(4), vec3i(4), 0);
    bricks.insert(bricks.end(), behind.begin(), behind.end());
    oracles::numberCells(bricks);
    const auto steps = [](const vec3d& p) { return p.x < 7.0 ? 1.0 : 3.0; };
    const SurfaceScene scene(modelOf(bricks, steps), {2.0f});
    EXPECT_TRUE(scene.along({-1.0, 2.0, 2.0}, {1.0, 0.0, 0.0}, 20.0).empty());
    // On both sides of it the value starts anew.
    const SurfaceScene same(modelOf(bricks, [](const vec3d&) { return 2.0; }), {2.0f});
    expectHits(same.along({-0.5, 2.0, 2.0}, {1.0, 0.0, 0.0}, 20.0), {{0, 0.0}, {0, 10.0}});

    // A hole of one cell: the supports touch in its middle, where B jumps.
    std::vector<Brick> touching = oneLevelBricks(vec3i(0), vec3i(4), vec3i(4), 0);
    const auto next = oneLevelBricks({5, 0, 0}, vec3i(4), vec3i(4), 0);
    touching.insert(touching.end(), next.begin(), next.end());
    oracles::numberCells(touching);
    const SurfaceScene torn(modelOf(touching, [](const vec3d& p) { return p.x < 4.5 ? p.x : p.x - 4.0; }),
                            {2.0f, 3.25f});
    expectHits(torn.along({-0.5, 2.0, 2.0}, {1.0, 0.0, 0.0}, 20.0), {{0, 2.5}, {1, 3.75}, {0, 6.5}, {1, 7.75}});
}

TEST(Surfaces, HideWhatIsBehindThemIfOpaque)
{
    SurfaceScene scene(modelOf(cube(), AffineField{0.0, {1.0, 0.0, 0.0}}), {9.0f, 3.0f, 6.0f});
    const auto count = [&] { return scene.along({0.0, 5.0, 6.0}, {1.0, 0.0, 0.0}, 16.0).size(); };
    EXPECT_EQ(count(), 3u);
    scene.surfaces[2].opacity = 1.0f;
    expectHits(scene.along({0.0, 5.0, 6.0}, {1.0, 0.0, 0.0}, 16.0), {{1, 3.0}, {2, 6.0}});
    scene.surfaces[2].opacity = 0.999f;
    EXPECT_EQ(count(), 3u);
    scene.surfaces[1].opacity = 0.9995f;
    EXPECT_EQ(count(), 2u); // 1 - 5e-7
}

TEST(Surfaces, BeginWhereTheRayDoes)
{
    const SurfaceScene scene(modelOf(cube(), AffineField{0.0, {1.0, 0.0, 0.0}}), {4.0f, 8.0f});
    expectHits(scene.along({6.0, 5.0, 6.0}, {1.0, 0.0, 0.0}, 16.0), {{1, 2.0}}); // inside
    expectHits(scene.along({4.0, 4.0, 4.0}, {1.0, 0.0, 0.0}, 3.0), {{0, 0.0}});  // on a face, on the surface
    expectHits(scene.along({4.0, 4.0, 4.0}, {-1.0, 0.0, 0.0}, 3.0), {{0, 0.0}});
    expectHits(scene.along({8.0, 8.0, 8.0}, {-1.0, -1.0, -1.0}, 6.0), {{1, 0.0}, {0, 4.0}}, 1e-6); // on a corner
    expectHits(scene.along({2.0, 8.0, 8.0}, {1.0, 0.0, 0.0}, 6.0), {{0, 2.0}, {1, 6.0}}); // ends on the surface
}

TEST(Surfaces, AreLitByTheGradient)
{
    SurfaceScene scene(modelOf(twoLevels(1), AffineField{0.0, {1.0, 1.0, 0.0}}), {8.0f});
    scene.headlight = true;
    EXPECT_NEAR(scene.along({1.0, 5.2, 6.1}, {1.0, 0.0, 0.0}, 6.0)[0].shade, std::sqrt(0.5), 1e-6);
    EXPECT_NEAR(scene.along({1.0, 2.2, 6.1}, {1.0, 1.0, 0.0}, 6.0)[0].shade, 1.0, 1e-6);
    const SurfaceScene unlit(modelOf(twoLevels(1), AffineField{0.0, {1.0, 1.0, 0.0}}), {8.0f});
    EXPECT_EQ(unlit.along({1.0, 5.2, 6.1}, {1.0, 0.0, 0.0}, 6.0)[0].shade, 1.0f);
}

TEST(Surfaces, OfFieldsOfAnySizeAreFound)
{
    for (const double size : {1e-30, 1e-24, 1.0, 1e24, 1e30}) {
        const SurfaceScene scene(modelOf(twoLevels(2), AffineField{0.0, {size, 0.0, 0.0}}), {float(4.25 * size)});
        expectHits(scene.along({0.0, 5.0, 6.0}, {1.0, 0.0, 0.0}, 16.0), {{0, 4.25}}, 1e-6);
    }
}

TEST(Surfaces, FarFromTheOriginAreFound)
{
    const vec3i lower(10'000'000, -20'000'000, 5'000'000);
    const std::vector<Brick> bricks = oneLevelBricks(lower, vec3i(16), vec3i(4), 0);
    const SurfaceScene scene(modelOf(bricks, [&](const vec3d& p) { return p.x - lower.x; }), {4.25f});
    expectHits(scene.along(vec3d(lower) + vec3d(0.0, 5.0, 6.0), {1.0, 0.0, 0.0}, 16.0), {{0, 4.25}});
}

} // namespace
} // namespace brickwall
