// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The rays of a tile, as many at a time as there are lanes. Per instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_PACKET_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_PACKET_H
#undef BRICKWALL_CORE_TRACE_PACKET_H
#else
#define BRICKWALL_CORE_TRACE_PACKET_H
#endif

#include "brickwall/core/trace/Radiance.h"
#include "brickwall/core/trace/RegionWalk.h"
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

HWY_INLINE RadianceN loadRadiance(const TileResult& result, int first)
{
    RadianceN radiance;
    radiance.color = {load(result.color[0].data() + first), load(result.color[1].data() + first),
                      load(result.color[2].data() + first)};
    radiance.transmittance = load(result.transmittance.data() + first);
    radiance.weightedDistance = load(result.weightedDistance.data() + first);
    return radiance;
}

HWY_INLINE void storeRadiance(const RadianceN& radiance, int first, TileResult& result)
{
    store(radiance.color.r, result.color[0].data() + first);
    store(radiance.color.g, result.color[1].data() + first);
    store(radiance.color.b, result.color[2].data() + first);
    store(radiance.transmittance, result.transmittance.data() + first);
    store(radiance.weightedDistance, result.weightedDistance.data() + first);
}

/// Every way to integrate is a visitor of RegionWalk like Midpoint, made for one packet of rays and handed what they
/// have collected; all share the walk, the reconstruction and the transfer function.
template <class Integrator, class Parameters>
HWY_INLINE void integrate(const TraceScene& scene, const Parameters& parameters, const RayTile& tile,
                          TileResult& result)
{
    WalkStack stack(scene.regions->depth);
    for (int first = 0; first < tile.count; first += laneCount) {
        const PacketN packet(tile, first);
        Integrator integrator(scene, parameters, packet.ray, load(tile.offset.data() + first),
                              load(tile.worldStretch.data() + first));
        integrator.radiance = loadRadiance(result, first);
        const RegionWalk walk(scene.nodes, scene.origin, packet.ray, stack);
        walk(packet.active, packet.t0, packet.t1, integrator);
        storeRadiance(integrator.radiance, first, result);
        result.counts += integrator.counts;
    }
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
