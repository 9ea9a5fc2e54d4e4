// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Regions.h"
#include "brickwall/core/shade/IsoSurface.h"
#include "brickwall/core/shade/TransferFunction.h"
#include "brickwall/core/trace/TraceTile.h"

#include <array>
#include <memory>
#include <span>
#include <vector>

namespace brickwall {

/// org + t dir for t in [tNear, tFar], in voxel space (the finest cell is 1 wide, nothing is relative).
struct ReferenceRay
{
    vec3d org, dir; ///< t is taken as the length in voxels: |dir| = 1
    double tNear, tFar;
    double worldStretch = 1.0; ///< length in world space of `dir`, in mean widths of a voxel there
};

/// Where B takes a surface's value. A crossing, a tangent ray and a stretch in which B has just that value are one hit
/// each, the last at its start.
struct ReferenceHit
{
    double t;
    int surface;    ///< index among the surfaces
    vec3d gradient; ///< of B, per voxel; on the nearer side where it has a kink
};

struct ReferenceResult
{
    vec3d color; ///< linear, premultiplied
    double transmittance;
    double weightedDistance; ///< sum over opacity contributions times their t
};

/// The radiance that every other method is measured against: C = int c sigma T dt with T = exp(-int sigma dt), in
/// plain double precision, together with exact isosurfaces.
///
/// A ray is cut at the faces of the supports and the planes through cell centres; between them B = N / D is a quotient
/// of cubics, which are taken from the bricks' own cells by the definition of the reconstruction. Those pieces are cut
/// again at surfaces, where B is extremal and where it passes a knot of the transfer function, so that the integrand is
/// smooth; there adaptive Gauss-Kronrod quadrature keeps the relative tolerance. Uses neither regions nor kd-tree,
/// padding nor table, and no code of the other methods. Where no brick has a cell (D = 0) there is nothing.
///
/// Immutable, thread-safe. Regions and field are borrowed.
class ReferenceIntegrator
{
public:
    /// `gradientMetric` as in TraceScene. With `headlight`, colours of volume and surfaces are multiplied with |cos|
    /// between gradient and ray in world space, or 1 where there is no gradient. `colorField` is what the transfer
    /// function's colours are of, if it has a ColorField; of the same regions.
    ReferenceIntegrator(const RegionTree& regions, const PaddedField& field, const TransferFunction& tf,
                        std::span<const IsoSurface> surfaces, const std::array<double, 6>& gradientMetric,
                        bool headlight, const PaddedField* colorField = nullptr, double relativeTolerance = 1e-10);
    ~ReferenceIntegrator();
    ReferenceIntegrator(ReferenceIntegrator&&) noexcept;

    /// Volume and surfaces, composited in their order along the ray.
    ReferenceResult integrate(const ReferenceRay& ray) const;

    /// All of them in order, also those behind opaque ones. At one place, in the order of the surfaces.
    std::vector<ReferenceHit> surfaceHits(const ReferenceRay& ray) const;

private:
    struct Data;
    std::unique_ptr<const Data> data_;
};

/// Integrates the rays of a tile, whose floats count as exact; `origin` (half voxels) is what they are relative to, as
/// in TraceScene. Continues from what is in `result` like the other methods.
void traceReference(const ReferenceIntegrator& integrator, const vec3i& origin, const RayTile& rays,
                    TileResult& result);

} // namespace brickwall
