// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/ClipRegion.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brickwall {
namespace {

void cutByPlane(const Plane& plane, const vec3d& org, const vec3d& dir, double& from, double& to)
{
    const double speed = glm::dot(plane.normal, dir), before = plane.offset - glm::dot(plane.normal, org);
    if (speed > 0.0)
        from = std::max(from, before / speed);
    else if (speed < 0.0)
        to = std::min(to, before / speed);
    else if (before > 0.0)
        to = from;
}

void cutBySphere(const Sphere& sphere, const vec3d& org, const vec3d& dir, double& from, double& to)
{
    const double length = glm::length(dir);
    const vec3d d = dir / length;
    const double middle = glm::dot(sphere.center - org, d);
    const vec3d nearest = org + middle * d - sphere.center;
    const double half = sphere.radius * sphere.radius - glm::dot(nearest, nearest);
    if (!(half > 0.0)) {
        to = from;
        return;
    }
    from = std::max(from, (middle - std::sqrt(half)) / length);
    to = std::min(to, (middle + std::sqrt(half)) / length);
}

} // namespace

void checkPlane(const Plane& plane, const std::string& place)
{
    if (!isFinite(plane.normal) || !std::isfinite(plane.offset) || !(glm::length(plane.normal) > 0.0))
        throw Error(place, fmt::format("expected a finite normal that is not 0, and a finite offset, found "
                                       "({:g}, {:g}, {:g}), {:g}",
                                       plane.normal.x, plane.normal.y, plane.normal.z, plane.offset));
}

void checkClipRegion(const ClipRegion& region)
{
    for (const Plane& plane : region.planes)
        checkPlane(plane, "clip plane");
    if (region.box && (!isFinite(region.box->lower) || !isFinite(region.box->upper) || region.box->empty()))
        throw Error("clip box", "expected finite corners, the lower below the upper in every axis");
    if (const auto& s = region.sphere; s && (!isFinite(s->center) || !std::isfinite(s->radius) || !(s->radius > 0.0)))
        throw Error("clip sphere", fmt::format("expected a finite centre and radius, above 0, found {:g}", s->radius));
}

std::optional<std::pair<double, double>> clip(const Box3d& box, const vec3d& org, const vec3d& dir)
{
    double t0 = 0.0, t1 = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (dir[axis] == 0.0) {
            if (org[axis] < box.lower[axis] || org[axis] >= box.upper[axis])
                return {};
            continue;
        }
        const double a = (box.lower[axis] - org[axis]) / dir[axis];
        const double b = (box.upper[axis] - org[axis]) / dir[axis];
        t0 = std::max(t0, std::min(a, b));
        t1 = std::min(t1, std::max(a, b));
    }
    if (!(t0 < t1))
        return {};
    return std::pair(t0, t1);
}

std::optional<std::pair<double, double>> clip(const ClipRegion& region, const vec3d& org, const vec3d& dir, double from,
                                              double to)
{
    for (const Plane& plane : region.planes)
        cutByPlane(plane, org, dir, from, to);
    if (region.sphere)
        cutBySphere(*region.sphere, org, dir, from, to);
    if (region.box) {
        const auto inside = clip(*region.box, org, dir);
        if (!inside)
            return {};
        from = std::max(from, inside->first);
        to = std::min(to, inside->second);
    }
    if (!(from < to))
        return {};
    return std::pair(from, to);
}

} // namespace brickwall
