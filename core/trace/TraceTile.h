// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Regions.h"
#include "brickwall/core/shade/TransferFunction.h"
#include "brickwall/core/shade/TransferIntegral.h"
#include "brickwall/core/trace/RegionBounds.h"

#include <array>
#include <cstdint>
#include <span>

namespace brickwall {

/// Up to `capacity` rays of one view, an array per component, to be integrated several at a time. A ray is
/// org + t dir, 0 <= tNear <= t <= tFar, in voxels; `org` is relative to TraceScene::origin, `dir` has unit length in
/// voxel space. The interval lies within the bounds of the regions; rays that meet nothing have tNear = tFar = 0. All
/// numbers are finite.
struct RayTile
{
    static constexpr int capacity = 256;
    template <class T>
    using PerRay = std::array<T, capacity>;

    int count = 0;
    alignas(64) std::array<PerRay<float>, 3> org{};
    alignas(64) std::array<PerRay<float>, 3> dir{};
    alignas(64) PerRay<float> tNear{};
    alignas(64) PerRay<float> tFar{};
    /// Where the whole ray ends, if [tNear, tFar] is a part of it; not used if less than tFar.
    alignas(64) PerRay<float> tEnd{};
    alignas(64) PerRay<float> offset{};       ///< of the sample planes, in steps, in [0, 1)
    alignas(64) PerRay<float> worldStretch{}; ///< length in world space of `dir`, in mean widths of a voxel there
};

/// What tracing rays has cost, summed over them.
struct TraceCounts
{
    std::uint64_t samples = 0;        ///< evaluations of B
    std::uint64_t fetches = 0;        ///< of eight cells around a point, per brick
    std::uint64_t regionsVisited = 0; ///< those that were not skipped
    std::uint64_t piecesSkipped = 0;  ///< between planes through cell centres, without opacity
    std::uint64_t piecesMerged = 0;   ///< that did not need an evaluation of their own
    std::uint64_t piecesSplit = 0;    ///< that needed more than one part

    TraceCounts& operator+=(const TraceCounts& other);
};

/// What came of the rays of a tile. Premultiplied linear colour; the opacity is 1 - transmittance. Every way to
/// integrate starts from what is there, so that a ray may be integrated from one surface to the next.
struct TileResult
{
    alignas(64) std::array<RayTile::PerRay<float>, 3> color;
    alignas(64) RayTile::PerRay<float> transmittance;
    alignas(64) RayTile::PerRay<float> weightedDistance; ///< sum over opacity contributions times their t
    alignas(64) RayTile::PerRay<float> error;            ///< the bounded method's own bound so far; 0 for the others
    TraceCounts counts;

    /// Nothing collected yet.
    TileResult();
};

/// The colours of a volume if they are those of another field (TransferFunction::colorField), of the same regions.
/// Everything is borrowed.
struct TraceColors
{
    const PaddedField* field = nullptr;         ///< null: the field itself has them
    const TransferTable* table = nullptr;       ///< of colorFunction
    const TransferIntegral* integral = nullptr; ///< of the same
};

/// What rays of a view go through. Everything is borrowed.
struct TraceScene
{
    const RegionTree* regions = nullptr;
    std::span<const KdNode> nodes; ///< the tree's, or what `visibleNodes` made of them
    const PaddedField* field = nullptr;
    const TransferTable* table = nullptr;
    const TransferIntegral* integral = nullptr; ///< of the same transfer function; not needed by fixed and midpoint
    std::span<const RegionBounds> regionBounds; ///< one per region; for the bounded method
    /// Half voxels; a point near the eye and the data, so that floats relative to it are precise.
    vec3i origin{0};
    /// G = M^-1 M^-T (xx, yy, zz, xy, xz, yz), M = worldFromVoxel / stretchOf(worldFromVoxel): a gradient g in voxel
    /// space has the length sqrt(g G g) in world space, per mean width of a voxel there. Angles do not depend on the
    /// unit of length, but the squares of a galaxy's centimetres are more than floats can hold.
    std::array<float, 6> gradientMetric{1, 1, 1, 0, 0, 0};
    /// If these are there, `table` and `integral` are those of extinctionFunction, in white.
    TraceColors colors;
};

/// A gradient whose squared length, in the field's span per mean width of a voxel, is not more than this has no
/// direction: floats cannot hold much smaller squares.
inline constexpr float noGradientSquared = 1e-36f;

/// What the bounded method keeps: see Renderer.h.
struct BoundedParameters
{
    float tolerance = 1.0f / 255.0f;
    bool headlight = false;
};

struct StepParameters
{
    float dt = 0.5f;
    float terminationOpacity = 1.0f;
    bool headlight = false;
};

// Each of these integrates the rays of a tile from tNear to tFar. A ray's result depends on that ray alone, not on its
// neighbours. Thread-safe.

/// Midpoint sampling in steps of dt finest cell widths of a region (Wald et al., "Ray Tracing Structured AMR Data Using
/// ExaBricks", 2021), samples being weighted by the true length of their segment.
void traceMidpoint(const TraceScene& scene, const StepParameters& parameters, const RayTile& rays, TileResult& result);

/// The Riemann sum over planes t = (offset + k) dt of the whole ray, dt in finest cells of the data: a sample stands
/// for the step behind it. First order.
void traceFixed(const TraceScene& scene, const StepParameters& parameters, const RayTile& rays, TileResult& result);

/// Midpoint sampling; where two consecutive samples of a region straddle an edge of TransferIntegral::visible, or all
/// of it, a binary search of depth log2(dt / 0.005) finds the edges, and what is visible between the two has a sample
/// of its own (ExaBrick's way to keep thin features).
void traceBracket(const TraceScene& scene, const StepParameters& parameters, const RayTile& rays, TileResult& result);

/// Segments as in midpoint sampling, with samples at their ends: exact optical depth for a field that is linear in
/// between (Engel, Kraus, Ertl 2001, with one-dimensional integrals), a segment's mean colour attenuated by itself.
void tracePreintegrated(const TraceScene& scene, const StepParameters& parameters, const RayTile& rays,
                        TileResult& result);

/// Spends an error budget per ray: segments of a region are sampled at steps that its bounds allow, or taken piece by
/// piece between planes through cell centres, with the mean of the transfer function over the values of each part,
/// which are halved until the estimated error fits (docs/speed-accuracy.md). Fills TileResult::error.
void traceBounded(const TraceScene& scene, const BoundedParameters& parameters, const RayTile& rays,
                  TileResult& result);

/// Walks the rays of a tile and only counts the regions they visit: for benchmarks.
std::uint64_t countRegions(const TraceScene& scene, const RayTile& rays);

} // namespace brickwall
