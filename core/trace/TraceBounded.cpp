// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "brickwall/core/trace/TraceBounded.cpp"
#include "brickwall/core/simd/ForEachTarget.h"

#include "brickwall/core/trace/Bounded.h"
#include "brickwall/core/trace/Packet.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

template <bool shaded>
void bounded(const TraceScene& scene, const BoundedParameters& parameters, const RayTile& tile, TileResult& result)
{
    WalkStack stack(scene.regions->depth);
    for (int first = 0; first < tile.count; first += laneCount) {
        const PacketN packet(tile, first);
        Bounded<shaded> integrator(scene, parameters, packet.ray, max(packet.t1, load(tile.tEnd.data() + first)),
                                   load(tile.worldStretch.data() + first), load(result.error.data() + first));
        integrator.rays.radiance = loadRadiance(result, first);
        const RegionWalk walk(scene.nodes, scene.origin, packet.ray, stack);
        walk(packet.active, packet.t0, packet.t1, integrator);
        storeRadiance(integrator.rays.radiance, first, result);
        store(integrator.rays.error(), result.error.data() + first);
        result.counts += integrator.rays.counts;
    }
}

void boundedKernel(const TraceScene& scene, const BoundedParameters& parameters, const RayTile& tile,
                   TileResult& result)
{
    if (parameters.headlight)
        bounded<true>(scene, parameters, tile, result);
    else
        bounded<false>(scene, parameters, tile, result);
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brickwall {

HWY_EXPORT(boundedKernel);

void traceBounded(const TraceScene& scene, const BoundedParameters& parameters, const RayTile& rays, TileResult& result)
{
    HWY_DYNAMIC_DISPATCH(boundedKernel)(scene, parameters, rays, result);
}

} // namespace brickwall
#endif
