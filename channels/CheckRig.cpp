// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/Rig.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>

namespace brickwall {
namespace {

std::string label(const char* kind, std::size_t number, const std::string& name)
{
    return name.empty() ? fmt::format("{} {}", kind, number) : fmt::format("{} {} '{}'", kind, number, name);
}

/// True if `inner` lies in (0, 0) to (width, height); sums in 64 bits, because the numbers come from files.
bool inside(const PixelRect& inner, int width, int height)
{
    return inner.x >= 0 && inner.y >= 0 && std::int64_t(inner.x) + inner.width <= width &&
           std::int64_t(inner.y) + inner.height <= height;
}

bool overlap(const PixelRect& a, const PixelRect& b)
{
    return std::int64_t(a.x) < std::int64_t(b.x) + b.width && std::int64_t(b.x) < std::int64_t(a.x) + a.width &&
           std::int64_t(a.y) < std::int64_t(b.y) + b.height && std::int64_t(b.y) < std::int64_t(a.y) + a.height;
}

std::string toString(const PixelRect& r)
{
    return fmt::format("{} x {} at ({}, {})", r.width, r.height, r.x, r.y);
}

void checkScreen(const Screen& s, const std::string& place)
{
    const vec3d across = s.lowerRight - s.lowerLeft, upwards = s.upperRight - s.lowerRight;
    const double area = glm::length(glm::cross(across, upwards));
    if (!isFinite(s.lowerLeft) || !std::isfinite(area) || !(area > 1e-12 * glm::length(across) * glm::length(upwards)))
        throw Error(place,
                    "the corners make no screen: expected lower left, lower right and upper right, three finite points "
                    "that are not on a line");
    if (s.pixelWidth < 0 || s.pixelHeight < 0 || (s.pixelWidth == 0) != (s.pixelHeight == 0))
        throw Error(place,
                    fmt::format("expected pixels in both directions, or 0 x 0 where they do not matter; found {} x {}",
                                s.pixelWidth, s.pixelHeight));
}

void checkViewer(const Viewer& v, const std::string& place)
{
    bool affine = v.roomFromHead[0].w == 0.0 && v.roomFromHead[1].w == 0.0 && v.roomFromHead[2].w == 0.0 &&
                  v.roomFromHead[3].w == 1.0;
    for (int c = 0; c < 4; ++c)
        affine = affine && isFinite(vec3d(v.roomFromHead[c]));
    if (!affine || !isFinite(v.leftEye) || !isFinite(v.rightEye))
        throw Error(place, "expected a finite head pose (last row 0 0 0 1) and finite eye points");
}

void checkIndex(const std::string& place, const char* kind, int index, std::size_t count)
{
    if (index < 0 || std::size_t(index) >= count)
        throw Error(place, fmt::format("expected the number of one of the {} {}s, found {}", count, kind, index));
}

void checkPart(const Channel& c, const Screen& screen, const std::string& place)
{
    if (c.part == PixelRect{})
        return;
    if (screen.pixelWidth == 0)
        throw Error(place, "shows a part of its screen, but the screen does not say how many pixels it has");
    if (c.part.width <= 0 || c.part.height <= 0 || !inside(c.part, screen.pixelWidth, screen.pixelHeight))
        throw Error(place, fmt::format("the part {} is not inside the screen's {} x {} pixels", toString(c.part),
                                       screen.pixelWidth, screen.pixelHeight));
}

void checkChannel(const Rig& rig, const Channel& c, const std::string& place)
{
    checkIndex(place, "screen", c.screen, rig.screens.size());
    checkIndex(place, "viewer", c.viewer, rig.viewers.size());
    if (c.window != -1) // a channel without a window can still be rendered; warningsOf says so
        checkIndex(place, "window", c.window, rig.windows.size());
    const int leastWidth = c.stereo == StereoMode::horizontalSplit ? 2 : 1;
    const int leastHeight = c.stereo == StereoMode::verticalSplit ? 2 : 1;
    if (c.viewport.width < leastWidth || c.viewport.height < leastHeight)
        throw Error(place, fmt::format("expected a viewport of at least {} x {} pixels, found {}", leastWidth,
                                       leastHeight, toString(c.viewport)));
    constexpr int largest = std::numeric_limits<int>::max();
    if (std::int64_t(c.viewport.x) + c.viewport.width > largest ||
        std::int64_t(c.viewport.y) + c.viewport.height > largest)
        throw Error(
            place, fmt::format("expected a viewport that ends at {} at most, found {}", largest, toString(c.viewport)));
    checkPart(c, rig.screens[c.screen], place);
    if (!std::isfinite(c.lateralOffset))
        throw Error(place, "expected a finite lateral offset of the eye");
}

/// How far the corner is from a right angle, degrees.
double obliqueness(const Screen& s)
{
    const vec3d across = glm::normalize(s.lowerRight - s.lowerLeft),
                upwards = glm::normalize(s.upperRight - s.lowerRight);
    return std::abs(std::asin(glm::clamp(glm::dot(across, upwards), -1.0, 1.0))) * 180.0 / std::numbers::pi;
}

void warnOfScreens(const Rig& rig, std::vector<std::string>& lines)
{
    constexpr double tolerance = 0.1; // degrees: corners in millimetres are good to that
    for (std::size_t i = 0; i < rig.screens.size(); ++i) {
        const Screen& s = rig.screens[i];
        if (const double degrees = obliqueness(s); degrees > tolerance)
            lines.push_back(
                fmt::format("{} is no rectangle: its sides are {:.3g} degrees off a right angle; look for a typing "
                            "error in its corners",
                            label("screen", i, s.name), degrees));
        bool used = false;
        for (const Channel& c : rig.channels)
            used = used || c.screen == int(i);
        if (!used)
            lines.push_back(fmt::format("{} is not used by any channel", label("screen", i, s.name)));
    }
}

void warnOfWindows(const Rig& rig, std::vector<std::string>& lines)
{
    for (std::size_t i = 0; i < rig.windows.size(); ++i)
        if (const Window& w = rig.windows[i]; w.width <= 0 || w.height <= 0)
            lines.push_back(fmt::format("{} has no pixels ({} x {})", label("window", i, w.name), w.width, w.height));
    for (std::size_t i = 0; i < rig.channels.size(); ++i) {
        const Channel& c = rig.channels[i];
        if (c.window == -1) {
            lines.push_back(fmt::format("{} has no window and is not shown", label("channel", i, c.name)));
        } else if (const Window& w = rig.windows[c.window];
                   w.width > 0 && w.height > 0 && !inside(c.viewport, w.width, w.height)) {
            lines.push_back(fmt::format("{}: its viewport {} leaves {}, which has {} x {} pixels",
                                        label("channel", i, c.name), toString(c.viewport),
                                        label("window", c.window, w.name), w.width, w.height));
        }
    }
}

/// Passive stereo in one quad-buffered window: each eye has its own buffer.
bool shareByBuffer(const Rig& rig, const Channel& a, const Channel& b)
{
    const bool leftAndRight = (a.stereo == StereoMode::left && b.stereo == StereoMode::right) ||
                              (a.stereo == StereoMode::right && b.stereo == StereoMode::left);
    return leftAndRight && rig.windows[a.window].quadBuffer;
}

void warnOfOverlaps(const Rig& rig, std::vector<std::string>& lines)
{
    for (std::size_t i = 0; i < rig.channels.size(); ++i)
        for (std::size_t j = i + 1; j < rig.channels.size(); ++j) {
            const Channel &a = rig.channels[i], &b = rig.channels[j];
            if (a.window == b.window && a.window != -1 && overlap(a.viewport, b.viewport) && !shareByBuffer(rig, a, b))
                lines.push_back(fmt::format("the viewports of {} ({}) and {} ({}) overlap", label("channel", i, a.name),
                                            toString(a.viewport), label("channel", j, b.name), toString(b.viewport)));
        }
}

} // namespace

void checkRig(const Rig& rig, const std::string& place)
{
    const auto at = [&](const char* kind, std::size_t i, const std::string& name) {
        return place.empty() ? label(kind, i, name) : place + ": " + label(kind, i, name);
    };
    for (std::size_t i = 0; i < rig.screens.size(); ++i)
        checkScreen(rig.screens[i], at("screen", i, rig.screens[i].name));
    for (std::size_t i = 0; i < rig.viewers.size(); ++i)
        checkViewer(rig.viewers[i], at("viewer", i, rig.viewers[i].name));
    for (std::size_t i = 0; i < rig.channels.size(); ++i)
        checkChannel(rig, rig.channels[i], at("channel", i, rig.channels[i].name));
    if (!(rig.near > 0.0) || !(rig.far > rig.near) || std::isinf(rig.near))
        throw Error(place,
                    fmt::format("expected 0 < near < far, found near = {:g} and far = {:g} metres", rig.near, rig.far));
}

std::vector<std::string> warningsOf(const Rig& rig)
{
    const RigViews views = viewsOfRig(rig, mat4d(1.0));
    std::vector<std::string> lines;
    warnOfScreens(rig, lines);
    warnOfWindows(rig, lines);
    warnOfOverlaps(rig, lines);
    for (const RefusedView& refused : views.refused)
        lines.push_back(refused.reason);
    return lines;
}

} // namespace brickwall
