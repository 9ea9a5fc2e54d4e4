// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/AmbientVisibility.h"

#include <glm/geometric.hpp>

#include <array>
#include <cmath>
#include <numbers>

namespace brickwall {
namespace {

using Sample = std::array<double, 2>; ///< of the unit square

/// The additive sequence of the plastic number, low in discrepancy for any count (Roberts, The unreasonable
/// effectiveness of quasirandom sequences, 2018).
std::vector<Sample> squareSamples(int count)
{
    constexpr double plastic = 1.32471795724474602596;
    std::vector<Sample> samples;
    for (int i = 0; i < count; ++i)
        samples.push_back({(i + 0.5) / count, std::fmod(0.5 + (i + 1) / (plastic * plastic), 1.0)});
    return samples;
}

/// Directions about a normal of unit length, as many as their cosine: the disc below the half sphere is met evenly
/// (Malley). The base is that of Duff et al., Building an orthonormal basis, revisited, 2017.
vec3d aroundNormal(const vec3d& normal, const Sample& sample)
{
    const double sign = std::copysign(1.0, normal.z);
    const double a = -1.0 / (sign + normal.z), b = normal.x * normal.y * a;
    const vec3d first(1.0 + sign * normal.x * normal.x * a, sign * b, -sign * normal.x);
    const vec3d second(b, sign + normal.y * normal.y * a, -normal.y);
    const double radius = std::sqrt(sample[0]), angle = 2.0 * std::numbers::pi * sample[1];
    return radius * std::cos(angle) * first + radius * std::sin(angle) * second + std::sqrt(1.0 - sample[0]) * normal;
}

Sample turned(const Sample& sample, double offset)
{
    // Two numbers from one: the second one's digits are those that the first one shows least of.
    return {std::fmod(sample[0] + offset, 1.0), std::fmod(sample[1] + 4096.0 * offset, 1.0)};
}

} // namespace

AmbientVisibility::AmbientVisibility(const SecondaryRays& rays, const AmbientOcclusion& settings)
    : rays_(rays), distance_(settings.distance), samples_(squareSamples(settings.rays))
{
}

void AmbientVisibility::from(const PerRay<SurfacePoint>& points, const PerRay<float>& offsets, int count,
                             PerRay<float>& visibility, TraceCounts& counts) const
{
    PerRay<int> seen{};
    PerRay<float> through{};
    for (const Sample& sample : samples_) {
        RayTile rays;
        std::array<int, RayTile::capacity> rayOf;
        for (int i = 0; i < count; ++i) {
            if (!points[i].wanted || points[i].normal == vec3d(0.0))
                continue;
            const vec3d direction = glm::normalize(aroundNormal(points[i].normal, turned(sample, offsets[i])));
            const vec3d start = rays_.above(points[i].position, points[i].normal);
            ++seen[i];
            if (rays_.blocked(start, direction, distance_))
                continue;
            rayOf[rays.count] = i;
            rays_.append(start, direction, distance_, rays);
        }
        TileResult result;
        rays_.passSurfaces(rays, result);
        for (int r = 0; r < rays.count; ++r)
            through[rayOf[r]] += result.transmittance[r];
        counts += result.counts;
    }
    for (int i = 0; i < count; ++i)
        if (seen[i] > 0)
            visibility[i] = through[i] / float(seen[i]);
}

} // namespace brickwall
