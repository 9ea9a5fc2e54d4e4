// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Midpoint sampling with a binary search for the edges of what is visible (TraceTile.h says what it computes). Per
/// instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_BRACKET_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_BRACKET_H
#undef BRICKWALL_CORE_TRACE_BRACKET_H
#else
#define BRICKWALL_CORE_TRACE_BRACKET_H
#endif

#include "brickwall/core/trace/Stepping.h"
#include "brickwall/core/trace/TransferLookup.h"

#include <algorithm>
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// The visitor of a RegionWalk that samples a region at the midpoints of its segments and searches between two samples
/// if the interval of visible values, or an edge of it, lies between theirs.
template <bool shaded>
class Bracket : public Stepping<Bracket<shaded>, shaded>
{
public:
    Bracket(const TraceScene& scene, const StepParameters& parameters, const RayN& ray, FloatN offset,
            FloatN worldStretch)
        : Stepping<Bracket, shaded>(scene, parameters, ray, offset, worldStretch),
          lookup_(*scene.table),
          colors_(colorTableOf(scene)),
          visible_(scene.integral->visible),
          depth_(std::max(0, static_cast<int>(std::ceil(std::log2(parameters.dt / edgePrecision)))))
    {
    }

    /// The segments are those of Midpoint. A sample stands for its segment as soon as the next one is known; between
    /// two that straddle, only for its own half.
    template <class Field>
    HWY_INLINE void march(const Region& region, MaskN active, FloatN t0, FloatN t1, const Field& field)
    {
        SamplePlanesN planes(t0, this->stepIn(region), this->offset_);
        FloatN from = t0, last = min(planes.next(), t1);
        PlaceN near = placeAt(field, FloatN(0.5f) * (t0 + last), active);
        MaskN more = active & (last < t1);
        while (any(more)) {
            const FloatN next = min(planes.next(), t1);
            const PlaceN far = placeAt(field, FloatN(0.5f) * (last + next), more);
            const MaskN straddle = more & near.valid & far.valid & !(near.side == far.side);
            add(near, from, valueOrZero(more, select(straddle, near.t, last) - from));
            if (any(straddle))
                search(field, near, far, straddle);
            from = select(more, select(straddle, far.t, last), from);
            near.take(far, more);
            last = select(more, next, last);
            more = this->goesOn(more & (last < t1));
        }
        add(near, from, valueOrZero(this->goesOn(active), t1 - from));
    }

private:
    static constexpr float edgePrecision = 0.005f; ///< ExaBrick's, in finest cells of a region

    struct PlaceN
    {
        FloatN t;
        FloatN side; ///< of the visible values: -1 below, 0 among, 1 above
        QuadN seen;
        MaskN valid;

        HWY_INLINE void take(const PlaceN& other, MaskN lanes)
        {
            t = select(lanes, other.t, t);
            side = select(lanes, other.side, side);
            seen = {select(lanes, other.seen.a, seen.a), select(lanes, other.seen.b, seen.b),
                    select(lanes, other.seen.c, seen.c), select(lanes, other.seen.d, seen.d)};
            valid = (lanes & other.valid) | andNot(valid, lanes);
        }
    };

    HWY_INLINE FloatN sideOf(FloatN value) const
    {
        return select(value < FloatN(visible_.lo), -1.0f, select(value > FloatN(visible_.hi), FloatN(1.0f), 0.0f));
    }

    template <class Field>
    HWY_INLINE PlaceN placeAt(const Field& field, FloatN t, MaskN active)
    {
        const SampleN s = field(t, active);
        const MaskN valid = active & s.valid;
        const QuadN look = this->inItsColor(lookup_(s.value, valid), colors_, t, valid);
        const FloatN shade = this->shade(s);
        return {t, sideOf(s.value), {look.a * shade, look.b * shade, look.c * shade, look.d}, valid};
    }

    HWY_INLINE void add(const PlaceN& place, FloatN t, FloatN length)
    {
        if (any(place.seen.d > FloatN(0.0f)))
            this->radiance.add(place.seen.d, {place.seen.a, place.seen.b, place.seen.c}, t, length);
    }

    /// Between two samples, of which at least one is not visible: what is visible in between has one sample.
    template <class Field>
    HWY_INLINE void search(const Field& field, const PlaceN& near, const PlaceN& far, MaskN lanes)
    {
        const FloatN leaves = edge(field, near.t, far.t, near.side, lanes);
        const MaskN starts = near.side == FloatN(0.0f), ends = far.side == FloatN(0.0f);
        const MaskN through = andNot(andNot(lanes, starts), ends);
        FloatN end = select(ends, far.t, leaves);
        if (any(through))
            end = select(through, edge(field, leaves, far.t, 0.0f, through), end);
        const FloatN begin = select(starts, near.t, leaves);
        const FloatN length = valueOrZero(lanes, end - begin);
        add(placeAt(field, fma(length, 0.5f, begin), lanes), begin, length);
    }

    /// Where the field leaves a side between two places: as far as it is on that side at the first one.
    template <class Field>
    HWY_INLINE FloatN edge(const Field& field, FloatN near, FloatN far, FloatN side, MaskN lanes)
    {
        for (int i = 0; i < depth_; ++i) {
            const FloatN middle = FloatN(0.5f) * (near + far);
            const SampleN s = field(middle, lanes);
            const MaskN still = sideOf(s.value) == side;
            near = select(still, middle, near);
            far = select(still, far, middle);
        }
        return FloatN(0.5f) * (near + far);
    }

    TransferLookup lookup_, colors_; ///< colors_: of another field, if they are
    Range visible_;
    int depth_;
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
