// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/RigFilesOrientation.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <numbers>

namespace brickwall {
namespace {

struct SineCosine
{
    double s;
    double c;
};

/// std::sin of 90 degrees' multiples is off by rounding, which would show in every corner of a CAVE.
SineCosine sineCosine(double degrees)
{
    const double quarters = degrees / 90.0;
    if (quarters == std::floor(quarters)) {
        const int quadrant = int(((long long)(std::fmod(quarters, 4.0)) + 4) % 4);
        constexpr double sines[] = {0.0, 1.0, 0.0, -1.0};
        return {sines[quadrant], sines[(quadrant + 1) % 4]};
    }
    const double angle = degrees * (std::numbers::pi / 180.0);
    return {std::sin(angle), std::cos(angle)};
}

double degrees(double radians)
{
    const double angle = radians * (180.0 / std::numbers::pi);
    // Corners that went through a file in single precision or millimetres should come back as 90, not
    // as 89.99999999999.
    const double rounded = std::round(angle * 1e6) / 1e6;
    return (std::abs(angle - rounded) < 1e-9 ? rounded : angle) + 0.0;
}

} // namespace

glm::dmat3 rotationOf(const vec3d& headingPitchRoll)
{
    const auto [sh, ch] = sineCosine(headingPitchRoll.x);
    const auto [sp, cp] = sineCosine(headingPitchRoll.y);
    const auto [sr, cr] = sineCosine(headingPitchRoll.z);
    const vec3d x(ch * cr - sh * sp * sr, sh * cr + ch * sp * sr, -cp * sr);
    const vec3d y(-sh * cp, ch * cp, sp);
    const vec3d z(ch * sr + sh * sp * cr, sh * sr - ch * sp * cr, cp * cr);
    return glm::dmat3(x, y, z);
}

vec3d headingPitchRollOf(const glm::dmat3& rotation)
{
    const vec3d x = rotation[0], y = rotation[1], z = rotation[2];
    const double cosPitch = std::hypot(y.x, y.y);
    const double pitch = degrees(std::atan2(y.z, cosPitch));
    if (cosPitch < 1e-9)
        return {degrees(std::atan2(x.y, x.x)), pitch, 0.0};
    return {degrees(std::atan2(-y.x, y.y)), pitch, degrees(std::atan2(-x.z, z.z))};
}

void placeScreen(Screen& screen, const vec3d& center, double width, double height, const glm::dmat3& rotation)
{
    const vec3d right = rotation[0] * (width / 2.0);
    const vec3d up = rotation[2] * (height / 2.0);
    screen.lowerLeft = center - right - up;
    screen.lowerRight = center + right - up;
    screen.upperRight = center + right + up;
}

glm::dmat3 rotationOf(const Screen& screen)
{
    const vec3d right = glm::normalize(screen.lowerRight - screen.lowerLeft);
    const vec3d up = glm::normalize(screen.upperRight - screen.lowerRight);
    return glm::dmat3(right, glm::cross(up, right), up);
}

vec3d centerOf(const Screen& screen)
{
    return 0.5 * (screen.lowerLeft + screen.upperRight);
}

double widthOf(const Screen& screen)
{
    return glm::length(screen.lowerRight - screen.lowerLeft);
}

double heightOf(const Screen& screen)
{
    return glm::length(screen.upperRight - screen.lowerRight);
}

double skewOf(const Screen& screen)
{
    const glm::dmat3 rotation = rotationOf(screen);
    return glm::dot(rotation[0], rotation[2]);
}

Screen screenOfChannel(const Rig& rig, const Channel& channel)
{
    const Screen& whole = rig.screens[channel.screen];
    if (channel.part.width == 0)
        return whole;
    const vec3d right = (whole.lowerRight - whole.lowerLeft) / double(whole.pixelWidth);
    const vec3d up = (whole.upperRight - whole.lowerRight) / double(whole.pixelHeight);
    const PixelRect& part = channel.part;
    Screen screen;
    screen.name = channel.name;
    screen.lowerLeft = whole.lowerLeft + double(part.x) * right + double(part.y) * up;
    screen.lowerRight = screen.lowerLeft + double(part.width) * right;
    screen.upperRight = screen.lowerRight + double(part.height) * up;
    return screen;
}

} // namespace brickwall
