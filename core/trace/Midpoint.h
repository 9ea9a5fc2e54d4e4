// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Midpoint sampling of the regions along rays in lanes (TraceTile.h says what it computes). Per instruction set, see
/// core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_MIDPOINT_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_MIDPOINT_H
#undef BRICKWALL_CORE_TRACE_MIDPOINT_H
#else
#define BRICKWALL_CORE_TRACE_MIDPOINT_H
#endif

#include "brickwall/core/trace/Radiance.h"
#include "brickwall/core/trace/Reconstruct.h"
#include "brickwall/core/trace/RegionWalk.h"
#include "brickwall/core/trace/TraceTile.h"
#include "brickwall/core/trace/TransferLookup.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// The visitor of a RegionWalk that samples a region at the midpoints of its segments.
template <bool shaded>
class Midpoint
{
public:
    Midpoint(const TraceScene& scene, const StepParameters& parameters, const RayN& ray, FloatN offset,
             FloatN worldStretch)
        : scene_(scene),
          lookup_(*scene.table),
          headlight_(scene, ray, worldStretch),
          ray_(ray),
          offset_(offset),
          dt_(parameters.dt),
          leastTransmittance_(1.0f - parameters.terminationOpacity)
    {
    }

    MaskN operator()(std::uint32_t index, MaskN active, FloatN t0, FloatN t1)
    {
        const Region& region = scene_.regions->regions[index];
        const Range range = scene_.field->regionRanges[index];
        const float* values = scene_.field->values.data();
        counts.regionsVisited += count(active);
        if (region.brickCount == 1) {
            const BrickView brick(scene_.regions->bricks[scene_.regions->brickLists[region.firstBrick]], values,
                                  scene_.origin);
            march(region, range, active, t0, t1,
                  [&](const PointN& p) HWY_ATTR { return sampleBrick<shaded>(brick, p); });
        } else {
            march(region, range, active, t0, t1, [&](const PointN& p) HWY_ATTR {
                return sampleBricks<shaded>(*scene_.regions, region, values, scene_.origin, p, range.lo);
            });
        }
        return radiance.transmittance > FloatN(leastTransmittance_);
    }

    RadianceN radiance;
    TraceCounts counts;

private:
    /// Segments end at the planes t = (offset + k) step and at the region's ends.
    template <class Field>
    HWY_INLINE void march(const Region& region, const Range& range, MaskN active, FloatN t0, FloatN t1,
                          const Field& field)
    {
        const FloatN step = dt_ * static_cast<float>(1 << region.finestLevel);
        FloatN k = floor(t0 / step - offset_) + FloatN(1.0f);
        k = select((offset_ + k) * step <= t0, k + FloatN(1.0f), k);
        FloatN last = t0;
        while (any(active)) {
            const FloatN next = min((offset_ + k) * step, t1);
            counts.samples += count(active);
            segment(range, active, last, next - last, field);
            last = next;
            k += FloatN(1.0f);
            active = active & (last < t1) & (radiance.transmittance > FloatN(leastTransmittance_));
        }
    }

    template <class Field>
    HWY_INLINE void segment(const Range& range, MaskN active, FloatN t, FloatN length, const Field& field)
    {
        const FloatN middle = fma(length, 0.5f, t);
        const PointN p{fma(middle, ray_.dir[0], ray_.org[0]), fma(middle, ray_.dir[1], ray_.org[1]),
                       fma(middle, ray_.dir[2], ray_.org[2])};
        const SampleN s = field(p);
        // B stays inside the range of what contributes; rounding must not push it over the edge of the transfer
        // function.
        const FloatN value = clamp(s.value, range.lo, range.hi);
        const QuadN look = lookup_(value, active & s.valid);
        if (none(look.d > FloatN(0.0f)))
            return;
        ColorN color{look.a, look.b, look.c};
        if constexpr (shaded) {
            const FloatN cosine = headlight_(s.gradient);
            color = {color.r * cosine, color.g * cosine, color.b * cosine};
        }
        radiance.add(look.d, color, t, length);
    }

    const TraceScene& scene_;
    TransferLookup lookup_;
    Headlight headlight_;
    const RayN& ray_;
    FloatN offset_;
    float dt_;
    float leastTransmittance_;
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
