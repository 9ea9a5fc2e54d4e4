// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The bounded method over the rays of a tile. Per instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_BOUNDED_TILE_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_BOUNDED_TILE_H
#undef BRICKWALL_CORE_TRACE_BOUNDED_TILE_H
#else
#define BRICKWALL_CORE_TRACE_BOUNDED_TILE_H
#endif

#include "brickwall/core/trace/Bounded.h"
#include "brickwall/core/trace/Packet.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

template <bool shaded, bool colored>
void boundedPackets(const TraceScene& scene, const BoundedParameters& parameters, const RayTile& tile,
                    TileResult& result)
{
    WalkStack stack(scene.regions->depth);
    for (int first = 0; first < tile.count; first += laneCount) {
        const PacketN packet(tile, first);
        Bounded<shaded, colored> integrator(scene, parameters, packet.ray,
                                            max(packet.t1, load(tile.tEnd.data() + first)),
                                            load(tile.worldStretch.data() + first), load(result.error.data() + first));
        integrator.rays.radiance = loadRadiance(result, first);
        const RegionWalk walk(scene.nodes, scene.origin, packet.ray, stack);
        walk(packet.active, packet.t0, packet.t1, integrator);
        storeRadiance(integrator.rays.radiance, first, result);
        store(integrator.rays.error(), result.error.data() + first);
        result.counts += integrator.rays.counts;
    }
}

/// `colored`: the scene has TraceScene::colors.
template <bool colored>
void boundedTile(const TraceScene& scene, const BoundedParameters& parameters, const RayTile& tile, TileResult& result)
{
    if (parameters.headlight)
        boundedPackets<true, colored>(scene, parameters, tile, result);
    else
        boundedPackets<false, colored>(scene, parameters, tile, result);
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
