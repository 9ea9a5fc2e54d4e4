// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/LightVisibility.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace brickwall {
namespace {

/// Voxels.
constexpr double lift = 1e-3;

RenderSettings towardsLight(RenderSettings settings)
{
    settings.shading = Shading::off;
    settings.bounded.tolerance = settings.light->tolerance;
    return settings;
}

} // namespace

LightVisibility::LightVisibility(const TileScene& scene, const RenderSettings& settings)
    : scene_(scene),
      settings_(towardsLight(settings)),
      bounds_{0.5 * vec3d(scene.volume.regions->bounds.lower - scene.volume.origin),
              0.5 * vec3d(scene.volume.regions->bounds.upper - scene.volume.origin)},
      worldFromVoxel_(glm::translate(scene.worldFromVoxel, 0.5 * vec3d(scene.volume.origin))),
      voxelFromWorld_(glm::inverse(worldFromVoxel_)),
      worldTowards_(glm::normalize(settings.light->towards)),
      towards_(glm::normalize(transformVector(voxelFromWorld_, worldTowards_))),
      worldStretch_(float(glm::length(transformVector(worldFromVoxel_, towards_)) / stretchOf(worldFromVoxel_))),
      ambient_(settings.light->ambient)
{
}

vec3d LightVisibility::pointAt(const RayTile& rays, int ray, double t)
{
    vec3d point;
    for (int axis = 0; axis < 3; ++axis)
        point[axis] = rays.org[axis][ray] + t * rays.dir[axis][ray];
    return point;
}

vec3d LightVisibility::worldNormal(const vec3f& gradient, const RayTile& rays, int ray) const
{
    const vec3d normal = glm::transpose(glm::dmat3(voxelFromWorld_)) * vec3d(gradient);
    const double length = glm::length(normal);
    if (!(length > 0.0))
        return vec3d(0.0);
    double away = 0.0; // of the ray and the gradient, the same in both spaces but for a factor
    for (int axis = 0; axis < 3; ++axis)
        away += double(gradient[axis]) * rays.dir[axis][ray];
    return (away > 0.0 ? -1.0 / length : 1.0 / length) * normal;
}

void LightVisibility::onSurfaces(const PerRay<SurfacePoint>& points, int count, PerRay<float>& shades,
                                 TraceCounts& counts) const
{
    PerRay<vec3d> lifted{};
    PerRay<bool> faces{};
    PerRay<float> cosines{}, visibility{};
    for (int i = 0; i < count; ++i) {
        const SurfacePoint& point = points[i];
        if (!point.wanted)
            continue;
        const bool hasNormal = point.normal != vec3d(0.0);
        cosines[i] = hasNormal ? float(std::max(0.0, glm::dot(point.normal, worldTowards_))) : 1.0f;
        faces[i] = cosines[i] > 0.0f;
        // Off the surface, so that it is not in its own way: more than the rounding of floats there.
        const vec3d along = hasNormal ? glm::normalize(transformVector(voxelFromWorld_, point.normal)) : towards_;
        lifted[i] = point.position + (lift + 1e-6 * glm::length(point.position)) * along;
    }
    from(lifted, faces, count, visibility, counts);
    for (int i = 0; i < count; ++i)
        if (points[i].wanted)
            shades[i] = remains(cosines[i] * visibility[i]);
}

bool LightVisibility::blocked(const vec3d& point) const
{
    const vec3d org = transformPoint(worldFromVoxel_, point);
    TriangleHit hit;
    for (const TriangleScene* triangles : {scene_.triangles, scene_.occluders}) {
        if (triangles)
            triangles->intersect({&org, 1}, {&worldTowards_, 1}, {&hit, 1});
        if (hit.hit)
            return true;
    }
    return false;
}

void LightVisibility::setRay(const vec3d& point, RayTile& shadow) const
{
    auto inside = clip(bounds_, point, towards_);
    if (inside && !scene_.clip->isEverything())
        inside = clip(*scene_.clip, transformPoint(worldFromVoxel_, point), transformVector(worldFromVoxel_, towards_),
                      inside->first, inside->second);
    const int i = shadow.count++;
    for (int axis = 0; axis < 3; ++axis) {
        shadow.org[axis][i] = float(point[axis]);
        shadow.dir[axis][i] = float(towards_[axis]);
    }
    shadow.tNear[i] = inside ? float(inside->first) : 0.0f;
    shadow.tEnd[i] = shadow.tFar[i] = inside ? float(inside->second) : 0.0f;
    shadow.offset[i] = 0.5f;
    shadow.worldStretch[i] = worldStretch_;
}

void LightVisibility::passSurfaces(RayTile& shadow, TileResult& result) const
{
    if (scene_.surfaces.empty())
        return;
    SurfaceHits hits;
    findSurfaces(scene_.volume, scene_.surfaceNodes, scene_.surfaces, false, shadow, hits, result.counts);
    for (int i = 0; i < shadow.count; ++i) {
        for (std::uint32_t h = hits.first[i]; h < hits.first[i + 1]; ++h)
            result.transmittance[i] *= 1.0f - scene_.surfaces[std::size_t(hits.hits[h].surface)].opacity;
        if (result.transmittance[i] <= settings_.bounded.tolerance)
            shadow.tFar[i] = shadow.tNear[i]; // the rest of the volume changes next to nothing
    }
}

void LightVisibility::from(const PerRay<vec3d>& points, const PerRay<bool>& wanted, int count,
                           PerRay<float>& visibility, TraceCounts& counts) const
{
    RayTile shadow;
    std::array<int, RayTile::capacity> rayOf;
    for (int i = 0; i < count; ++i) {
        if (!wanted[i])
            continue;
        visibility[i] = 0.0f;
        if (blocked(points[i]))
            continue;
        rayOf[shadow.count] = i;
        setRay(points[i], shadow);
    }
    if (shadow.count == 0)
        return;
    TileResult result;
    passSurfaces(shadow, result);
    integrateVolume(scene_.volume, scene_.reference, settings_, shadow, result);
    for (int i = 0; i < shadow.count; ++i)
        visibility[rayOf[i]] = result.transmittance[i];
    counts += result.counts;
}

} // namespace brickwall
