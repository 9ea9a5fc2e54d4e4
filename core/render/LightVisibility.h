// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/SecondaryRays.h"

namespace brickwall {

/// How much of the settings' light reaches points of a scene. Any number of threads may ask.
class LightVisibility
{
public:
    template <class T>
    using PerRay = RayTile::PerRay<T>;

    /// The settings have a light. The rays are borrowed.
    LightVisibility(const SecondaryRays& rays, const RenderSettings& settings);

    /// Where the light is, in world space, unit length.
    const vec3d& towards() const { return towards_; }

    /// The transmittance towards the light from the points of the first `count` rays that are wanted; the others'
    /// numbers stay. What it costs is added to `counts`.
    void from(const PerRay<vec3d>& points, const PerRay<bool>& wanted, int count, PerRay<float>& visibility,
              TraceCounts& counts) const;

    /// The part of a colour that remains, for a visibility.
    float remains(float visibility) const { return ambient_ + (1.0f - ambient_) * visibility; }

private:
    const SecondaryRays& rays_;
    RenderSettings settings_; ///< of the rays towards the light
    vec3d towards_;
    float ambient_;
};

} // namespace brickwall
