// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/render/ViewScreens.h"

#include "brickwall/tests/common/ErrorOf.h"

#include <gtest/gtest.h>

#include <limits>
#include <vector>

namespace brickwall {
namespace {

using namespace test;

TEST(ViewRays, HitTheCornersOfTenThousandScreens)
{
    Numbers number(1);
    double largest = 0.0;
    for (int i = 0; i < 10000; ++i) {
        const RandomScreen s(number);
        const View view = viewOf(s, s.eye);
        const double right = view.screenWidth - 0.5, top = view.screenHeight - 0.5;
        largest = std::max({largest, glm::length(s.eye + rayDirection(view, -0.5, -0.5) - s.lowerLeft),
                            glm::length(s.eye + rayDirection(view, right, -0.5) - s.lowerRight),
                            glm::length(s.eye + rayDirection(view, right, top) - s.upperRight),
                            glm::length(s.eye + rayDirection(view, -0.5, top) - s.upperLeft())});
    }
    EXPECT_LT(largest, 1e-13);
}

TEST(ViewRays, GoThroughPixelCentres)
{
    const View view = viewOf(cornersOf({0, 0, 0}, mat4d(1.0), 4.0, 2.0), {0.3, -0.2, 1.5}, 4, 2);
    EXPECT_LT(glm::length(view.eye + rayDirection(view, 0, 0) - vec3d(-1.5, -0.5, 0.0)), 1e-15);
    EXPECT_LT(glm::length(view.eye + rayDirection(view, 3, 1) - vec3d(1.5, 0.5, 0.0)), 1e-15);
}

TEST(ViewRays, OfAdjacentWallsAreTheSameAtTheirEdge)
{
    // A cube room: front, left, floor; each edge is named by both walls.
    const Corners front{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}};
    const Corners left{{-1, -1, 1}, {-1, -1, -1}, {-1, 1, -1}};
    const Corners floor{{-1, -1, 1}, {1, -1, 1}, {1, -1, -1}};
    Numbers number(2);
    double largest = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const mat4d turned = number.rotation();
        const auto turn = [&](const vec3d& p) { return transformVector(turned, p); };
        const auto view = [&](const Corners& c, const vec3d& eye) {
            return viewOf({turn(c.lowerLeft), turn(c.lowerRight), turn(c.upperRight)}, turn(eye), 100, 100);
        };
        const vec3d eye = number.point(0.95);
        const View f = view(front, eye), l = view(left, eye), b = view(floor, eye);
        for (int k = 0; k <= 100; ++k) {
            const vec3d fl = rayDirection(f, -0.5, k - 0.5), lf = rayDirection(l, 99.5, k - 0.5);
            const vec3d fb = rayDirection(f, k - 0.5, -0.5), bf = rayDirection(b, k - 0.5, 99.5);
            largest = std::max({largest, glm::length(fl - lf), glm::length(fb - bf)});
        }
    }
    EXPECT_LT(largest, 1e-14);
}

TEST(ViewRays, OfTilesAreThoseOfTheWholeBitForBit)
{
    Numbers number(3);
    const RandomScreen s(number);
    const View whole = viewOf(s, s.eye, 37, 23);
    std::vector<int> covered(37 * 23, 0);
    for (const int x : {0, 16, 32})
        for (const int y : {0, 7, 14, 21}) {
            const PixelRect tile{x, y, std::min(16, 37 - x), std::min(7, 23 - y)};
            const View part = tileOf(whole, tile);
            EXPECT_EQ(part.window, tile);
            EXPECT_EQ(part.clipFromWorld, whole.clipFromWorld);
            for (int j = tile.y; j < tile.y + tile.height; ++j)
                for (int i = tile.x; i < tile.x + tile.width; ++i) {
                    ++covered[j * 37 + i];
                    ASSERT_EQ(rayDirection(part, i, j), rayDirection(whole, i, j));
                }
        }
    EXPECT_EQ(covered, std::vector<int>(37 * 23, 1));
    EXPECT_EQ(tileOf(tileOf(whole, {8, 4, 16, 16}), {2, 3, 4, 5}).window, (PixelRect{10, 7, 4, 5}));
}

TEST(ViewRays, TilesOutsideTheWindowAreRefused)
{
    const View whole = viewOf(cornersOf({0, 0, 0}, mat4d(1.0), 2, 2), {0, 0, 1}, 32, 16);
    for (const PixelRect& bad : {PixelRect{-1, 0, 4, 4}, PixelRect{30, 0, 3, 1}, PixelRect{0, 0, 0, 4},
                                 PixelRect{0, 10, 4, 7}, PixelRect{2147483647, 0, 2147483647, 1}})
        EXPECT_THROW(tileOf(whole, bad), Error);
}

TEST(ViewOfScreen, RefusesAnEyeOnOrBehindTheScreen)
{
    Numbers number(4);
    for (int i = 0; i < 200; ++i) {
        const mat4d turned = number.rotation();
        const vec3d center = number.point(1.0);
        const Corners c = cornersOf(center, turned, 2.0, 1.0);
        const auto at = [&](double x, double y, double z) { return center + transformVector(turned, {x, y, z}); };
        EXPECT_NO_THROW(viewOf(c, at(0.4, 3.0, 1e-6)));
        EXPECT_THROW(viewOf(c, at(0.4, 3.0, 0.0)), Error);
        EXPECT_THROW(viewOf(c, at(0.4, 0.3, 1e-9)), Error);
        EXPECT_THROW(viewOf(c, at(0.4, 0.3, -0.25)), Error);
    }
}

