// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/Accumulation.h"
#include "brickwall/core/render/Compare.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>
#include <vector>

namespace brickwall::test {
namespace {

/// A ball with a hard edge, and a volume around it.
Scene ballInFog()
{
    const auto bricks = cubeOfBricks(vec3i(0), 16, 8);
    const auto distance = [](const vec3d& p) { return glm::length(p - vec3d(8.0)); };
    Scene scene = sceneOf(numbered(bricks), fieldOf(bricks, distance), colorful({2.0f, 12.0f}));
    scene.surfaces = {{5.0f, vec3f(1.0f, 0.8f, 0.3f), 1.0f}};
    return scene;
}

View viewFrom(const vec3d& eye)
{
    return viewOfCamera("view", eye, {8.0, 8.0, 8.0}, {0.0, 1.0, 0.0}, 40.0, 40, 40, 1.0, 100.0);
}

class AccumulationTest : public ::testing::Test
{
protected:
    std::vector<Frame> render(const View& view) { return renderer.render({&view, 1}, settings, progress); }
    Frame accumulate(const View& view)
    {
        return accumulation.add(render(accumulation.next({&view, 1}).front())).front();
    }

    const Executor executor{1};
    const Renderer renderer{ballInFog(), executor};
    const RenderSettings settings{};
    Progress progress;
    Accumulation accumulation;
    const View view = viewFrom({8.0, 9.0, 40.0});
};

TEST(PixelOffset, StartsAtTheCentreAndFindsEverySixteenthOfAPixelAroundIt)
{
    EXPECT_EQ(pixelOffset(0).x, 0.0);
    EXPECT_EQ(pixelOffset(0).y, 0.0);
    std::set<std::array<int, 2>> found;
    double sumX = 0.0, sumY = 0.0;
    for (int n = 0; n < 65; ++n) {
        const PixelOffset offset = pixelOffset(n);
        ASSERT_TRUE(std::abs(offset.x) <= 0.5 && std::abs(offset.y) <= 0.5) << n;
        found.insert({int(std::floor(4.0 * offset.x)), int(std::floor(4.0 * offset.y))});
        sumX += offset.x;
        sumY += offset.y;
    }
    EXPECT_EQ(found.size(), 16u);
    EXPECT_NEAR(sumX, 0.0, 1e-12);
    EXPECT_NEAR(sumY, 0.0, 1e-12);
}

TEST_F(AccumulationTest, AWholePixelOffIsTheNeighboursRay)
{
    const View moved = movedByPixels(view, {1.0, -2.0});
    const vec3d there = rayDirection(moved, 10, 10), here = rayDirection(view, 11, 8);
    EXPECT_LT(glm::length(there - here), 1e-12);
    EXPECT_EQ(moved.eye, view.eye);
}

TEST_F(AccumulationTest, OneFrameIsTheFrameItself)
{
    const Frame once = accumulate(view), plain = render(view).front();
    EXPECT_EQ(once.color, plain.color);
    EXPECT_EQ(once.depth, plain.depth);
}

TEST_F(AccumulationTest, TheMeanConvergesToThatOfManyPointsOfEachPixelFasterThanRandomPointsWould)
{
    constexpr int perSide = 24;
    Frame reference = emptyFrame(view);
    for (int y = 0; y < perSide; ++y)
        for (int x = 0; x < perSide; ++x) {
            const Frame frame =
                render(movedByPixels(view, {(x + 0.5) / perSide - 0.5, (y + 0.5) / perSide - 0.5})).front();
            for (std::size_t i = 0; i < frame.color.size(); ++i)
                reference.color[i] += frame.color[i] / float(perSide * perSide);
        }
    std::vector<double> errors; // after 1, 5, 17, 65 frames
    Frame mean;
    for (int n = 1; n <= 65; ++n) {
        mean = accumulate(view);
        if (n == 1 || n == 5 || n == 17 || n == 65)
            errors.push_back(compareFrames(mean, reference).rms);
    }
    const std::vector<double> counts{1.0, 5.0, 17.0, 65.0};
    for (std::size_t i = 1; i < errors.size(); ++i)
        EXPECT_LT(errors[i], errors[i - 1] * std::sqrt(counts[i - 1] / counts[i])) << "as random points would have";
    const double rate = std::log(errors.front() / errors.back()) / std::log(65.0);
    RecordProperty("rate", std::to_string(rate));
    EXPECT_GT(rate, 0.65) << errors[0] << ' ' << errors[1] << ' ' << errors[2] << ' ' << errors[3];
}

TEST_F(AccumulationTest, AnotherPoseStartsAnewAndLeavesNothingOfTheOneBefore)
{
    for (int n = 0; n < 3; ++n)
        accumulate(view);
    View other = viewFrom({9.0, 9.0, 40.0});
    EXPECT_EQ(accumulate(other).color, render(other).front().color);
    EXPECT_EQ(accumulation.count(), 1);
    other.screenWidth = other.window.width = 39; // a window that was resized
    EXPECT_EQ(accumulate(other).color, render(other).front().color);
    EXPECT_EQ(accumulation.count(), 1);
    accumulate(other);
    EXPECT_EQ(accumulation.count(), 2);
    accumulation.restart();
    EXPECT_EQ(accumulate(other).color, render(other).front().color);
}

TEST_F(AccumulationTest, DepthIsThatOfTheCentresWhereTheyHitSomething)
{
    const Frame centres = render(view).front();
    Frame mean;
    for (int n = 0; n < 16; ++n)
        mean = accumulate(view);
    int more = 0;
    for (std::size_t i = 0; i < mean.depth.size(); ++i) {
        if (centres.depth[i] < 1.0f)
            EXPECT_EQ(mean.depth[i], centres.depth[i]);
        else
            more += mean.depth[i] < 1.0f;
        EXPECT_EQ(mean.depth[i]<1.0f, mean.color[i].a> 0.0f);
    }
    EXPECT_GT(more, 0) << "edges";
}

} // namespace
} // namespace brickwall::test
