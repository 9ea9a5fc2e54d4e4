// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/TileRenderer.h"

#include "brickwall/core/render/LitVolume.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

void add(const Layer& layer, const SurfaceShade& shade, int ray, TileResult& result)
{
    const float weight = result.transmittance[ray] * layer.opacity;
    const vec3f color = shade(layer.color);
    for (int c = 0; c < 3; ++c)
        result.color[c][ray] += weight * color[c];
    result.weightedDistance[ray] += weight * static_cast<float>(layer.t);
    result.transmittance[ray] *= 1.0f - layer.opacity;
}

} // namespace

TileRenderer::TileRenderer(const ViewRays& rays, const TileScene& scene, const RenderSettings& settings)
    : rays_(rays), scene_(scene), settings_(settings)
{
    scene_.volume.origin = rays.origin();
    for (const TriangleScene** triangles : {&scene_.triangles, &scene_.occluders})
        if (*triangles && (*triangles)->empty())
            *triangles = nullptr;
    for (TileMember& member : scene_.pyramid)
        member.volume.origin = rays.origin();
    if (!(settings.lod.cellPixels > 0.0f) || settings.method == Method::reference)
        scene_.pyramid.clear();
    for (const TileMember& member : scene_.pyramid)
        levels_.push_back(member.level);
    lighting_ = std::make_unique<Lighting>(scene_, settings);
}

TileCounts& TileCounts::operator+=(const TileCounts& other)
{
    trace += other.trace;
    surfaceHits += other.surfaceHits;
    largestBound = std::max(largestBound, other.largestBound);
    pixelsBeyond += other.pixelsBeyond;
    for (std::size_t level = 0; level < memberSamples.size(); ++level)
        memberSamples[level] += other.memberSamples[level];
    return *this;
}

void TileRenderer::integrateIn(std::size_t member, const RayTile& tile, TileResult& result, TileCounts& counts) const
{
    const std::uint64_t before = result.counts.samples;
    integrateVolume(member == 0 ? scene_.volume : scene_.pyramid[member - 1].volume, scene_.reference, settings_, tile,
                    result);
    const int level = member == 0 ? 0 : scene_.pyramid[member - 1].level;
    counts.memberSamples[std::size_t(level)] += result.counts.samples - before;
}

void TileRenderer::integrateAll(const RayTile& tile, const TileMembers& members, TileResult& result,
                                TileCounts& counts) const
{
    if (scene_.pyramid.empty())
        return integrateIn(0, tile, result, counts);
    for (std::size_t m = 0; m < members.sections(); ++m) {
        const TileSection section = members.section(m, tile);
        TileResult coarser;
        if (section.anyCoarser) {
            coarser = result;
            coarser.counts = {};
            integrateIn(m + 1, section.coarser, coarser, counts);
        }
        if (section.anyFiner)
            integrateIn(m, section.finer, result, counts);
        if (section.anyCoarser) {
            mix(section, coarser, result);
            result.counts += coarser.counts;
        }
    }
}

void TileRenderer::integrate(const RayTile& tile, const TileMembers& members, TileResult& result,
                             TileCounts& counts) const
{
    const LightVisibility* light = lighting_->light();
    if (!light)
        return integrateAll(tile, members, result, counts);
    const auto dark = [&](const RayTile& part, TileResult& sum) { integrateAll(part, members, sum, counts); };
    integrateLit(dark, *settings_.light, *light, tile, result);
}

void TileRenderer::trace(const RayTile& tile, const TileMembers& members, Layers& layers, TileResult& result,
                         TileCounts& counts) const
{
    RayTile part = tile;
    bool more = true;
    for (std::uint32_t pass = 0; more; ++pass) {
        more = false;
        for (int i = 0; i < tile.count; ++i) {
            if (const Layer* layer = layers.at(i, pass); layer && part.tNear[i] < part.tFar[i])
                part.tFar[i] = std::clamp(static_cast<float>(layer->t), part.tNear[i], tile.tFar[i]);
        }
        integrate(part, members, result, counts);
        const RayTile::PerRay<SurfaceShade> shades = shadesOf(tile, pass, layers, result);
        for (int i = 0; i < tile.count; ++i) {
            const Layer* layer = layers.at(i, pass);
            part.tNear[i] = part.tFar[i];
            part.tFar[i] = tile.tFar[i];
            more = more || layer;
            if (layer)
                add(*layer, shades[i], i, result);
            if (!layer || !(result.transmittance[i] > 0.0f))
                part.tNear[i] = part.tFar[i];
        }
    }
}

RayTile::PerRay<SurfaceShade> TileRenderer::shadesOf(const RayTile& tile, std::uint32_t number, Layers& layers,
                                                     TileResult& result) const
{
    RayTile::PerRay<SurfacePoint> points;
    RayTile::PerRay<SurfaceShade> shades{};
    bool any = false;
    for (int i = 0; i < tile.count; ++i) {
        const Layer* layer = layers.at(i, number);
        if (!layer)
            continue;
        shades[i].of = settings_.shading == Shading::headlight ? layer->headlight : 1.0f;
        points[i].wanted = lighting_->changesSurfaces() && layer->isShaded && result.transmittance[i] > 0.0f;
        if (!points[i].wanted)
            continue;
        any = true;
        points[i].position = SecondaryRays::pointAt(tile, i, layer->t);
        points[i].normal = lighting_->rays().worldNormal(layer->gradient, tile, i);
        points[i].toEye = -lighting_->rays().worldDirection(tile, i);
        points[i].headlight = shades[i].of;
    }
    if (any)
        lighting_->shade(points, tile.offset, tile.count, shades, result.counts);
    return shades;
}

