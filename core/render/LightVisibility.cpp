// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/LightVisibility.h"

#include <glm/geometric.hpp>

#include <array>
#include <limits>

namespace brickwall {
namespace {

RenderSettings towardsLight(RenderSettings settings)
{
    settings.shading = Shading::off;
    settings.bounded.tolerance = settings.light->tolerance;
    return settings;
}

} // namespace

LightVisibility::LightVisibility(const SecondaryRays& rays, const RenderSettings& settings)
    : rays_(rays),
      settings_(towardsLight(settings)),
      towards_(glm::normalize(settings.light->towards)),
      ambient_(settings.light->ambient)
{
}

void LightVisibility::from(const PerRay<vec3d>& points, const PerRay<bool>& wanted, int count,
                           PerRay<float>& visibility, TraceCounts& counts) const
{
    constexpr double farAway = std::numeric_limits<double>::infinity();
    RayTile shadow;
    std::array<int, RayTile::capacity> rayOf;
    for (int i = 0; i < count; ++i) {
        if (!wanted[i])
            continue;
        visibility[i] = 0.0f;
        if (rays_.blocked(points[i], towards_, farAway))
            continue;
        rayOf[shadow.count] = i;
        rays_.append(points[i], towards_, farAway, shadow);
    }
    if (shadow.count == 0)
        return;
    TileResult result;
    rays_.passSurfaces(shadow, result);
    for (int i = 0; i < shadow.count; ++i)
        if (result.transmittance[i] <= settings_.bounded.tolerance)
            shadow.tFar[i] = shadow.tNear[i]; // the rest of the volume changes next to nothing
    integrateVolume(rays_.scene().volume, rays_.scene().reference, settings_, shadow, result);
    for (int i = 0; i < shadow.count; ++i)
        visibility[rayOf[i]] = result.transmittance[i];
    counts += result.counts;
}

} // namespace brickwall
