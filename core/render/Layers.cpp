// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/Layers.h"

#include "brickwall/core/trace/SamplePoints.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <optional>

namespace brickwall {
namespace {

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
    const PointSample sample =
        sampleVoxel(*scene.volume.regions, *scene.volume.field, view.voxelAt(ray, along, pixels));
    if (!sample.valid)
        return {};
    layer.color = vec3f(colorAt(*scene.transferFunction, sample.value));
    layer.opacity = contour.opacity;
    return layer;
}

void addSurfaces(const TileScene& scene, const SurfaceHits& hits, bool shaded, int ray, std::vector<Layer>& layers)
{
    for (std::uint32_t h = hits.first[ray]; h < hits.first[ray + 1]; ++h) {
        const SurfaceHit& hit = hits.hits[h];
        const IsoSurface& surface = scene.surfaces[std::size_t(hit.surface)];
        layers.push_back({hit.t, surface.color, surface.opacity, hit.shade, shaded, hit.gradient});
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
        addSurfaces(scene, hits, shaded, i, found.layers);
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
