// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// A walk like RegionWalk that misses no region for the rounding of floats. Per instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_WIDE_WALK_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_WIDE_WALK_H
#undef BRICKWALL_CORE_TRACE_WIDE_WALK_H
#else
#define BRICKWALL_CORE_TRACE_WIDE_WALK_H
#endif

#include "brickwall/core/trace/RegionWalk.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// Both sides of a plane reach beyond it by as much as floats cannot tell.
struct WidePlanes
{
    /// Even the farthest plane must not be met at infinity, whose margin would be NaN.
    static constexpr float tiny = 1e-28f;

    HWY_INLINE static CrossingN crossing(float plane, FloatN org, FloatN reciprocal)
    {
        const FloatN t = (FloatN(plane) - org) * reciprocal;
        // Three roundings; and that of a plane that is too far away for a float to hold it.
        FloatN margin = abs(t) * FloatN(4e-7f);
        if (std::abs(plane) >= 0x1p22f)
            margin += abs(reciprocal) * FloatN(1.2e-7f * std::abs(plane));
        return {t + margin, t - margin};
    }
};

/// Like RegionWalk, front to back, but a ray visits every region that it meets, if only along a corner, and some that
/// it just misses; the intervals overlap.
using WideWalk = KdWalk<WidePlanes>;

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
