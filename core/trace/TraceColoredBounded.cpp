// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "brickwall/core/trace/TraceColoredBounded.cpp"
#include "brickwall/core/simd/ForEachTarget.h"

#include "brickwall/core/trace/BoundedTile.h"
#include "brickwall/core/trace/TraceColoredBounded.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

void coloredBoundedKernel(const TraceScene& scene, const BoundedParameters& parameters, const RayTile& tile,
                          TileResult& result)
{
    boundedTile<true>(scene, parameters, tile, result);
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brickwall {

HWY_EXPORT(coloredBoundedKernel);

void traceColoredBounded(const TraceScene& scene, const BoundedParameters& parameters, const RayTile& rays,
                         TileResult& result)
{
    HWY_DYNAMIC_DISPATCH(coloredBoundedKernel)(scene, parameters, rays, result);
}

} // namespace brickwall
#endif
