// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/SecondaryRays.h"
#include "brickwall/core/shade/SurfaceLook.h"

#include <array>
#include <vector>

namespace brickwall {

/// How much of what comes from everywhere reaches points of surfaces (AmbientOcclusion). Any number of threads may ask.
class AmbientVisibility
{
public:
    template <class T>
    using PerRay = RayTile::PerRay<T>;

    /// The rays are borrowed.
    AmbientVisibility(const SecondaryRays& rays, const AmbientOcclusion& settings);

    /// Of the first `count` points that are wanted and have a normal; the others' numbers stay. `offsets`, in [0, 1),
    /// turn the directions of each point, so that too few of them look like noise and not like steps.
    void from(const PerRay<SurfacePoint>& points, const PerRay<float>& offsets, int count, PerRay<float>& visibility,
              TraceCounts& counts) const;

private:
    const SecondaryRays& rays_;
    double distance_;
    std::vector<std::array<double, 2>> samples_; ///< of the unit square
};

} // namespace brickwall
