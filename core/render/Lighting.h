// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/AmbientVisibility.h"
#include "brickwall/core/render/LightVisibility.h"

#include <optional>

namespace brickwall {

/// What light makes of a surface's colour: color * of + specular, each component at most 1.
struct SurfaceShade
{
    float of = 1.0f;
    float specular = 0.0f;

    vec3f operator()(const vec3f& color) const { return glm::min(of * color + specular, vec3f(1.0f)); }
};

/// The light of a view, its highlights and its ambient occlusion, as the settings have them. Any number of threads may
/// ask.
class Lighting
{
public:
    template <class T>
    using PerRay = RayTile::PerRay<T>;

    /// The origin of the scene's volume has been set.
    Lighting(const TileScene& scene, const RenderSettings& settings);
    Lighting(const Lighting&) = delete;

    const SecondaryRays& rays() const { return rays_; }
    /// Null if there is none.
    const LightVisibility* light() const { return light_ ? &*light_ : nullptr; }

    /// Surfaces have more than a shade by the headlight. Else what follows need not be asked.
    bool changesSurfaces() const { return light_ || ambient_ || specular_.strength > 0.0f; }
    /// Of the first `count` points that are wanted; the others stay. `offsets` as for AmbientVisibility.
    void shade(const PerRay<SurfacePoint>& points, const PerRay<float>& offsets, int count,
               PerRay<SurfaceShade>& shades, TraceCounts& counts) const;

private:
    void lookForLight(const PerRay<SurfacePoint>& points, int count, PerRay<float>& visibility,
                      TraceCounts& counts) const;
    SurfaceShade shadeOf(const SurfacePoint& point, float light, float ambient) const;

    SecondaryRays rays_;
    std::optional<LightVisibility> light_;
    std::optional<AmbientVisibility> ambient_;
    Specular specular_;
    bool headlight_;
    float ambientPart_; ///< of the light
};

} // namespace brickwall
