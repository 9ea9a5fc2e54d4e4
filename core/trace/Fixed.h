// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The Riemann sum along rays in lanes (TraceTile.h says what it computes). Per instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_FIXED_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_FIXED_H
#undef BRICKWALL_CORE_TRACE_FIXED_H
#else
#define BRICKWALL_CORE_TRACE_FIXED_H
#endif

#include "brickwall/core/trace/Stepping.h"
#include "brickwall/core/trace/TransferLookup.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// The visitor of a RegionWalk that samples a region at the planes of the whole ray that it contains. A sample stands
/// for its step, even where the region ends before.
template <bool shaded>
class Fixed : public Stepping<Fixed<shaded>, shaded>
{
public:
    Fixed(const TraceScene& scene, const StepParameters& parameters, const RayN& ray, FloatN offset,
          FloatN worldStretch)
        : Stepping<Fixed, shaded>(scene, parameters, ray, offset, worldStretch),
          lookup_(*scene.table),
          colors_(colorTableOf(scene))
    {
    }

    /// The planes in [t0, t1), so that one between two regions is sampled once.
    template <class Field>
    HWY_INLINE void march(const Region&, MaskN active, FloatN t0, FloatN t1, const Field& field)
    {
        const float step = this->dt_;
        FloatN k = floor(t0 / FloatN(step) - this->offset_);
        for (int rounding = 0; rounding < 2; ++rounding)
            k = select(plane(k) < t0, k + FloatN(1.0f), k);
        FloatN t = plane(k);
        active = active & (t < t1);
        while (any(active)) {
            const SampleN s = field(t, active);
            const MaskN valid = active & s.valid;
            const QuadN look = this->inItsColor(lookup_(s.value, valid), colors_, t, valid);
            if (any(look.d > FloatN(0.0f))) {
                const FloatN shade = this->shade(s);
                this->radiance.add(look.d, {look.a * shade, look.b * shade, look.c * shade}, t, step);
            }
            k += FloatN(1.0f);
            // Far away, where floats are further apart than the planes, every float is one.
            t = max(plane(k), fma(abs(t), 1.2e-7f, t));
            active = this->goesOn(active & (t < t1));
        }
    }

private:
    HWY_INLINE FloatN plane(FloatN k) const { return (this->offset_ + k) * FloatN(this->dt_); }

    TransferLookup lookup_, colors_; ///< colors_: of another field, if they are
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
