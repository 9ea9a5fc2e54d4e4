// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "brickwall/core/trace/TraceTile.cpp"
#include "brickwall/core/simd/ForEachTarget.h"

#include "brickwall/core/trace/Midpoint.h"
#include "brickwall/core/trace/TraceTile.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// The lanes of a tile that start at ray `first`.
struct PacketN
{
    RayN ray;
    MaskN active;
    FloatN t0, t1;

    PacketN(const RayTile& tile, int first)
        : active(firstLanes(tile.count - first)),
          t0(load(tile.tNear.data() + first)),
          t1(load(tile.tFar.data() + first))
    {
        for (int axis = 0; axis < 3; ++axis) {
            ray.org[axis] = load(tile.org[axis].data() + first);
            ray.dir[axis] = load(tile.dir[axis].data() + first);
        }
        active = active & (t0 < t1);
    }
};

void storeRadiance(const RadianceN& radiance, int first, TileResult& result)
{
    store(radiance.color.r, result.color[0].data() + first);
    store(radiance.color.g, result.color[1].data() + first);
    store(radiance.color.b, result.color[2].data() + first);
    store(radiance.transmittance, result.transmittance.data() + first);
    store(radiance.weightedDistance, result.weightedDistance.data() + first);
}

/// Every way to integrate is a visitor like Midpoint; all share the walk, the reconstruction and the transfer function.
template <class Integrator, class Parameters>
void integrate(const TraceScene& scene, const Parameters& parameters, const RayTile& tile, TileResult& result)
{
    WalkStack stack(scene.regions->depth);
    for (int first = 0; first < tile.count; first += laneCount) {
        const PacketN packet(tile, first);
        Integrator integrator(scene, parameters, packet.ray, load(tile.offset.data() + first),
                              load(tile.worldStretch.data() + first));
        const RegionWalk walk(scene.nodes, scene.origin, packet.ray, stack);
        walk(packet.active, packet.t0, packet.t1, integrator);
        storeRadiance(integrator.radiance, first, result);
        result.samples += integrator.samples;
        result.regionsVisited += integrator.regionsVisited;
    }
}

void midpointKernel(const TraceScene& scene, const MidpointParameters& parameters, const RayTile& tile,
                    TileResult& result)
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

void traceMidpoint(const TraceScene& scene, const MidpointParameters& parameters, const RayTile& rays,
                   TileResult& result)
{
    result.samples = result.regionsVisited = 0;
    HWY_DYNAMIC_DISPATCH(midpointKernel)(scene, parameters, rays, result);
}

std::uint64_t countRegions(const TraceScene& scene, const RayTile& rays)
{
    return HWY_DYNAMIC_DISPATCH(countKernel)(scene, rays);
}

} // namespace brickwall
#endif