void TileRenderer::count(const RayTile& tile, const TileResult& result, const Layers& layers, TileCounts& counts) const
{
    counts.trace = result.counts;
    counts.surfaceHits = layers.layers.size();
    for (int i = 0; i < tile.count; ++i) {
        counts.largestBound = std::max(counts.largestBound, result.error[i]);
        counts.pixelsBeyond += result.error[i] > settings_.bounded.tolerance;
    }
}

void TileRenderer::intersect(const TriangleScene* triangles, const TilePixels& pixels,
                             RayTile::PerRay<TriangleHit>& hits) const
{
    if (!triangles)
        return;
    std::array<vec3d, RayTile::capacity> origins;
    origins.fill(rays_.view().eye);
    const auto count = static_cast<std::size_t>(pixels.count);
    triangles->intersect(std::span(origins).first(count), std::span(pixels.worldDirection).first(count),
                         std::span(hits).first(count));
}

TileRenderer::Ends TileRenderer::endRays(const TilePixels& pixels, RayTile& tile) const
{
    Ends ends{};
    RayTile::PerRay<TriangleHit> elsewhere{};
    intersect(scene_.triangles, pixels, ends.hits);
    intersect(scene_.occluders, pixels, elsewhere);
    for (int i = 0; i < pixels.count; ++i) {
        double end = rays_.sceneAt(i, pixels);
        ends.depth[i] = rays_.sceneDepthAt(i, pixels);
        if (elsewhere[i].hit && elsewhere[i].t < end) {
            end = elsewhere[i].t;
            ends.depth[i] = std::min(ends.depth[i], rays_.depthAt(i, end, pixels));
        }
        ends.hits[i].hit = ends.hits[i].hit && ends.hits[i].t < end;
        if (ends.hits[i].hit)
            end = ends.hits[i].t;
        if (std::isfinite(end))
            rays_.endAt(i, end, pixels, tile);
    }
    return ends;
}

RayTile::PerRay<SurfaceShade> TileRenderer::shadesOf(const TilePixels& pixels, const Ends& ends, const RayTile& tile,
                                                     TileResult& result) const
{
    RayTile::PerRay<SurfacePoint> points;
    RayTile::PerRay<SurfaceShade> shades{};
    for (int i = 0; i < pixels.count; ++i) {
        const TriangleHit& hit = ends.hits[i];
        if (!hit.hit)
            continue;
        const vec3d toEye = -glm::normalize(pixels.worldDirection[i]);
        const double cosine = glm::dot(vec3d(hit.normal), toEye);
        shades[i].of = static_cast<float>(0.2 + 0.8 * std::abs(cosine));
        points[i].wanted = lighting_->changesSurfaces() && result.transmittance[i] > 0.0f;
        if (!points[i].wanted)
            continue;
        points[i].position = lighting_->rays().pointOf(rays_.view().eye + double(hit.t) * pixels.worldDirection[i]);
        points[i].normal = (cosine < 0.0 ? -1.0 : 1.0) * vec3d(hit.normal);
        points[i].toEye = toEye;
        points[i].headlight = shades[i].of;
    }
    if (lighting_->changesSurfaces())
        lighting_->shade(points, tile.offset, pixels.count, shades, result.counts);
    return shades;
}

TileCounts TileRenderer::render(int x, int y, Frame& frame) const
{
    TilePixels pixels;
    RayTile tile;
    TileResult result;
    rays_.fill(x, y, pixels, tile);
    const Ends ends = endRays(pixels, tile);
    const bool shaded = lighting_->changesSurfaces() || settings_.shading == Shading::headlight;
    const bool hasLayers = !scene_.referenceHasSurfaces && !(scene_.surfaces.empty() && scene_.planes.empty());
    Layers layers = hasLayers ? findLayers(scene_, rays_, shaded, pixels, tile, result.counts) : Layers{};
    TileCounts counts;
    trace(tile, TileMembers(rays_, pixels, levels_, settings_.lod.cellPixels), layers, result, counts);
    const auto shades = scene_.triangles ? shadesOf(pixels, ends, tile, result) : RayTile::PerRay<SurfaceShade>{};

    for (int i = 0; i < pixels.count; ++i) {
        const float through = result.transmittance[i];
        vec4f color(result.color[0][i], result.color[1][i], result.color[2][i], 1.0f - through);
        double weight = color.a, distance = result.weightedDistance[i];
        // Where there is next to no opacity, rounding would throw the mean far off.
        double mean = weight > 0.0 ? std::clamp(distance / weight, double(tile.tNear[i]), double(tile.tFar[i])) : 0.0;
        if (ends.hits[i].hit) {
            color += through * vec4f(shades[i](ends.hits[i].color), 1.0f);
            mean = weight * mean + through * rays_.tileFromWorld(i, ends.hits[i].t, pixels);
            weight = 1.0;
        }
        const std::size_t index = frame.index(pixels.x[i], pixels.y[i]);
        frame.color[index] = color;
        const float depth = rays_.depthAt(i, rays_.worldFromTile(i, mean, pixels), pixels);
        // Not even by rounding may it lie behind the scene that the pixel is drawn over.
        frame.depth[index] = weight > 0.0 ? std::min(depth, ends.depth[i]) : 1.0f;
    }
    count(tile, result, layers, counts);
    return counts;
}

} // namespace brickwall
