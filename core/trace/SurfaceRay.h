// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/trace/ExactPieces.h"
#include "brickwall/core/trace/Surfaces.h"

#include <span>
#include <vector>

namespace brickwall {

/// One ray on its search for surfaces, in double: the part of findSurfaces that decides. Stretches of the ray that are
/// left out between calls of `search` must not meet any of the surfaces.
class SurfaceRay
{
public:
    SurfaceRay(const TraceScene& scene, std::span<const IsoSurface> surfaces, bool headlight);

    /// Another ray, with nothing found.
    void begin(const RayTile& rays, int ray);

    /// Looks at the pieces of a region that meet [from, to], which come after all that were looked at before. False if
    /// nothing behind the hits so far is visible.
    bool search(std::uint32_t region, double from, double to);

    std::vector<SurfaceHit> hits;
    TraceCounts counts;

private:
    bool visit(const ExactPieces& piece, const Region& region);
    bool isTorn(const ExactPieces& piece, const PieceQuotient& quotient, double value, double rounding,
                const SurfaceSide& before) const;
    bool accept(const ExactPieces& piece, const Region& region);
    bool hasHole(std::uint32_t node, double t0, double t1) const;
    void light(SurfaceHit& hit, const vec3d& gradient) const;

    struct Root
    {
        double x;
        std::int32_t surface;
    };

    const TraceScene& scene_;
    std::span<const IsoSurface> surfaces_;
    bool headlight_;
    ExactRay ray_;
    double worldStretch_ = 1.0;
    double doneUntil_ = 0.0;
    double lastValue_ = 0.0; ///< B there, less the first surface's value
    double transmittance_ = 1.0;
    std::vector<SurfaceSide> sides_; ///< per surface, at doneUntil_
    std::vector<Root> roots_;        ///< of the piece at hand
};

} // namespace brickwall
