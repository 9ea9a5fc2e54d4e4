// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/render/ViewScreens.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace brickwall {
namespace {

using namespace test;

constexpr int pixels = 200;

/// Left, front and right wall of a cube room, 2 wide, y up, front at -z; beside each other they are one panorama.
std::array<View, 3> walls(const vec3d& eye)
{
    const std::array<Corners, 3> corners{Corners{{-1, -1, 1}, {-1, -1, -1}, {-1, 1, -1}},
                                         Corners{{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}},
                                         Corners{{1, -1, -1}, {1, -1, 1}, {1, 1, 1}}};
    std::array<View, 3> views;
    for (int i = 0; i < 3; ++i) {
        const Corners& c = corners[i];
        const mat4d modelview = modelviewOfScreen(eye, c.lowerLeft, c.lowerRight, c.upperRight);
        const mat4d projection = projectionOfScreen(eye, c.lowerLeft, c.lowerRight, c.upperRight, 1e-3, 1e6);
        views[i] =
            i == 1 ? viewOfMatrices("front", modelview, projection, pixels, pixels) : viewOf(c, eye, pixels, pixels);
    }
    return views;
}

/// The panorama's own direction, from where on the unfolded walls (x from 0 to 6, y from 0 to 2) a point is.
vec3d panoramaDirection(const vec3d& eye, double x, double y)
{
    if (x < 2.0)
        return vec3d(-1.0, y - 1.0, 1.0 - x) - eye;
    if (x < 4.0)
        return vec3d(x - 3.0, y - 1.0, -1.0) - eye;
    return vec3d(1.0, y - 1.0, x - 5.0) - eye;
}

bool hitsSphere(const vec3d& eye, const vec3d& direction, const vec3d& center, double radius)
{
    const vec3d d = glm::normalize(direction);
    const double along = glm::dot(center - eye, d);
    return along > 0.0 && glm::length(center - eye - along * d) < radius;
}

TEST(ViewPanorama, ASphereHasItsClosedFormSilhouetteOnThreeWalls)
{
    const vec3d eye(0.17, -0.23, 0.31);
    const std::array<View, 3> views = walls(eye);
    for (const vec3d& center : {vec3d(-2.0, 0.2, -2.1), vec3d(1.8, -0.4, -2.2), vec3d(0.0, 0.0, -0.3)}) {
        const double radius = 0.45, half = std::asin(radius / glm::length(center - eye));
        std::array<int, 3> hits{};
        for (int wall = 0; wall < 3; ++wall)
            for (int j = 0; j < pixels; ++j)
                for (int i = 0; i < pixels; ++i) {
                    const vec3d ray = rayDirection(views[wall], i, j);
                    const double x = 2.0 * wall + 2.0 * (i + 0.5) / pixels, y = 2.0 * (j + 0.5) / pixels;
                    const double exact = angle(panoramaDirection(eye, x, y), center - eye);
                    ASSERT_GT(std::abs(exact - half), 1e-12) << "a pixel exactly on the silhouette decides nothing";
                    const bool hit = hitsSphere(views[wall].eye, ray, center, radius);
                    ASSERT_EQ(hit, exact < half) << wall << " " << i << " " << j;
                    hits[wall] += hit;
                }
        EXPECT_GT(hits[1], 0);
        if (center.x != 0.0) { // the other two spheres lie across a seam
            EXPECT_GT(hits[center.x < 0.0 ? 0 : 2], 0);
        }
    }
}

TEST(ViewPanorama, IsContinuousOverTheSeams)
{
    Numbers number(21);
    for (int k = 0; k < 200; ++k) {
        const std::array<View, 3> views = walls(number.point(0.9));
        for (int wall = 0; wall < 2; ++wall)
            for (int j = 0; j < pixels; j += 7)
                EXPECT_LT(angle(rayDirection(views[wall], pixels - 0.5, j), rayDirection(views[wall + 1], -0.5, j)),
                          1e-13);
    }
}

} // namespace
} // namespace brickwall
