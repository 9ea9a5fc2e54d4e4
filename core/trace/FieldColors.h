// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Colours of a volume that are those of another field (TraceColors), at points in lanes, all of them in one region.
/// Per instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_FIELD_COLORS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_FIELD_COLORS_H
#undef BRICKWALL_CORE_TRACE_FIELD_COLORS_H
#else
#define BRICKWALL_CORE_TRACE_FIELD_COLORS_H
#endif

#include "brickwall/core/trace/Reconstruct.h"
#include "brickwall/core/trace/TraceTile.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// The colour field at points of a region, kept in the region's range and then in that of the colours, beyond which
/// nothing changes. Only to be called where there is one.
HWY_INLINE FloatN colorValueAt(const TraceScene& scene, std::uint32_t index, const PointN& p)
{
    const RegionTree& tree = *scene.regions;
    const Region& region = tree.regions[index];
    const PaddedField& field = *scene.colors.field;
    const Range range = field.regionRanges[index], ends = scene.colors.integral->range;
    const float* values = field.values.data();
    const FloatN value =
        region.brickCount == 1
            ? sampleBrick<false>(BrickView(tree.bricks[tree.brickLists[region.firstBrick]], values, scene.origin), p)
                  .value
            : sampleBricks<false>(tree, region, values, scene.origin, p, range.lo).value;
    return clamp(clamp(value, range.lo, range.hi), ends.lo, ends.hi);
}

/// The table and the integral of the colours, or those that have them anyway.
inline const TransferTable& colorTableOf(const TraceScene& scene)
{
    return scene.colors.field ? *scene.colors.table : *scene.table;
}
inline const TransferIntegral& colorIntegralOf(const TraceScene& scene)
{
    return scene.colors.field ? *scene.colors.integral : *scene.integral;
}

/// A density (c sigma, sigma) in white with another colour, of which the last component does not count.
HWY_INLINE QuadN withColor(const QuadN& density, const QuadN& color)
{
    return {density.d * color.a, density.d * color.b, density.d * color.c, density.d};
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