TEST(ViewOfScreen, SaysWhichViewAndHowFarBehind)
{
    const Corners c = cornersOf({0, 0, 0}, mat4d(1.0), 2.0, 2.0);
    const std::string message = errorOf([&] {
        viewOfScreen("left-wall", {0, 0, -0.25}, c.lowerLeft, c.lowerRight, c.upperRight, 8, 8, 0.1, 10);
    });
    EXPECT_NE(message.find("left-wall"), std::string::npos) << message;
    EXPECT_NE(message.find("-0.25"), std::string::npos) << message;
}

TEST(ViewOfScreen, RefusesAMirroredScreen)
{
    const Corners c = cornersOf({0, 0, 0}, mat4d(1.0), 2.0, 2.0);
    EXPECT_NO_THROW(viewOf(c, {0.2, 0.1, 1.0}));
    const Corners swapped{c.lowerRight, c.lowerLeft, c.upperRight}; // as a typing error in a file has it
    EXPECT_NE(errorOf([&] { viewOf(swapped, {0.2, 0.1, 1.0}); }).find("behind"), std::string::npos);
    const Corners mirrored{c.lowerRight, c.lowerLeft, c.upperLeft()};
    EXPECT_NE(errorOf([&] { viewOf(mirrored, {0.2, 0.1, 1.0}); }).find("behind"), std::string::npos);
}

TEST(ViewOfScreen, RefusesWhatIsNoScreen)
{
    const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
    const vec3d eye(0, 0, 1);
    EXPECT_THROW(viewOf({{0, 0, 0}, {0, 0, 0}, {0, 1, 0}}, eye), Error);
    EXPECT_THROW(viewOf({{0, 0, 0}, {1, 0, 0}, {1, 0, 0}}, eye), Error);
    EXPECT_THROW(viewOf({{0, 0, 0}, {1, 1, 0}, {2, 2, 0}}, eye), Error);
    EXPECT_THROW(viewOf({{nan, 0, 0}, {1, 0, 0}, {1, 1, 0}}, eye), Error);
    EXPECT_THROW(viewOf({{0, 0, 0}, {1, 0, 0}, {1, inf, 0}}, eye), Error);
    const Corners good = cornersOf({0, 0, 0}, mat4d(1.0), 2.0, 2.0);
    EXPECT_THROW(viewOf(good, {nan, 0, 1}), Error);
    EXPECT_THROW(viewOf(good, {0, 0, inf}), Error);
    EXPECT_THROW(viewOf(good, eye, 0, 4), Error);
    EXPECT_THROW(viewOf(good, eye, 4, -1), Error);
    EXPECT_THROW(viewOf(good, eye, 4, 4, 0.0, 1.0), Error);
    EXPECT_THROW(viewOf(good, eye, 4, 4, 1.0, 1.0), Error);
    EXPECT_THROW(viewOf(good, eye, 4, 4, nan, 1.0), Error);
}

TEST(ViewOfScreen, KnowsItsDistance)
{
    Numbers number(5);
    for (int i = 0; i < 100; ++i) {
        const mat4d turned = number.rotation();
        const vec3d center = number.point(10.0);
        const double d = number(0.01, 5.0), x = number(-2.0, 2.0);
        const View view = viewOf(cornersOf(center, turned, 2.0, 1.0), center + transformVector(turned, {x, 0.3, d}));
        EXPECT_NEAR(eyeDistance(view), d, 1e-13);
    }
}

TEST(ViewOfCamera, LooksAtItsPointWithItsAngle)
{
    const vec3d eye(3, -2, 5), at(0.5, 0.5, 0.5), up(0, 0, 1);
    const View view = viewOfCamera("camera", eye, at, up, 40.0, 160, 90, 0.1, 100.0);
    EXPECT_LT(angle(rayDirection(view, 79.5, 44.5), at - eye), 1e-15);
    EXPECT_NEAR(angle(rayDirection(view, 79.5, -0.5), rayDirection(view, 79.5, 89.5)), 40.0 * std::numbers::pi / 180,
                1e-14);
    const vec3d right = view.lowerRight - view.lowerLeft, upwards = view.upperRight - view.lowerRight;
    EXPECT_NEAR(glm::length(right) / glm::length(upwards), 160.0 / 90.0, 1e-14);
    EXPECT_GT(glm::dot(upwards, up), 0.0);
    EXPECT_NEAR(glm::dot(right, up), 0.0, 1e-14);
    EXPECT_GT(eyeDistance(view), 0.0);
}

TEST(ViewOfCamera, RefusesCamerasThatSeeNothing)
{
    EXPECT_THROW(viewOfCamera("c", {1, 1, 1}, {1, 1, 1}, {0, 1, 0}, 40, 8, 8, 0.1, 10), Error);
    EXPECT_THROW(viewOfCamera("c", {0, 0, 0}, {0, 1, 0}, {0, 1, 0}, 40, 8, 8, 0.1, 10), Error);
    EXPECT_THROW(viewOfCamera("c", {0, 0, 0}, {0, 0, 1}, {0, 0, 0}, 40, 8, 8, 0.1, 10), Error);
    EXPECT_THROW(viewOfCamera("c", {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 180, 8, 8, 0.1, 10), Error);
    EXPECT_THROW(viewOfCamera("c", {0, 0, 0}, {0, 0, 1}, {0, 1, 0}, 0, 8, 8, 0.1, 10), Error);
}

} // namespace
} // namespace brickwall
