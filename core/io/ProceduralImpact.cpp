// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/ProceduralNoise.h"
#include "brickwall/core/io/ProceduralSet.h"

#include <algorithm>
#include <cmath>

#include <glm/geometric.hpp>

namespace brickwall {
namespace {

constexpr double width = 48.0;    // of the domain, in kilometres
constexpr double ambient = 0.025; // electronvolt, of air

/// A blast wave: `skin` is the width of its front.
struct Shell
{
    vec3d centre;
    double radius, skin;
    double peak, inside; ///< temperature behind the front and further in, above ambient
    std::uint32_t seed;
};

/// How far inside the wrinkled front, in front widths; below 0 outside.
double depthInside(const Shell& shell, const vec3d& p)
{
    const vec3d q = p - shell.centre;
    const double r = std::sqrt(glm::dot(q, q));
    if (std::abs(r - shell.radius) > 0.1 * shell.radius + 60.0 * shell.skin)
        return r < shell.radius ? 1e3 : -1e3;
    const vec3d direction = r > 0.0 ? q * (1.0 / r) : vec3d(0.0); // the centre has no direction, and is deep inside
    const double wrinkle =
        0.03 * gradientNoise(3.0 * direction, shell.seed) + 0.012 * gradientNoise(9.0 * direction, shell.seed);
    return (shell.radius * (1.0 + wrinkle) - r) / shell.skin;
}

/// What a front adds at a depth: a sharp rise, then a fall towards what is inside.
double behindFront(double depth, double peak, double inside)
{
    if (depth <= 0.0)
        return 0.0;
    const double spike = depth > 60.0 ? 0.0 : (peak - inside) * portableExp(-0.22 * depth);
    return smoothStep(0.0, 3.0, depth) * (inside + spike);
}

/// The set's geometry for one width of a finest cell. The smaller a blast, the hotter and the thinner is its front.
struct Impact
{
    Shell burst, ground, first;
    double skin;

    explicit Impact(double cell)
        : burst{{1.9, -0.6, 2.9}, 1.25, 1.0 * cell, 2.2, 0.7, 31},
          ground{{0.0, 0.0, 0.0}, 3.0, 2.0 * cell, 1.3, 0.3, 32},
          first{{3.2, -1.0, 6.0}, 4.6, 4.0 * cell, 1.1, 0.15, 33},
          skin(cell)
    {
    }

    /// A stem with a rolled cap over the place of impact: depth inside its skin in front widths.
    double plumeDepth(const vec3d& p) const
    {
        const double rho = std::sqrt(p.x * p.x + p.y * p.y);
        if (rho > 1.2 || p.z > 3.0)
            return -1e3;
        const double wrinkle = 0.09 * gradientNoise(3.1 * p, 34) + 0.05 * gradientNoise(7.3 * p, 35);
        const double stem = (p.z < 2.1 ? 0.16 + 0.3 * smoothStep(0.0, 0.7, 0.7 - p.z) : -1.0) - rho;
        const double dr = rho - 0.5, dz = p.z - 2.1;
        const double cap = 0.32 - std::sqrt(dr * dr + dz * dz);
        return (std::max(stem, cap) + wrinkle) / (2.0 * skin);
    }

    double temperature(const vec3d& p) const
    {
        return ambient + behindFront(depthInside(burst, p), burst.peak, burst.inside) +
               behindFront(depthInside(ground, p), ground.peak, ground.inside) +
               behindFront(depthInside(first, p), first.peak, first.inside) + behindFront(plumeDepth(p), 1.6, 0.7);
    }

    /// Air thins upwards (scale height 8 km); a strong shock packs it six times denser and leaves little behind.
    double density(const vec3d& p) const
    {
        double factor = 1.0;
        for (const Shell* shell : {&burst, &ground, &first}) {
            const double depth = depthInside(*shell, p);
            factor *= 1.0 + behindFront(depth, 5.0, -0.7);
        }
        return 1.2e-3 * portableExp(-std::max(p.z, 0.0) / 8.0) * factor;
    }
};

} // namespace

ProceduralSet proceduralImpact(std::uint64_t cells)
{
    // Skins have area: their cells grow with the square of the resolution. Few root blocks and more levels keep the
    // rest coarse.
    int across = std::max(2, int(3.0 * std::sqrt(double(cells) / 1.5e6) + 0.5));
    int levels = 7;
    for (; across >= 6; across = (across + 1) / 2)
        ++levels;
    ProceduralSet set;
    set.name = "impact";
    set.rootBlocks = vec3i(across);
    set.levels = levels;
    set.cells = cells;
    set.worldFromVoxel = worldFromGrid({-0.5 * width, -0.5 * width, 0.0}, width, across, levels);
    const Impact impact(set.worldFromVoxel[0][0]);
    set.fields = {{"tev", "eV", [impact](const vec3d& p) { return impact.temperature(p); }},
                  {"density", "g/cm^3", [impact](const vec3d& p) { return impact.density(p); }}};
    set.refinedBy = set.fields[0].value;
    return set;
}

} // namespace brickwall
