// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/SecondaryRays.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>

#include <algorithm>

namespace brickwall {
namespace {

/// Voxels.
constexpr double lift = 1e-3;

} // namespace

SecondaryRays::SecondaryRays(const TileScene& scene)
    : scene_(scene),
      bounds_{0.5 * vec3d(scene.volume.regions->bounds.lower - scene.volume.origin),
              0.5 * vec3d(scene.volume.regions->bounds.upper - scene.volume.origin)},
      worldFromVoxel_(glm::translate(scene.worldFromVoxel, 0.5 * vec3d(scene.volume.origin))),
      voxelFromWorld_(glm::inverse(worldFromVoxel_)),
      stretch_(stretchOf(worldFromVoxel_))
{
}

vec3d SecondaryRays::pointAt(const RayTile& rays, int ray, double t)
{
    vec3d point;
    for (int axis = 0; axis < 3; ++axis)
        point[axis] = rays.org[axis][ray] + t * rays.dir[axis][ray];
    return point;
}

vec3d SecondaryRays::worldDirection(const RayTile& rays, int ray) const
{
    return glm::normalize(
        transformVector(worldFromVoxel_, vec3d(rays.dir[0][ray], rays.dir[1][ray], rays.dir[2][ray])));
}

vec3d SecondaryRays::worldNormal(const vec3f& gradient, const RayTile& rays, int ray) const
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

vec3d SecondaryRays::above(const vec3d& position, const vec3d& normal) const
{
    const vec3d along = glm::normalize(transformVector(voxelFromWorld_, normal));
    return position + (lift + 1e-6 * glm::length(position)) * along;
}

bool SecondaryRays::blocked(const vec3d& point, const vec3d& direction, double distance) const
{
    const vec3d org = transformPoint(worldFromVoxel_, point);
    for (const TriangleScene* triangles : {scene_.triangles, scene_.occluders}) {
        TriangleHit hit;
        if (triangles)
            triangles->intersect({&org, 1}, {&direction, 1}, {&hit, 1});
        if (hit.hit && hit.t < distance)
            return true;
    }
    return false;
}

void SecondaryRays::append(const vec3d& point, const vec3d& direction, double distance, RayTile& rays) const
{
    const vec3d scaled = transformVector(voxelFromWorld_, direction);
    const double voxelsPerUnit = glm::length(scaled);
    const vec3d dir = scaled / voxelsPerUnit;
    auto inside = clip(bounds_, point, dir);
    if (inside && !scene_.clip->isEverything())
        inside = clip(*scene_.clip, transformPoint(worldFromVoxel_, point), transformVector(worldFromVoxel_, dir),
                      inside->first, inside->second);
    const int i = rays.count++;
    for (int axis = 0; axis < 3; ++axis) {
        rays.org[axis][i] = float(point[axis]);
        rays.dir[axis][i] = float(dir[axis]);
    }
    const double end = distance * voxelsPerUnit;
    const bool reaches = inside && inside->first < end;
    rays.tNear[i] = reaches ? float(inside->first) : 0.0f;
    rays.tEnd[i] = rays.tFar[i] = reaches ? float(std::min(inside->second, end)) : 0.0f;
    rays.offset[i] = 0.5f;
    rays.worldStretch[i] = float(1.0 / (voxelsPerUnit * stretch_));
}

void SecondaryRays::passSurfaces(const RayTile& rays, TileResult& result) const
{
    if (scene_.surfaces.empty())
        return;
    SurfaceHits hits;
    findSurfaces(scene_.volume, scene_.surfaceNodes, scene_.surfaces, false, rays, hits, result.counts);
    for (int i = 0; i < rays.count; ++i)
        for (std::uint32_t h = hits.first[i]; h < hits.first[i + 1]; ++h)
            result.transmittance[i] *= 1.0f - scene_.surfaces[std::size_t(hits.hits[h].surface)].opacity;
}

} // namespace brickwall
