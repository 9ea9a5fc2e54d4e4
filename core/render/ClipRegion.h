// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Box.h"

#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace brickwall {

/// { p : dot(normal, p) = offset } in world space; the normal may have any length above 0.
struct Plane
{
    vec3d normal{0.0, 0.0, 1.0};
    double offset = 0.0;

    bool operator==(const Plane&) const = default;
};

struct Sphere
{
    vec3d center{0.0};
    double radius = 1.0;

    bool operator==(const Sphere&) const = default;
};

/// The region of interest, in world space: of volume, isosurfaces and contour planes, what lies inside all of these is
/// there, and the rest is not (nor does it cast shadows). Triangles are not cut. All of it is convex, so that a ray has
/// one stretch inside, and what is cut is cut exactly.
struct ClipRegion
{
    std::vector<Plane> planes; ///< inside is where dot(normal, p) >= offset
    std::optional<Box3d> box;
    std::optional<Sphere> sphere;

    bool operator==(const ClipRegion&) const = default;

    bool isEverything() const { return planes.empty() && !box && !sphere; }
};

/// Throws Error naming `place` for what is not finite, and a normal without length.
void checkPlane(const Plane& plane, const std::string& place);
/// Throws Error for what is not finite, a normal without length, an empty box, and a radius that is not above 0.
void checkClipRegion(const ClipRegion& region);

/// The part of a ray with t >= 0 that lies in a box, of which the upper faces are no part; nothing if there is none.
std::optional<std::pair<double, double>> clip(const Box3d& box, const vec3d& org, const vec3d& dir);
/// The part of [from, to] in which a ray lies in the region.
std::optional<std::pair<double, double>> clip(const ClipRegion& region, const vec3d& org, const vec3d& dir, double from,
                                              double to);

} // namespace brickwall
