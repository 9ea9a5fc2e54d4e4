// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Midpoint sampling of the regions along rays in lanes (TraceTile.h says what it computes). Per instruction set, see
/// core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_MIDPOINT_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_MIDPOINT_H
#undef BRICKWALL_CORE_TRACE_MIDPOINT_H
#else
#define BRICKWALL_CORE_TRACE_MIDPOINT_H
#endif

#include "brickwall/core/trace/Stepping.h"
#include "brickwall/core/trace/TransferLookup.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// The visitor of a RegionWalk that samples a region at the midpoints of its segments.
template <bool shaded>
class Midpoint : public Stepping<Midpoint<shaded>, shaded>
{
public:
    Midpoint(const TraceScene& scene, const StepParameters& parameters, const RayN& ray, FloatN offset,
             FloatN worldStretch)
        : Stepping<Midpoint, shaded>(scene, parameters, ray, offset, worldStretch),
          lookup_(*scene.table),
          colors_(colorTableOf(scene))
    {
    }

    /// Segments end at the planes t = (offset + k) step and at the region's ends.
    template <class Field>
    HWY_INLINE void march(const Region& region, MaskN active, FloatN t0, FloatN t1, const Field& field)
    {
        SamplePlanesN planes(t0, this->stepIn(region), this->offset_);
        FloatN last = t0;
        while (any(active)) {
            const FloatN next = min(planes.next(), t1);
            const FloatN length = next - last;
            const FloatN middle = fma(length, 0.5f, last);
            const SampleN s = field(middle, active);
            const MaskN valid = active & s.valid;
            const QuadN look = this->inItsColor(lookup_(s.value, valid), colors_, middle, valid);
            if (any(look.d > FloatN(0.0f))) {
                const FloatN shade = this->shade(s);
                this->radiance.add(look.d, {look.a * shade, look.b * shade, look.c * shade}, last, length);
            }
            last = next;
            active = this->goesOn(active & (last < t1));
        }
    }

private:
    TransferLookup lookup_, colors_; ///< colors_: of another field, if they are
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
