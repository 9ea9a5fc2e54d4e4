// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/shade/IsoSurface.h"
#include "brickwall/core/trace/TraceTile.h"

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace brickwall {

/// Where a ray meets a surface B = c.
struct SurfaceHit
{
    double t = 0.0;           ///< along the tile's ray
    std::int32_t surface = 0; ///< index into the span of surfaces
    float shade = 1.0f;       ///< |cos| of gradient and ray as of Headlight in Radiance.h; 1 without light or gradient
    vec3f gradient{0.0f}; ///< of B, in the field's span per voxel; 0 without light, or too small to have a direction
};

/// The hits of a tile's rays. Reused from tile to tile it stops allocating.
struct SurfaceHits
{
    std::vector<SurfaceHit> hits;
    std::array<std::uint32_t, RayTile::capacity + 1> first{}; ///< hits of ray i: [first[i], first[i + 1]), ascending t
};

/// All hits of the rays in [tNear, tFar], up to the first behind which nothing is visible (accumulated opacity of the
/// hits at least 1 - 1e-6). Exact: the rays' floats, the cells' values and B's piecewise rational form are taken as
/// they are, roots are found in double, and the floats of lanes only say where there cannot be any.
///
/// Every connected part of { t : B(t) = c } is one hit, at its first point: a crossing, a touch, a stretch of ray on
/// which B is c. Roots closer to each other than double can tell (a ray that touches within rounding) are one. Where no
/// tent reaches there is no hit, and B on both sides of it has nothing to do with each other. `nodes` are those of
/// surfaceNodes. A ray's hits depend on that ray alone. Thread-safe.
void findSurfaces(const TraceScene& scene, std::span<const KdNode> nodes, std::span<const IsoSurface> surfaces,
                  bool headlight, const RayTile& rays, SurfaceHits& found, TraceCounts& counts);

} // namespace brickwall
