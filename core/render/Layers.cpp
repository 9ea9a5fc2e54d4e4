// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/Layers.h"

#include "brickwall/core/trace/SamplePoints.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

namespace brickwall {
namespace {

/// Where the colours at a point (voxel space) come from: the field that has them, or nothing.
std::optional<vec3f> colorIn(const TileScene& scene, const PaddedField& field, const vec3d& voxel)
{
    const PointSample sample = sampleVoxel(*scene.volume.regions, field, voxel);
    if (!sample.valid)
        return {};
    return vec3f(colorAt(*scene.transferFunction, sample.value));
}

/// Where the ray meets a plane inside the data.
std::optional<Layer> cross(const ContourPlane& contour, const TileScene& scene, const ViewRays& view,
                           const TilePixels& pixels, const RayTile& tile, int ray)
{
    const Plane& plane = contour.plane;
    const double speed = glm::dot(plane.normal, pixels.worldDirection[ray]);
    if (speed == 0.0)
        return {};
    const double along = (plane.offset - glm::dot(plane.normal, view.view().eye)) / speed;
    Layer layer;
    layer.t = view.tileFromWorld(ray, along, pixels);
    // A plane where the data are cut is there: both were found by other ways, and differ by rounding.
    const double rounding = 1e-5 + 1e-6 * tile.tFar[ray];
    if (!(layer.t >= tile.tNear[ray] - rounding && layer.t <= tile.tFar[ray] + rounding))
        return {};
    const PaddedField* colorField = scene.volume.colors.field;
    const auto color = colorIn(scene, colorField ? *colorField : *scene.volume.field, view.voxelAt(ray, along, pixels));
    if (!color)
        return {};
    layer.color = *color;
    layer.opacity = contour.opacity;
    return layer;
}

/// Of a hit on a ray, as of the colour field. At the data's rim, or at that of a hole, rounding may put it outside:
/// then of a place that is next to it.
vec3f colorOf(const IsoSurface& surface, const TileScene& scene, const RayTile& tile, int ray, double t)
{
    const PaddedField* field = scene.volume.colors.field;
    if (!surface.coloredByField || !field)
        return surface.color;
    const vec3d start = 0.5 * vec3d(scene.volume.origin) + vec3d(tile.org[0][ray], tile.org[1][ray], tile.org[2][ray]);
    const vec3d direction(tile.dir[0][ray], tile.dir[1][ray], tile.dir[2][ray]);
    const double aside = 1e-4 * (1.0 + std::abs(t));
    for (const double where : {t, t - aside, t + aside})
        if (const auto color = colorIn(scene, *field, start + where * direction))
            return *color;
    return surface.color;
}

void addSurfaces(const TileScene& scene, const SurfaceHits& hits, bool shaded, const RayTile& tile, int ray,
                 std::vector<Layer>& layers)
{
    for (std::uint32_t h = hits.first[ray]; h < hits.first[ray + 1]; ++h) {
        const SurfaceHit& hit = hits.hits[h];
        const IsoSurface& surface = scene.surfaces[std::size_t(hit.surface)];
        layers.push_back(
            {hit.t, colorOf(surface, scene, tile, ray, hit.t), surface.opacity, hit.shade, shaded, hit.gradient});
    }
}

} // namespace

Layer* Layers::at(int ray, std::uint32_t number)
{
    const std::uint32_t index = first[ray] + number;
    return index < first[ray + 1] ? &layers[index] : nullptr;
}

Layers findLayers(const TileScene& scene, const ViewRays& view, bool shaded, const TilePixels& pixels,
                  const RayTile& tile, TraceCounts& counts)
{
    SurfaceHits hits;
    findSurfaces(scene.volume, scene.surfaceNodes, scene.surfaces, shaded, tile, hits, counts);
    Layers found;
    for (int i = 0; i < tile.count; ++i) {
        found.first[i] = static_cast<std::uint32_t>(found.layers.size());
        addSurfaces(scene, hits, shaded, tile, i, found.layers);
        for (const ContourPlane& plane : scene.planes)
            if (const auto layer = cross(plane, scene, view, pixels, tile, i))
                found.layers.push_back(*layer);
        std::stable_sort(found.layers.begin() + found.first[i], found.layers.end(),
                         [](const Layer& a, const Layer& b) { return a.t < b.t; });
    }
    std::fill(found.first.begin() + tile.count, found.first.end(), static_cast<std::uint32_t>(found.layers.size()));
    return found;
}

} // namespace brickwall
