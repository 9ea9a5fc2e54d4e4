// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Camera.h"

#include "brickwall/core/base/BoxCorners.h"
#include "brickwall/core/base/Error.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace brickwall {
namespace {

constexpr double overviewFov = 28.0;     // degrees
constexpr double insideFov = 60.0;       // degrees
constexpr double overviewMargin = 1.02;  // room around the box
constexpr double nearestFraction = 1e-3; // of the data's size: how near the near plane comes to an eye inside the data

View lookAt(const vec3d& eye, const vec3d& at, const vec3d& up, double fov, const Box3d& bounds, const PixelSize& size)
{
    const double diagonal = glm::length(bounds.extent());
    const double distance = glm::length(0.5 * (bounds.lower + bounds.upper) - eye);
    const double near = std::max(distance - 0.55 * diagonal, nearestFraction * diagonal);
    const double far = std::max(distance + 0.55 * diagonal, 2.0 * near);
    return viewOfCamera("view", eye, at, up, fov, size.width, size.height, near, far);
}

} // namespace

PixelSize parsePixelSize(const std::string& text, const std::string& option)
{
    PixelSize size;
    const char* end = text.data() + text.size();
    const auto width = std::from_chars(text.data(), end, size.width);
    if (width.ec == std::errc() && width.ptr != end && *width.ptr == 'x') {
        const auto height = std::from_chars(width.ptr + 1, end, size.height);
        constexpr int most = 32768;
        if (height.ec == std::errc() && height.ptr == end && size.width >= 1 && size.height >= 1 &&
            size.width <= most && size.height <= most)
            return size;
    }
    throw Error(option, fmt::format("expected WxH in pixels (1 to 32768), found \"{}\"", text));
}

View overview(const Box3d& bounds, const PixelSize& size)
{
    const vec3d towardsEye = glm::normalize(vec3d(-0.35, 0.35, 1.0));
    const vec3d right = glm::normalize(glm::cross(vec3d(0, 1, 0), towardsEye));
    const vec3d up = glm::cross(towardsEye, right);
    const vec3d center = 0.5 * (bounds.lower + bounds.upper);
    const double tanUp = std::tan(glm::radians(overviewFov) / 2.0);
    const double tanRight = tanUp * size.width / size.height;

    double distance = 0.0; // at which every corner is inside the frustum
    for (const vec3d& corner : cornersOf(bounds)) {
        const vec3d p = corner - center;
        const double needed = std::max(std::abs(glm::dot(p, right)) / tanRight, std::abs(glm::dot(p, up)) / tanUp);
        distance = std::max(distance, glm::dot(p, towardsEye) + overviewMargin * needed);
    }
    return lookAt(center + distance * towardsEye, center, vec3d(0, 1, 0), overviewFov, bounds, size);
}

View insideView(const Box3d& bounds, const PixelSize& size)
{
    const auto inside = [&](const vec3d& part) { return bounds.lower + part * bounds.extent(); };
    return lookAt(inside({0.25, 0.6, 0.6}), inside({0.75, 0.4, 0.4}), vec3d(0, 1, 0), insideFov, bounds, size);
}

View cameraView(const std::vector<double>& n, double fovDegrees, const Box3d& bounds, const PixelSize& size)
{
    if (n.size() != 9)
        throw Error("--camera", fmt::format("expected nine numbers (eye, at, up), found {}", n.size()));
    return lookAt({n[0], n[1], n[2]}, {n[3], n[4], n[5]}, {n[6], n[7], n[8]}, fovDegrees, bounds, size);
}

} // namespace brickwall
