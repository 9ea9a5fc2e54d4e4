// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/Rig.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <set>
#include <utility>

namespace brickwall {
namespace {

/// How many world units a metre is. Throws for what is no similarity: near and far would have no single length.
double scaleOf(const mat4d& worldFromRoom, const std::string& place)
{
    constexpr double tolerance = 1e-4; // hosts multiply rotations in floats
    const vec3d x(worldFromRoom[0]), y(worldFromRoom[1]), z(worldFromRoom[2]);
    const double length = std::cbrt(glm::dot(glm::cross(x, y), z)), square = tolerance * length * length;
    const auto unequal = [&](const vec3d& v) { return !(std::abs(glm::length(v) - length) <= tolerance * length); };
    const auto oblique = [&](const vec3d& a, const vec3d& b) { return !(std::abs(glm::dot(a, b)) <= square); };
    if (!(length > 0.0) || !std::isfinite(length) || unequal(x) || unequal(y) || unequal(z) || oblique(x, y) ||
        oblique(y, z) || oblique(z, x))
        throw Error(place,
                    "expected worldFromRoom to be a rotation, one scale and a translation; found a stretched, sheared, "
                    "mirrored or singular one");
    return length;
}

std::vector<Eye> eyesOf(StereoMode mode)
{
    if (needsTwoEyes(mode))
        return {Eye::left, Eye::right};
    return {mode == StereoMode::left ? Eye::left : mode == StereoMode::right ? Eye::right : Eye::middle};
}

/// The eyes' halves are equally large; the middle column or row of an odd viewport stays empty.
PixelRect viewportOf(const Channel& channel, Eye eye)
{
    PixelRect r = channel.viewport;
    if (channel.stereo == StereoMode::horizontalSplit) {
        r.x += eye == Eye::right ? r.width - r.width / 2 : 0;
        r.width /= 2;
    }
    if (channel.stereo == StereoMode::verticalSplit) {
        r.y += eye == Eye::left ? r.height - r.height / 2 : 0;
        r.height /= 2;
    }
    return r;
}

std::string uniqueName(const Rig& rig, int number, Eye eye, std::set<std::string>& taken)
{
    const Channel& channel = rig.channels[number];
    std::string name = channel.name.empty() ? fmt::format("channel{}", number) : channel.name;
    if (channel.stereo != StereoMode::mono)
        name = fmt::format("{}-{}", name, toString(eye));
    std::string unique = name;
    for (int i = 2; !taken.insert(unique).second; ++i)
        unique = fmt::format("{}-{}", name, i);
    return unique;
}

/// World space.
struct Corners
{
    vec3d lowerLeft{0.0}, lowerRight{0.0}, upperRight{0.0};
};

/// The corners of a part of a screen, for a viewport that shows it with another number of pixels.
Corners partOf(const Corners& whole, const Screen& screen, const PixelRect& part)
{
    const vec3d across = (whole.lowerRight - whole.lowerLeft) / double(screen.pixelWidth);
    const vec3d upwards = (whole.upperRight - whole.lowerRight) / double(screen.pixelHeight);
    const vec3d lowerLeft = whole.lowerLeft + double(part.x) * across + double(part.y) * upwards;
    const vec3d lowerRight = lowerLeft + double(part.width) * across;
    return {lowerLeft, lowerRight, lowerRight + double(part.height) * upwards};
}

/// A part that is shown pixel by pixel is a tile of the whole screen's view, so that neighbours match bit for bit.
View viewOf(const Rig& rig, const Channel& channel, Eye eye, const std::string& name, const PixelRect& viewport,
            const mat4d& worldFromRoom, double scale)
{
    const Screen& screen = rig.screens[channel.screen];
    const vec3d eyeInWorld =
        transformPoint(worldFromRoom, eyePoint(rig.viewers[channel.viewer], eye, channel.lateralOffset));
    const Corners whole{transformPoint(worldFromRoom, screen.lowerLeft),
                        transformPoint(worldFromRoom, screen.lowerRight),
                        transformPoint(worldFromRoom, screen.upperRight)};
    const auto view = [&](const Corners& c, int width, int height) {
        return viewOfScreen(name, eyeInWorld, c.lowerLeft, c.lowerRight, c.upperRight, width, height, scale * rig.near,
                            scale * rig.far);
    };
    const PixelRect& part = channel.part;
    if (part.width == 0)
        return view(whole, viewport.width, viewport.height);
    if (part.width == viewport.width && part.height == viewport.height)
        return tileOf(view(whole, screen.pixelWidth, screen.pixelHeight), part);
    return view(partOf(whole, screen, part), viewport.width, viewport.height);
}

} // namespace

RigViews viewsOfRig(const Rig& rig, const mat4d& worldFromRoom)
{
    const std::string place = rig.name.empty() ? "rig" : fmt::format("rig '{}'", rig.name);
    checkRig(rig, place);
    const double scale = scaleOf(worldFromRoom, place);
    RigViews result;
    std::set<std::string> taken;
    for (int i = 0; i < int(rig.channels.size()); ++i) {
        const Channel& channel = rig.channels[i];
        for (const Eye eye : eyesOf(channel.stereo)) {
            const std::string name = uniqueName(rig, i, eye, taken);
            const PixelRect viewport = viewportOf(channel, eye);
            try {
                View view = viewOf(rig, channel, eye, name, viewport, worldFromRoom, scale);
                result.views.push_back({name, i, eye, viewport, std::move(view)});
            } catch (const Error& error) {
                result.refused.push_back({name, error.what()});
            }
        }
    }
    return result;
}

} // namespace brickwall
