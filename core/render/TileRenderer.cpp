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

struct Pixel
{
    vec4f color;
    float depth;
};

} // namespace

TileRenderer::TileRenderer(const ViewRays& rays, TraceScene scene, const TriangleScene* triangles,
                           const RenderSettings& settings)
    : rays_(rays),
      scene_(scene),
      triangles_(triangles && !triangles->empty() ? triangles : nullptr),
      settings_(settings)
{
    scene_.origin = rays.origin();
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
    const StepParameters steps{settings_.step.dt, settings_.step.terminationOpacity,
                               settings_.shading == Shading::headlight};
    switch (settings_.method) {
    case Method::bounded:
    case Method::fixed:
    case Method::midpoint:
    case Method::bracket:
    case Method::preintegrated:
    case Method::reference:
        return traceMidpoint(scene_, steps, tile, result);
    }
}

TileCounts TileRenderer::render(int x, int y, Frame& frame) const
{
    TilePixels pixels;
    RayTile tile;
    TileResult result;
    rays_.fill(x, y, pixels, tile);

    std::array<TriangleHit, RayTile::capacity> hits{};
    if (triangles_) {
        std::array<vec3d, RayTile::capacity> origins;
        origins.fill(rays_.view().eye);
        const auto count = static_cast<std::size_t>(pixels.count);
        triangles_->intersect(std::span(origins).first(count), std::span(pixels.worldDirection).first(count),
                              std::span(hits).first(count));
        for (int i = 0; i < pixels.count; ++i)
            if (hits[i].hit)
                rays_.endAt(i, hits[i].t, pixels, tile);
    }
    integrate(tile, result);

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
        frame.depth[index] = weight > 0.0 ? rays_.depthAt(i, rays_.worldFromTile(i, mean, pixels), pixels) : 1.0f;
    }
    TileCounts counts;
    counts.trace = result.counts;
    return counts;
}

} // namespace brickwall
