// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Pre-integration between samples along rays in lanes (TraceTile.h says what it computes). Per instruction set, see
/// core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_PREINTEGRATED_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_PREINTEGRATED_H
#undef BRICKWALL_CORE_TRACE_PREINTEGRATED_H
#else
#define BRICKWALL_CORE_TRACE_PREINTEGRATED_H
#endif

#include "brickwall/core/trace/Stepping.h"
#include "brickwall/core/trace/TransferIntegralLookup.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// The visitor of a RegionWalk that samples a region at the ends of its segments and takes the mean of the transfer
/// function over the values in between.
template <bool shaded>
class Preintegrated : public Stepping<Preintegrated<shaded>, shaded>
{
public:
    Preintegrated(const TraceScene& scene, const StepParameters& parameters, const RayN& ray, FloatN offset,
                  FloatN worldStretch)
        : Stepping<Preintegrated, shaded>(scene, parameters, ray, offset, worldStretch),
          lookup_(*scene.integral),
          colors_(colorIntegralOf(scene))
    {
    }

    /// The segments are those of Midpoint.
    template <class Field>
    HWY_INLINE void march(const Region& region, MaskN active, FloatN t0, FloatN t1, const Field& field)
    {
        SamplePlanesN planes(t0, this->stepIn(region), this->offset_);
        FloatN last = t0;
        EndN near = endAt(field, t0, active);
        while (any(active)) {
            const FloatN next = min(planes.next(), t1);
            const EndN far = endAt(field, next, active);
            segment(active, near, far, last, next - last);
            near = far;
            last = next;
            active = this->goesOn(active & (last < t1));
        }
    }

private:
    struct EndN
    {
        TransferPointN look;
        FloatN shade;
        MaskN valid;
        TransferPointN color; ///< of another field, if colours are
    };

    template <class Field>
    HWY_INLINE EndN endAt(const Field& field, FloatN t, MaskN active)
    {
        const SampleN s = field(t, active);
        const MaskN valid = active & s.valid;
        EndN end{lookup_.at(s.value, valid), this->shade(s), valid, {}};
        if (this->isColoredByField())
            end.color = colors_.at(this->colorValueAt(t, active), valid);
        return end;
    }

    /// In the mean colour of the values between two ends: the extinction is that of one field, the colour that of the
    /// other, each exact where its field is linear.
    HWY_INLINE QuadN inMeanColor(const QuadN& mean, const EndN& near, const EndN& far) const
    {
        const QuadN between = colors_.meanBetween(near.color, far.color);
        const QuadN color = select(near.valid, select(far.valid, between, near.color.limit), far.color.limit);
        return withColor(mean, color);
    }

    HWY_INLINE void segment(MaskN active, const EndN& near, const EndN& far, FloatN t, FloatN length)
    {
        // Where no tent reaches one end, the other stands for both.
        QuadN mean = lookup_.meanBetween(near.look, far.look);
        FloatN shade = FloatN(0.5f) * (near.shade + far.shade);
        mean = select(near.valid, select(far.valid, mean, near.look.density()), far.look.density());
        shade = select(near.valid, select(far.valid, shade, near.shade), far.shade);
        if (this->isColoredByField())
            mean = inMeanColor(mean, near, far);
        const MaskN visible = active & (near.valid | far.valid) & (mean.d > FloatN(0.0f));
        if (none(visible))
            return;
        const FloatN scale = shade / select(visible, mean.d, 1.0f);
        this->radiance.add(valueOrZero(visible, mean.d), {mean.a * scale, mean.b * scale, mean.c * scale}, t, length);
    }

    TransferIntegralLookup lookup_, colors_;
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
