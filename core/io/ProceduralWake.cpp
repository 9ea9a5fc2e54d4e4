// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/ProceduralNoise.h"
#include "brickwall/core/io/ProceduralSet.h"

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/geometric.hpp>

namespace brickwall {
namespace {

constexpr double ballRadius = 0.5;
constexpr double ringSpacing = 0.9;
constexpr double firstRing = 0.95; // x of its centre
constexpr int ringCount = 13;

/// A vortex ring of the street. They leave the ball alternately above and below, lean over, grow and fade.
struct Ring
{
    vec3d centre;
    vec3d axis;
    double radius, core, strength;
};

Ring ringAt(int n)
{
    const double x = firstRing + n * ringSpacing;
    const double side = n % 2 == 0 ? 1.0 : -1.0;
    const double age = double(n) / ringCount;
    // The row wanders around the axis, as shedding does that has no preferred plane.
    const double wander = 0.35 * gradientNoise({0.4 * n + 0.3, 0.5, 0.5}, 71);
    return {vec3d(x, wander, side * (0.16 + 0.22 * age)), glm::normalize(vec3d(1.0, 0.3 * wander, -side * 0.75)),
            0.42 + 0.34 * age, 0.09 + 0.09 * age, 0.62 * (1.0 - 0.55 * age) * smoothStep(0.0, 0.8, x)};
}

const std::array<Ring, ringCount>& rings()
{
    static const std::array<Ring, ringCount> all = [] {
        std::array<Ring, ringCount> made;
        for (int n = 0; n < ringCount; ++n)
            made[n] = ringAt(n);
        return made;
    }();
    return all;
}

/// The velocity around the ring's core line, cut off smoothly at some core widths; against the stream inside the ring.
vec3d swirl(const Ring& ring, const vec3d& p)
{
    const vec3d q = p - ring.centre;
    const double reach = 5.0 * ring.core;
    const double outer = ring.radius + reach;
    if (glm::dot(q, q) > outer * outer)
        return vec3d(0.0);
    const double height = glm::dot(q, ring.axis);
    const vec3d radial = q - height * ring.axis;
    const double rho = std::sqrt(glm::dot(radial, radial) + 1e-12);
    const double off = rho - ring.radius;
    const double s2 = height * height + off * off;
    if (s2 >= reach * reach)
        return vec3d(0.0);
    const double cut = 1.0 - s2 / (reach * reach);
    const double turn = ring.strength * ring.core * cut * cut / (s2 + ring.core * ring.core);
    // On the axis a radial direction does not exist; there the radial part fades.
    const double inward = rho / (rho + 0.1 * ring.radius);
    return 2.0 * turn * (off * ring.axis - height * inward / rho * radial);
}

/// Potential flow past a ball in a stream of speed 1 along x.
vec3d potentialFlow(const vec3d& p, double r)
{
    const double a3 = ballRadius * ballRadius * ballRadius, r3 = r * r * r;
    return vec3d(1.0 + 0.5 * a3 / r3, 0.0, 0.0) - (1.5 * a3 * p.x / (r3 * r * r)) * p;
}

/// How much of the stream is missing behind the ball: dead water, then a wake that widens and fills up.
double deficit(double x, double rho2)
{
    if (x <= 0.0)
        return 0.0;
    const double width = 0.40 + 0.16 * std::sqrt(x);
    const double depth = smoothStep(0.0, 0.7, x) * 1.05 / (1.0 + 0.30 * x);
    const double t = rho2 / (width * width);
    return t > 12.0 ? 0.0 : depth * portableExp(-t);
}

/// The street of vortices and the small eddies between them.
vec3d disturbance(const vec3d& p, double rho2)
{
    const double width = 0.75 + 0.11 * std::max(p.x, 0.0);
    const double inside = smoothStep(0.25, 1.0, p.x) * (1.0 - smoothStep(0.6, 1.5, std::sqrt(rho2) / width));
    if (inside <= 0.0)
        return vec3d(0.0);
    const double rough = 0.25 + 0.75 * smoothStep(0.5, 6.0, p.x);
    const vec3d slow = gradientNoise3(1.3 * p, 1);
    const vec3d warped = p + 0.30 * rough * slow;
    vec3d v(0.0);
    const int near = int(std::floor((warped.x - firstRing) / ringSpacing + 0.5));
    for (int n = std::max(near - 1, 0); n <= std::min(near + 1, ringCount - 1); ++n)
        v += swirl(rings()[n], warped);
    v += 0.13 * rough * gradientNoise3(5.0 * warped, 4);
    return inside * v;
}

vec3d velocity(const vec3d& p)
{
    const double r = std::sqrt(glm::dot(p, p));
    if (r <= ballRadius)
        return vec3d(0.0);
    const double rho2 = p.y * p.y + p.z * p.z;
    // The boundary layer: thin in front, thicker towards the back.
    const double layer = 0.06 + 0.05 * (1.0 + p.x / r);
    const double slip = smoothStep(0.0, layer, r - ballRadius);
    return slip * (potentialFlow(p, r) - vec3d(deficit(p.x, rho2), 0.0, 0.0) + disturbance(p, rho2));
}

double speed(const vec3d& p)
{
    const vec3d v = velocity(p);
    return std::sqrt(glm::dot(v, v));
}

} // namespace

ProceduralSet proceduralWake(std::uint64_t cells)
{
    // On four levels about a tenth of the domain's volume ends on the finest one; the root grid follows the number of
    // cells.
    const int across = std::max(1, int(std::cbrt(double(cells) / 16000.0) + 0.5));
    ProceduralSet set;
    set.name = "wake";
    set.fields = {{"speed", "", speed},
                  {"u", "", [](const vec3d& p) { return velocity(p).x; }},
                  {"v", "", [](const vec3d& p) { return velocity(p).y; }},
                  {"w", "", [](const vec3d& p) { return velocity(p).z; }},
                  {"pressure", "", [](const vec3d& p) { return 0.5 * (1.0 - glm::dot(velocity(p), velocity(p))); }}};
    set.refinedBy = speed;
    set.rootBlocks = {2 * across, across, across};
    set.levels = 4;
    set.cells = cells;
    set.worldFromVoxel = worldFromGrid({-2.0, -3.0, -3.0}, 12.0, 2 * across, set.levels);
    return set;
}

} // namespace brickwall
