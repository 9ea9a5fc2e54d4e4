// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/View.h"
#include "brickwall/tests/common/Numbers.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>

/// Screens, eyes and matrices for the tests of views.
namespace brickwall::test {

struct Corners
{
    vec3d lowerLeft{0.0}, lowerRight{0.0}, upperRight{0.0};
    vec3d upperLeft() const { return lowerLeft + upperRight - lowerRight; }
};

/// A width x height screen about `center`, right and up being the rotated x and y axes.
inline Corners cornersOf(const vec3d& center, const mat4d& rotation, double width, double height)
{
    const vec3d r = transformVector(rotation, {0.5 * width, 0.0, 0.0});
    const vec3d u = transformVector(rotation, {0.0, 0.5 * height, 0.0});
    return {center - r - u, center + r - u, center + r + u};
}

/// A screen anywhere, with an eye somewhere in front of it: to the side as well as near.
struct RandomScreen : Corners
{
    vec3d eye{0.0};
    explicit RandomScreen(Numbers& number)
    {
        const mat4d rotation = number.rotation();
        const double width = number(0.3, 5.0), height = number(0.3, 5.0);
        const vec3d center = number.point(10.0);
        static_cast<Corners&>(*this) = cornersOf(center, rotation, width, height);
        const double x = number(-3.0, 3.0), y = number(-3.0, 3.0), z = number(0.05, 4.0);
        eye = center + transformVector(rotation, {x, y, z});
    }
};

inline View viewOf(const Corners& c, const vec3d& eye, int width = 64, int height = 48, double near = 0.1,
                   double far = 100.0)
{
    return viewOfScreen("test", eye, c.lowerLeft, c.lowerRight, c.upperRight, width, height, near, far);
}

/// The angle of two directions, exact for small ones.
inline double angle(const vec3d& a, const vec3d& b)
{
    const vec3d p = glm::normalize(a), q = glm::normalize(b);
    return 2.0 * std::atan2(glm::length(p - q), glm::length(p + q));
}

/// The largest angle of the rays of two views of equal size, over a coarse grid that has the four corners.
inline double largestAngle(const View& a, const View& b)
{
    double largest = 0.0;
    for (int j = 0; j <= 8; ++j)
        for (int i = 0; i <= 8; ++i) {
            const double x = i / 8.0 * a.screenWidth - 0.5, y = j / 8.0 * a.screenHeight - 0.5;
            largest = std::max(largest, angle(rayDirection(a, x, y), rayDirection(b, x, y)));
        }
    return largest;
}

} // namespace brickwall::test
