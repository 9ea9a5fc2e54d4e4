// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "brickwall/core/trace/Surfaces.cpp"
#include "brickwall/core/simd/ForEachTarget.h"

#include "brickwall/core/trace/OneBrickPieces.h"
#include "brickwall/core/trace/Packet.h"
#include "brickwall/core/trace/SeveralBricksPieces.h"
#include "brickwall/core/trace/SurfaceRay.h"
#include "brickwall/core/trace/Surfaces.h"
#include "brickwall/core/trace/WideWalk.h"

#include <algorithm>
#include <cmath>
#include <limits>

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// How far B on a piece may be from what its coefficients in floats say.
struct Margins
{
    Margins(const PaddedField& field, std::uint32_t index, const Region& region, FloatN reach)
    {
        const Range range = field.regionRanges[index], all = field.range;
        const FloatN reachInCells = FloatN(4.0f / static_cast<float>(1 << region.finestLevel)) * reach;
        rounding_ = 2e-6f * std::max(std::abs(range.lo), std::abs(range.hi));
        change_ = reachInCells * FloatN(range.hi - range.lo);
        changeBeyond_ = reachInCells * FloatN(all.hi - all.lo);
        bricks_ = static_cast<float>(region.brickCount);
    }

    /// A short piece may have been given the cells of a neighbour beyond the region.
    HWY_INLINE FloatN of(const OneBrickPieces&, MaskN isShort) const
    {
        return select(isShort, changeBeyond_, change_) + rounding_;
    }

    /// Of each brick weight may be moved from cell to cell, which counts the more the less weight there is in all. A
    /// short piece may have missed the cells of a brick altogether.
    HWY_INLINE FloatN of(const SeveralBricksPieces& pieces, MaskN isShort) const
    {
        const FloatN weight = pieces.leastWeight();
        const MaskN unknown = isShort | (weight <= FloatN(1e-3f));
        return select(unknown, std::numeric_limits<float>::infinity(),
                      (FloatN(2.0f * bricks_) * change_ + rounding_) / select(unknown, 1.0f, weight));
    }

private:
    FloatN rounding_, change_, changeBeyond_;
    float bricks_;
};

/// The visitor of a walk that finds, in lanes, pieces that may meet a surface and has rays decide, one by one.
class SurfaceFinder
{
public:
    SurfaceFinder(const TraceScene& scene, std::span<const IsoSurface> surfaces, const PacketN& packet,
                  std::vector<SurfaceRay>& rays)
        : scene_(scene), surfaces_(surfaces), ray_(packet.ray), rays_(rays)
    {
        const FloatN org = max(max(abs(ray_.org[0]), abs(ray_.org[1])), abs(ray_.org[2]));
        // Floats of positions along the ray are right to that; `reach_` is a generous multiple.
        reach_ = FloatN(1e-6f) * (org + packet.t1);
        for (int i = 0; i < laneCount; ++i)
            alive_[i] = 1.0f;
    }

    MaskN operator()(std::uint32_t index, MaskN active, FloatN t0, FloatN t1)
    {
        const Region& region = scene_.regions->regions[index];
        counts.regionsVisited += count(active);
        // Floats see nothing where they cannot tell a small part of a cell.
        const MaskN blind = reach_ > FloatN(0.05f * static_cast<float>(1 << region.finestLevel));
        const MaskN seeing = andNot(active, blind);
        search(index, active & blind, t0, t1);
        if (region.brickCount == 1)
            scan<OneBrickPieces>(index, region, seeing, t0, t1);
        else
            scan<SeveralBricksPieces>(index, region, seeing, t0, t1);
        return load(alive_) > FloatN(0.5f);
    }

    TraceCounts counts;

private:
    /// For every t of a lane's piece, B(t) lies within the piece's coefficients, give or take `margin`: as far as B
    /// changes over `reach_`, and what rounding makes of values.
    template <class Pieces>
    void scan(std::uint32_t index, const Region& region, MaskN active, FloatN t0, FloatN t1)
    {
        const Margins margins(*scene_.field, index, region, reach_);
        Pieces pieces(*scene_.regions, region, scene_.field->values.data(), scene_.origin, ray_);
        FloatN t = t0;
        while (any(active)) {
            const FloatN end = min(pieces.end(t, reach_), t1);
            pieces.load(t, end);
            const FloatN m = margins.of(pieces, end - t < FloatN(4.0f) * reach_);
            const FloatN lo = pieces.least() - m, hi = pieces.largest() + m;
            MaskN cannot = active; // NaN and infinite margins can
            for (const IsoSurface& surface : surfaces_)
                cannot = cannot & ((lo > FloatN(surface.value)) | (hi < FloatN(surface.value)));
            const MaskN may = andNot(active, cannot);
            if (any(may)) {
                search(index, may, t, end);
                active = active & (load(alive_) > FloatN(0.5f));
            }
            counts.piecesSkipped += count(active) - count(active & may);
            t = end;
            active = active & (t < t1);
        }
    }

    void search(std::uint32_t index, MaskN active, FloatN t0, FloatN t1)
    {
        if (none(active))
            return;
        alignas(64) float on[16], from[16], to[16];
        store(select(active, 1.0f, 0.0f), on);
        store(t0, from);
        store(t1, to);
        for (int i = 0; i < laneCount; ++i)
            if (on[i] != 0.0f && !rays_[i].search(index, from[i], to[i]))
                alive_[i] = 0.0f;
    }

    const TraceScene& scene_;
    std::span<const IsoSurface> surfaces_;
    const RayN& ray_;
    std::vector<SurfaceRay>& rays_;
    FloatN reach_;
    alignas(64) float alive_[16];
};

void surfacesKernel(const TraceScene& scene, std::span<const KdNode> nodes, std::span<const IsoSurface> surfaces,
                    bool headlight, const RayTile& tile, SurfaceHits& found, TraceCounts& counts)
{
    WalkStack stack(scene.regions->depth);
    std::vector<SurfaceRay> rays(laneCount, SurfaceRay(scene, surfaces, headlight));
    for (int first = 0; first < tile.count; first += laneCount) {
        const int used = std::min(laneCount, tile.count - first);
        for (int i = 0; i < used; ++i)
            rays[i].begin(tile, first + i);
        const PacketN packet(tile, first);
        SurfaceFinder finder(scene, surfaces, packet, rays);
        const WideWalk walk(nodes, scene.origin, packet.ray, stack);
        walk(packet.active, packet.t0, packet.t1, finder);
        for (int i = 0; i < used; ++i) {
            found.first[first + i] = static_cast<std::uint32_t>(found.hits.size());
            found.hits.insert(found.hits.end(), rays[i].hits.begin(), rays[i].hits.end());
        }
        counts += finder.counts;
    }
    for (const SurfaceRay& ray : rays)
        counts += ray.counts;
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brickwall {

HWY_EXPORT(surfacesKernel);

void findSurfaces(const TraceScene& scene, std::span<const KdNode> nodes, std::span<const IsoSurface> surfaces,
                  bool headlight, const RayTile& rays, SurfaceHits& found, TraceCounts& counts)
{
    found.hits.clear();
    if (surfaces.empty()) {
        found.first.fill(0);
        return;
    }
    HWY_DYNAMIC_DISPATCH(surfacesKernel)(scene, nodes, surfaces, headlight, rays, found, counts);
    std::fill(found.first.begin() + rays.count, found.first.end(), static_cast<std::uint32_t>(found.hits.size()));
}

} // namespace brickwall
#endif
