// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "brickwall/core/trace/TraceTile.cpp"
#include "brickwall/core/simd/ForEachTarget.h"

#include "brickwall/core/trace/Midpoint.h"
#include "brickwall/core/trace/Packet.h"
#include "brickwall/core/trace/TraceTile.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

void midpointKernel(const TraceScene& scene, const StepParameters& parameters, const RayTile& tile, TileResult& result)
{
    if (parameters.headlight)
        integrate<Midpoint<true>>(scene, parameters, tile, result);
    else
        integrate<Midpoint<false>>(scene, parameters, tile, result);
}

struct RegionCounter
{
    std::uint64_t regions = 0;

    MaskN operator()(std::uint32_t, MaskN active, FloatN, FloatN)
    {
        regions += static_cast<std::uint64_t>(count(active));
        return active;
    }
};

std::uint64_t countKernel(const TraceScene& scene, const RayTile& tile)
{
    WalkStack stack(scene.regions->depth);
    RegionCounter counter;
    for (int first = 0; first < tile.count; first += laneCount) {
        const PacketN packet(tile, first);
        const RegionWalk walk(scene.nodes, scene.origin, packet.ray, stack);
        walk(packet.active, packet.t0, packet.t1, counter);
    }
    return counter.regions;
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brickwall {

HWY_EXPORT(midpointKernel);
HWY_EXPORT(countKernel);

TraceCounts& TraceCounts::operator+=(const TraceCounts& other)
{
    samples += other.samples;
    fetches += other.fetches;
    regionsVisited += other.regionsVisited;
    piecesSkipped += other.piecesSkipped;
    piecesMerged += other.piecesMerged;
    piecesSplit += other.piecesSplit;
    return *this;
}

TileResult::TileResult()
{
    for (RayTile::PerRay<float>& component : color)
        component.fill(0.0f);
    transmittance.fill(1.0f);
    weightedDistance.fill(0.0f);
    error.fill(0.0f);
}

void traceMidpoint(const TraceScene& scene, const StepParameters& parameters, const RayTile& rays, TileResult& result)
{
    HWY_DYNAMIC_DISPATCH(midpointKernel)(scene, parameters, rays, result);
}

std::uint64_t countRegions(const TraceScene& scene, const RayTile& rays)
{
    return HWY_DYNAMIC_DISPATCH(countKernel)(scene, rays);
}

} // namespace brickwall
#endif
