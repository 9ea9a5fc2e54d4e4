// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/FrameWork.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <gtest/gtest.h>

namespace brickwall::test {
namespace {

View viewFrom(const vec3d& eye, const vec3d& at, int size)
{
    return viewOfCamera("view", eye, at, {0.0, 1.0, 0.0}, 40.0, size, size, 1.0, 200.0);
}

class FrameWorkTest : public ::testing::Test
{
protected:
    double work(const View& view) { return workOf(renderer, {&view, 1}, progress); }
    /// As the renderer counts it, of all rays.
    double regionsOf(const View& view)
    {
        std::vector<ViewStatistics> statistics;
        renderer.render({&view, 1}, {}, progress, &statistics);
        return double(statistics.front().counts.regionsVisited);
    }
    static Scene scene()
    {
        const auto bricks = threeLevels(3);
        return sceneOf(bricks, fieldOf(bricks, [](const vec3d& p) { return p.x; }), colorful({0.0f, 32.0f}));
    }

    const Executor executor{1};
    const Renderer renderer{scene(), executor};
    Progress progress;
};

TEST_F(FrameWorkTest, GrowsWithThePixelsAndIsTheirsAloneWhereNothingIsToBeSeen)
{
    const vec3d center(16.0);
    const double once = work(viewFrom({16.0, 16.0, 90.0}, center, 64));
    EXPECT_NEAR(work(viewFrom({16.0, 16.0, 90.0}, center, 128)) / once, 4.0, 1e-9);
    const double nothing = work(viewFrom({16.0, 16.0, 90.0}, {16.0, 16.0, 200.0}, 64));
    EXPECT_GT(nothing, 0.0);
    EXPECT_LT(nothing, 0.7 * once);
    EXPECT_NEAR(work(viewFrom({16.0, 16.0, 90.0}, {16.0, 16.0, 200.0}, 32)) / nothing, 0.25, 1e-9);
}

TEST_F(FrameWorkTest, FollowsTheRegionsThatAllRaysVisit)
{
    const double nothing = work(viewFrom({16.0, 16.0, 90.0}, {16.0, 16.0, 200.0}, 96));
    std::vector<double> ratios;
    for (const double distance : {30.0, 45.0, 60.0, 90.0}) {
        const View view = viewFrom({16.0 + 0.3 * distance, 20.0, 16.0 + distance}, vec3d(16.0), 96);
        ratios.push_back((work(view) - nothing) / regionsOf(view));
    }
    for (const double ratio : ratios)
        EXPECT_NEAR(ratio / ratios.front(), 1.0, 0.25);
}

TEST_F(FrameWorkTest, OfHalvesOfAScreenIsAboutThatOfTheWhole)
{
    const View whole = viewFrom({30.0, 25.0, 60.0}, vec3d(16.0), 96);
    const View left = tileOf(whole, {0, 0, 48, 96}), right = tileOf(whole, {48, 0, 48, 96});
    EXPECT_NEAR((work(left) + work(right)) / work(whole), 1.0, 0.1);
}

} // namespace
} // namespace brickwall::test
