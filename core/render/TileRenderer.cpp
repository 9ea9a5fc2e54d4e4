// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/TileRenderer.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

/// Opaque grey, lit from the eye from both sides, linear.
float surfaceShade(const TriangleHit& hit, const vec3d& direction)
{
    const double cosine = std::abs(glm::dot(vec3d(hit.normal), glm::normalize(direction)));
    return static_cast<float>(0.8 * (0.2 + 0.8 * cosine));
}

/// Null beyond the ray's last one.
const SurfaceHit* hitAt(const SurfaceHits& hits, int ray, std::uint32_t number)
{
    const std::uint32_t index = hits.first[ray] + number;
    return index < hits.first[ray + 1] ? &hits.hits[index] : nullptr;
}

void addSurface(const IsoSurface& surface, const SurfaceHit& hit, int ray, TileResult& result)
{
    const float weight = result.transmittance[ray] * surface.opacity;
    for (int c = 0; c < 3; ++c)
        result.color[c][ray] += weight * surface.color[c] * hit.shade;
    result.weightedDistance[ray] += weight * static_cast<float>(hit.t);
    result.transmittance[ray] *= 1.0f - surface.opacity;
}

} // namespace

TileRenderer::TileRenderer(const ViewRays& rays, const TileScene& scene, const RenderSettings& settings)
    : rays_(rays), scene_(scene), settings_(settings)
{
    scene_.volume.origin = rays.origin();
    if (scene_.triangles && scene_.triangles->empty())
        scene_.triangles = nullptr;
}

TileCounts& TileCounts::operator+=(const TileCounts& other)
{
    trace += other.trace;
    surfaceHits += other.surfaceHits;
    largestBound = std::max(largestBound, other.largestBound);
    pixelsBeyond += other.pixelsBeyond;
    return *this;
}

void TileRenderer::integrate(const RayTile& tile, TileResult& result) const
{
    const bool headlight = settings_.shading == Shading::headlight;
    const StepParameters steps{settings_.step.dt, settings_.step.terminationOpacity, headlight};
    switch (settings_.method) {
    case Method::bounded:
        return traceBounded(scene_.volume, {settings_.bounded.tolerance, headlight}, tile, result);
    case Method::fixed:
        return traceFixed(scene_.volume, steps, tile, result);
    case Method::midpoint:
        return traceMidpoint(scene_.volume, steps, tile, result);
    case Method::bracket:
        return traceBracket(scene_.volume, steps, tile, result);
    case Method::preintegrated:
        return tracePreintegrated(scene_.volume, steps, tile, result);
    case Method::reference:
        return traceReference(*scene_.reference, scene_.volume.origin, tile, result);
    }
}

void TileRenderer::trace(const RayTile& tile, TileResult& result, SurfaceHits& hits) const
{
    if (scene_.surfaces.empty() || settings_.method == Method::reference) // which composites its surfaces itself
        return integrate(tile, result);
    findSurfaces(scene_.volume, scene_.surfaceNodes, scene_.surfaces, settings_.shading == Shading::headlight, tile,
                 hits, result.counts);
    RayTile part = tile;
    bool more = true;
    for (std::uint32_t pass = 0; more; ++pass) {
        more = false;
        for (int i = 0; i < tile.count; ++i) {
            if (const SurfaceHit* hit = hitAt(hits, i, pass); hit && part.tNear[i] < part.tFar[i])
                part.tFar[i] = std::clamp(static_cast<float>(hit->t), part.tNear[i], tile.tFar[i]);
        }
        integrate(part, result);
        for (int i = 0; i < tile.count; ++i) {
            const SurfaceHit* hit = hitAt(hits, i, pass);
            part.tNear[i] = part.tFar[i];
            part.tFar[i] = tile.tFar[i];
            more = more || hit;
            if (hit)
                addSurface(scene_.surfaces[std::size_t(hit->surface)], *hit, i, result);
            if (!hit || !(result.transmittance[i] > 0.0f))
                part.tNear[i] = part.tFar[i];
        }
    }
}

TileCounts TileRenderer::countsOf(const RayTile& tile, const TileResult& result, const SurfaceHits& hits) const
{
    TileCounts counts;
    counts.trace = result.counts;
    counts.surfaceHits = hits.hits.size();
    for (int i = 0; i < tile.count; ++i) {
        counts.largestBound = std::max(counts.largestBound, result.error[i]);
        counts.pixelsBeyond += result.error[i] > settings_.bounded.tolerance;
    }
    return counts;
}

TileCounts TileRenderer::render(int x, int y, Frame& frame) const
{
    TilePixels pixels;
    RayTile tile;
    TileResult result;
    rays_.fill(x, y, pixels, tile);

    std::array<TriangleHit, RayTile::capacity> hits{};
    if (scene_.triangles) {
        std::array<vec3d, RayTile::capacity> origins;
        origins.fill(rays_.view().eye);
        const auto count = static_cast<std::size_t>(pixels.count);
        scene_.triangles->intersect(std::span(origins).first(count), std::span(pixels.worldDirection).first(count),
                                    std::span(hits).first(count));
    }
    for (int i = 0; i < pixels.count; ++i) {
        const double scene = rays_.sceneAt(i, pixels);
        hits[i].hit = hits[i].hit && hits[i].t < scene;
        if (const double end = hits[i].hit ? double(hits[i].t) : scene; std::isfinite(end))
            rays_.endAt(i, end, pixels, tile);
    }
    SurfaceHits surfaceHits;
    trace(tile, result, surfaceHits);

    for (int i = 0; i < pixels.count; ++i) {
        const float through = result.transmittance[i];
        vec4f color(result.color[0][i], result.color[1][i], result.color[2][i], 1.0f - through);
        double weight = color.a, distance = result.weightedDistance[i];
        // Where there is next to no opacity, rounding would throw the mean far off.
        double mean = weight > 0.0 ? std::clamp(distance / weight, double(tile.tNear[i]), double(tile.tFar[i])) : 0.0;
        if (hits[i].hit) {
            const float shade = surfaceShade(hits[i], pixels.worldDirection[i]);
            color += vec4f(vec3f(through * shade), through);
            mean = weight * mean + through * rays_.tileFromWorld(i, hits[i].t, pixels);
            weight = 1.0;
        }
        const std::size_t index = frame.index(pixels.x[i], pixels.y[i]);
        frame.color[index] = color;
        const float depth = rays_.depthAt(i, rays_.worldFromTile(i, mean, pixels), pixels);
        // Not even by rounding may it lie behind the scene that the pixel is drawn over.
        frame.depth[index] = weight > 0.0 ? std::min(depth, rays_.sceneDepthAt(i, pixels)) : 1.0f;
    }
    return countsOf(tile, result, surfaceHits);
}

} // namespace brickwall
