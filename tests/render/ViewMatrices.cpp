// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/render/ViewScreens.h"

#include "brickwall/core/base/Error.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace brickwall {
namespace {

using namespace test;

constexpr double infinite = std::numeric_limits<double>::infinity();

mat4d modelviewOf(const Corners& c, const vec3d& eye)
{
    return modelviewOfScreen(eye, c.lowerLeft, c.lowerRight, c.upperRight);
}

mat4d projectionOf(const Corners& c, const vec3d& eye, double near = 0.1, double far = 100.0)
{
    return projectionOfScreen(eye, c.lowerLeft, c.lowerRight, c.upperRight, near, far);
}

/// The same picture with window depth running the other way and no far plane (z_clip = near).
mat4d reversed(mat4d projection, double near)
{
    projection[0][2] = projection[1][2] = projection[2][2] = 0.0;
    projection[3][2] = near;
    return projection;
}

double windowDepth(const View& view, const vec3d& p)
{
    return 0.5 * transformPoint(view.clipFromWorld, p).z + 0.5;
}

TEST(ViewMatrices, MapCornersToTheUnitSquareWithPositiveW)
{
    Numbers number(11);
    for (int i = 0; i < 2000; ++i) {
        const RandomScreen s(number);
        const mat4d clip = projectionOf(s, s.eye) * modelviewOf(s, s.eye);
        const vec3d corners[] = {s.lowerLeft, s.lowerRight, s.upperRight, s.upperLeft()};
        const double x[] = {-1, 1, 1, -1}, y[] = {-1, -1, 1, 1};
        for (int k = 0; k < 4; ++k) {
            const vec4d c = clip * vec4d(corners[k], 1.0);
            ASSERT_GT(c.w, 0.0);
            EXPECT_NEAR(c.x / c.w, x[k], 1e-11);
            EXPECT_NEAR(c.y / c.w, y[k], 1e-11);
        }
    }
}

TEST(ViewMatrices, AgreeWithTheRaysOfASkewedScreen)
{
    // The floor of a well-known example file has a corner with a typing error and is a parallelogram.
    const Corners skewed{{-1.13, -0.635, 1.04}, {1.13, -0.635, 0.0}, {1.13, -0.635, -1.22}};
    const vec3d eye(0.2, 0.5, 0.3);
    const View view = viewOf(skewed, eye);
    const View back = viewOfMatrices("gl", modelviewOf(skewed, eye), projectionOf(skewed, eye), 64, 48);
    EXPECT_LT(largestAngle(view, back), 1e-14);
    const vec3d ndc = transformPoint(view.clipFromWorld, skewed.upperLeft());
    EXPECT_NEAR(ndc.x, -1.0, 1e-13);
    EXPECT_NEAR(ndc.y, 1.0, 1e-13);
}

TEST(ViewMatrices, HavePositiveWInFront)
{
    Numbers number(12);
    for (int i = 0; i < 500; ++i) {
        const RandomScreen s(number);
        const View view = viewOf(s, s.eye);
        for (const double t : {1e-3, 0.5, 1.0, 50.0}) {
            const vec3d d = rayDirection(view, 10, 20);
            EXPECT_GT((view.clipFromWorld * vec4d(s.eye + t * d, 1.0)).w, 0.0);
            EXPECT_LT((view.clipFromWorld * vec4d(s.eye - t * d, 1.0)).w, 0.0);
        }
    }
}

TEST(ViewMatrices, GiveTheFrustumOfCovisesLeftWall)
{
    // Millimetres, z up, heading 90 degrees: right = +y, up = +z; left eye at (268, -200, 100).
    const Corners wall{{-1500, -1500, -1500}, {-1500, 1500, -1500}, {-1500, 1500, 1500}};
    const double n = 10.0;
    const mat4d p = projectionOf(wall, {268, -200, 100}, n, 1e7);
    EXPECT_NEAR(n * (p[2][0] - 1.0) / p[0][0], -7.3529, 1e-4);
    EXPECT_NEAR(n * (p[2][0] + 1.0) / p[0][0], 9.6154, 1e-4);
    EXPECT_NEAR(n * (p[2][1] - 1.0) / p[1][1], -9.0498, 1e-4);
    EXPECT_NEAR(n * (p[2][1] + 1.0) / p[1][1], 7.9186, 1e-4);
    EXPECT_NEAR(eyeDistance(viewOf(wall, {268, -200, 100})), 1768.0, 1e-9);
}

TEST(ViewMatrices, AreGlFrustumForARectangle)
{
    const Corners wall = cornersOf({0.3, -0.2, -1.5}, mat4d(1.0), 2.0, 1.6);
    const double n = 0.1, f = 50.0, k = n / 1.5;
    const mat4d expected = glm::frustum(-0.7 * k, 1.3 * k, -1.0 * k, 0.6 * k, n, f);
    const mat4d found = projectionOf(wall, {0, 0, 0}, n, f);
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            EXPECT_NEAR(found[c][r], expected[c][r], 1e-14) << c << " " << r;
}

TEST(ViewOfMatrices, HasTheRaysOfTheCorners)
{
    Numbers number(13);
    double largest = 0.0, away = 0.0;
    for (int i = 0; i < 2000; ++i) {
        const RandomScreen s(number);
        const View back = viewOfMatrices("gl", modelviewOf(s, s.eye), projectionOf(s, s.eye), 64, 48);
        largest = std::max(largest, largestAngle(back, viewOf(s, s.eye)));
        away = std::max(away, glm::length(back.eye - s.eye));
        ASSERT_GT(eyeDistance(back), 0.0);
    }
    EXPECT_LT(largest, 1e-12);
    EXPECT_LT(away, 1e-12);
}

TEST(ViewOfMatrices, DoesNotDependOnNearAndFar)
{
    Numbers number(14);
    for (int i = 0; i < 300; ++i) {
        const RandomScreen s(number);
        const mat4d modelview = modelviewOf(s, s.eye);
        const View sane = viewOfMatrices("gl", modelview, projectionOf(s, s.eye, 0.1, 100.0), 64, 48);
        for (const mat4d& p : {projectionOf(s, s.eye, 1e-3, 1e6), projectionOf(s, s.eye, 0.1, infinite),
                               reversed(projectionOf(s, s.eye), 0.1), reversed(projectionOf(s, s.eye), 1e-6)})
            EXPECT_LT(largestAngle(viewOfMatrices("gl", modelview, p, 64, 48), sane), 1e-12);
    }
}

TEST(ViewOfMatrices, AllowsAnyScaleOfTheModelAndOfTheMatrix)
{
    Numbers number(15);
    for (int i = 0; i < 300; ++i) {
        const RandomScreen s(number);
        // World is the room scaled, sheared and turned; the host's modelview undoes that first.
        const mat4d worldFromRoom = number.rotation() * glm::scale(mat4d(1.0), {1e3, 20.0, 3.0}) * number.rotation();
        const mat4d modelview = modelviewOf(s, s.eye) * glm::inverse(worldFromRoom);
        const double factor = std::pow(10.0, number(-8.0, 8.0));
        const View view = viewOfMatrices("gl", modelview, factor * projectionOf(s, s.eye), 64, 48);
        const View room = viewOf(s, s.eye);
        for (const double x : {0.0, 30.0, 63.0}) {
            const vec3d expected = transformVector(worldFromRoom, rayDirection(room, x, 7.0));
            EXPECT_LT(angle(rayDirection(view, x, 7.0), expected), 1e-11);
        }
    }
}

TEST(ViewOfMatrices, LooksToWhereWIsPositive)
{
    const Corners wall = cornersOf({0, 0, -2}, mat4d(1.0), 2.0, 2.0);
    const vec3d eye(0.1, 0.2, 0.0);
    const View front = viewOfMatrices("gl", modelviewOf(wall, eye), projectionOf(wall, eye), 8, 8);
    EXPECT_LT(rayDirection(front, 3, 3).z, 0.0);
    // With the sign of all clip coordinates changed, OpenGL draws what is behind.
    const View back = viewOfMatrices("gl", modelviewOf(wall, eye), -1.0 * projectionOf(wall, eye), 8, 8);
    EXPECT_LT(angle(rayDirection(back, 3, 3), -rayDirection(front, 3, 3)), 1e-15);
}

TEST(ViewOfMatrices, MirrorsWhereTheHostMirrors)
{
    const Corners wall = cornersOf({0, 0, -2}, mat4d(1.0), 2.0, 1.0);
    const vec3d eye(0.1, 0.2, 0.0);
    const mat4d mirror = glm::scale(mat4d(1.0), {-1.0, 1.0, 1.0});
    const View view = viewOfMatrices("gl", modelviewOf(wall, eye) * mirror, projectionOf(wall, eye), 64, 48);
    const vec3d plain = rayDirection(viewOf(wall, eye), 10, 20);
    EXPECT_LT(angle(rayDirection(view, 10, 20), {-plain.x, plain.y, plain.z}), 1e-14);
    EXPECT_LT(eyeDistance(view), 0.0);
}

TEST(ViewOfMatrices, KeepsItsDigitsFarFromTheOrigin)
{
    Numbers number(16);
    for (int i = 0; i < 200; ++i) {
        const RandomScreen s(number);
        const vec3d far(3e7, -2e7,
                        1e7); // the matrices' own translation is good to 4e-9 here, the directions are not worse off
        const mat4d modelview = modelviewOf(s, s.eye) * glm::translate(mat4d(1.0), -far);
        const View view = viewOfMatrices("gl", modelview, projectionOf(s, s.eye), 64, 48);
        EXPECT_LT(largestAngle(view, viewOf(s, s.eye)), 1e-13);
        EXPECT_LT(glm::length(view.eye - far - s.eye), 1e-6);
    }
}

TEST(ViewOfMatrices, NeedsOnlyFloatsFromTheHost)
{
    // Hosts keep float copies: the error is that of their numbers, a thousandth of a pixel, whatever near and far are.
    Numbers number(17);
    double largest = 0.0;
    for (int i = 0; i < 1000; ++i) {
        const mat4d rotation = number.rotation();
        const Corners wall = cornersOf(transformVector(rotation, {0, 0, -1}), rotation, 2.0, 2.0);
        const vec3d eye = number.point(0.5);
        const View exact = viewOf(wall, eye);
        const mat4d modelview(glm::mat4(modelviewOf(wall, eye)));
        for (const double far : {1e3, 1e6, infinite})
            largest = std::max(
                largest, largestAngle(viewOfMatrices("gl", modelview,
                                                     mat4d(glm::mat4(projectionOf(wall, eye, 1e-3, far))), 64, 48),
                                      exact));
    }
    EXPECT_LT(largest, 2e-6);
    EXPECT_GT(largest, 0.0);
}

TEST(ViewOfMatrices, RefusesWhatIsNoPerspective)
{
    const Corners wall = cornersOf({0, 0, -2}, mat4d(1.0), 2.0, 2.0);
    const mat4d modelview = modelviewOf(wall, {0.1, 0.2, 0.0}), good = projectionOf(wall, {0.1, 0.2, 0.0});
    Numbers number(18);
    const mat4d turned = number.rotation() * modelview;
    const auto refused = [&](const mat4d& m, const mat4d& p) { EXPECT_THROW(viewOfMatrices("gl", m, p, 8, 8), Error); };
    EXPECT_NO_THROW(viewOfMatrices("gl", turned, good, 8, 8));
    refused(turned, glm::ortho(-1.0, 1.0, -1.0, 1.0, 0.1, 10.0));
    refused(turned, mat4d(1.0));
    refused(turned, mat4d(0.0));
    refused(mat4d(0.0), good);
    refused(glm::scale(mat4d(1.0), {1.0, 0.0, 1.0}), good);
    refused(turned * glm::scale(mat4d(1.0), {0.0, 1.0, 1.0}), good);
    for (const int r : {0, 1, 2, 3}) { // a row that is zero
        mat4d p = good;
        p[0][r] = p[1][r] = p[2][r] = p[3][r] = 0.0;
        refused(modelview, p);
    }
    for (const int r : {0, 1, 2}) { // a row that is a multiple of w
        mat4d p = good;
        for (int c = 0; c < 4; ++c)
            p[c][r] = 0.5 * p[c][3];
        refused(modelview, p);
    }
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r) {
            mat4d p = good;
            p[c][r] = std::numeric_limits<double>::quiet_NaN();
            refused(modelview, p);
            p[c][r] = infinite;
            refused(modelview, p);
        }
    EXPECT_THROW(viewOfMatrices("gl", modelview, good, 0, 8), Error);
}

TEST(ViewDepth, IsZeroAtNearAndOneAtFar)
{
    Numbers number(19);
    for (int i = 0; i < 300; ++i) {
        const RandomScreen s(number);
        const View view = viewOf(s, s.eye, 64, 48, 0.25, 40.0), endless = viewOf(s, s.eye, 64, 48, 0.25, infinite);
        const double d = eyeDistance(view);
        for (const double x : {0.0, 31.0, 63.0}) {
            const vec3d ray = rayDirection(view, x, 13.0);
            EXPECT_NEAR(windowDepth(view, s.eye + 0.25 / d * ray), 0.0, 1e-11);
            EXPECT_NEAR(windowDepth(view, s.eye + 40.0 / d * ray), 1.0, 1e-13);
            EXPECT_NEAR(windowDepth(endless, s.eye + 0.25 / d * ray), 0.0, 1e-11);
            EXPECT_NEAR(windowDepth(endless, s.eye + 1e15 / d * ray), 1.0, 1e-13);
        }
    }
}

} // namespace
} // namespace brickwall
