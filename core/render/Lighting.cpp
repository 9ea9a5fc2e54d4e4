// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/Lighting.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>

namespace brickwall {

Lighting::Lighting(const TileScene& scene, const RenderSettings& settings)
    : rays_(scene),
      specular_(settings.specular),
      headlight_(settings.shading == Shading::headlight),
      ambientPart_(settings.light ? settings.light->ambient : 1.0f)
{
    if (settings.light)
        light_.emplace(rays_, settings);
    if (settings.ambientOcclusion)
        ambient_.emplace(rays_, *settings.ambientOcclusion);
}

void Lighting::shade(const PerRay<SurfacePoint>& points, const PerRay<float>& offsets, int count,
                     PerRay<SurfaceShade>& shades, TraceCounts& counts) const
{
    PerRay<float> light, ambient;
    light.fill(1.0f);
    ambient.fill(1.0f);
    if (light_)
        lookForLight(points, count, light, counts);
    if (ambient_)
        ambient_->from(points, offsets, count, ambient, counts);
    for (int i = 0; i < count; ++i)
        if (points[i].wanted)
            shades[i] = shadeOf(points[i], light[i], ambient[i]);
}

void Lighting::lookForLight(const PerRay<SurfacePoint>& points, int count, PerRay<float>& visibility,
                            TraceCounts& counts) const
{
    PerRay<vec3d> lifted{};
    PerRay<bool> faces{};
    for (int i = 0; i < count; ++i) {
        const SurfacePoint& point = points[i];
        if (!point.wanted)
            continue;
        const bool hasNormal = point.normal != vec3d(0.0);
        faces[i] = !hasNormal || glm::dot(point.normal, light_->towards()) > 0.0;
        visibility[i] = 0.0f;
        lifted[i] = rays_.above(point.position, hasNormal ? point.normal : light_->towards());
    }
    light_->from(lifted, faces, count, visibility, counts);
}

SurfaceShade Lighting::shadeOf(const SurfacePoint& point, float light, float ambient) const
{
    const bool hasNormal = point.normal != vec3d(0.0);
    const vec3d towards = light_ ? light_->towards() : point.toEye;
    const double cosine = hasNormal ? glm::dot(point.normal, towards) : 1.0;
    SurfaceShade shade;
    shade.of = light_ ? ambientPart_ * ambient + (1.0f - ambientPart_) * float(std::max(0.0, cosine)) * light
                      : ambient * point.headlight;
    const bool shines = specular_.strength > 0.0f && hasNormal && cosine > 0.0 && (light_ || headlight_);
    if (shines) {
        const double mirrored = glm::dot(2.0 * cosine * point.normal - towards, point.toEye);
        shade.specular = specular_.strength * light * float(std::pow(std::max(0.0, mirrored), specular_.shininess));
    }
    return shade;
}

} // namespace brickwall
