// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The methods of the literature but midpoint: their kernels for every instruction set.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "brickwall/core/trace/TraceSteps.cpp"
#include "brickwall/core/simd/ForEachTarget.h"

#include "brickwall/core/trace/Bracket.h"
#include "brickwall/core/trace/Fixed.h"
#include "brickwall/core/trace/Packet.h"
#include "brickwall/core/trace/Preintegrated.h"
#include "brickwall/core/trace/TraceTile.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

template <template <bool> class Method>
void steps(const TraceScene& scene, const StepParameters& parameters, const RayTile& tile, TileResult& result)
{
    if (parameters.headlight)
        integrate<Method<true>>(scene, parameters, tile, result);
    else
        integrate<Method<false>>(scene, parameters, tile, result);
}

void fixedKernel(const TraceScene& scene, const StepParameters& parameters, const RayTile& tile, TileResult& result)
{
    steps<Fixed>(scene, parameters, tile, result);
}

void bracketKernel(const TraceScene& scene, const StepParameters& parameters, const RayTile& tile, TileResult& result)
{
    steps<Bracket>(scene, parameters, tile, result);
}

void preintegratedKernel(const TraceScene& scene, const StepParameters& parameters, const RayTile& tile,
                         TileResult& result)
{
    steps<Preintegrated>(scene, parameters, tile, result);
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brickwall {

HWY_EXPORT(fixedKernel);
HWY_EXPORT(bracketKernel);
HWY_EXPORT(preintegratedKernel);

void traceFixed(const TraceScene& scene, const StepParameters& parameters, const RayTile& rays, TileResult& result)
{
    HWY_DYNAMIC_DISPATCH(fixedKernel)(scene, parameters, rays, result);
}

void traceBracket(const TraceScene& scene, const StepParameters& parameters, const RayTile& rays, TileResult& result)
{
    HWY_DYNAMIC_DISPATCH(bracketKernel)(scene, parameters, rays, result);
}

void tracePreintegrated(const TraceScene& scene, const StepParameters& parameters, const RayTile& rays,
                        TileResult& result)
{
    HWY_DYNAMIC_DISPATCH(preintegratedKernel)(scene, parameters, rays, result);
}

} // namespace brickwall
#endif
