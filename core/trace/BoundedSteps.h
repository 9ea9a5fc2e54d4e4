// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The cheap half of the bounded method: steps with one sample each, as long as samples see all that is there and what
/// they err fits into the budget. Per instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_BOUNDED_STEPS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_BOUNDED_STEPS_H
#undef BRICKWALL_CORE_TRACE_BOUNDED_STEPS_H
#else
#define BRICKWALL_CORE_TRACE_BOUNDED_STEPS_H
#endif

#include "brickwall/core/trace/BoundedRays.h"
#include "brickwall/core/trace/RegionBounds.h"

#include <algorithm>

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

template <bool shaded>
class BoundedSteps
{
public:
    HWY_INLINE BoundedSteps(BoundedRays& rays, const Region& region, std::uint32_t index)
        : rays_(rays),
          bounds_(rays.scene.regionBounds[index]),
          range_(rays.scene.field->regionRanges[index]),
          brickCount_(region.brickCount),
          width_(static_cast<float>(1 << region.finestLevel))
    {
    }

    /// Through [t0, t1] of the region, in which field(point) samples B; returns where it got to.
    template <class Field>
    HWY_INLINE FloatN operator()(MaskN active, FloatN t0, FloatN t1, const Field& field)
    {
        BoundedRays& r = rays_;
        const FloatN length = t1 - t0, shortest = tuning::shortestStep * width_;
        const LimitsN limits = limitsOf(t0, length);
        const MaskN faint = limits.faint;
        FloatN t = t0;
        MaskN todo = active & (faint | ((limits.longest >= shortest) & (r.step >= shortest)));
        const MaskN fresh = andNot(todo & (r.lastAt < t0), faint);
        if (any(fresh))
            r.last = select(fresh, densityAt(field, t0, fresh), r.last);
        FloatN squares = 0.0f;
        while (any(todo)) {
            const FloatN rest = t1 - t, step = select(faint, length, min(r.step, limits.longest));
            const MaskN ends = rest <= step;
            const FloatN h = select(ends, rest, select(rest < step + step, FloatN(0.5f) * rest, step));
            const QuadN density = densityAt(field, fma(0.5f, h, t), todo);
            const ErrorN error = errorOf(density, h);
            const MaskN good = judge(error, h, limits, todo);
            squares += valueOrZero(good, error.square);
            r.budget.addToSum(good, error.bias);
            r.add(good, SegmentN(density, 1.0f, h), t, h);
            r.counts.piecesMerged += mergedPieces(good, h);
            r.last = select(good, density, r.last);
            t = select(good, select(ends, t1, t + h), t);
            todo = todo & (t < t1) & (faint | (r.step >= shortest)) & r.goOn();
        }
        r.budget.addToSquares(squares);
        r.lastAt = select(t > t0, t, r.lastAt);
        return t;
    }

private:
    struct LimitsN
    {
        FloatN perLength; ///< one over what is still before the ray
        FloatN squares;   ///< that may be added, per length
        FloatN longest;   ///< step
        MaskN faint;      ///< whatever is there, one sample will do
    };

    HWY_INLINE LimitsN limitsOf(FloatN t0, FloatN length) const
    {
        LimitsN limits;
        const FloatN most = rays_.radiance.transmittance * FloatN(bounds_.extinction);
        limits.perLength = rays_.budget.perLength(t0);
        limits.squares = rays_.budget.squares(limits.perLength);
        limits.faint = most * most * length <= limits.squares;
        // Between samples, extinction cannot change by more than this share of its largest, or that does not matter.
        const FloatN worst =
            FloatN(0.25f / tuning::trust) * rays_.radiance.transmittance * FloatN(bounds_.variationAlong); // h^2
        const FloatN trusted = cubeRoot(limits.squares / max(worst * worst, FloatN(1e-30f)));
        const float resolved = tuning::resolvedChange * bounds_.extinction / std::max(bounds_.variationAlong, 1e-30f);
        limits.longest = max(trusted, min(FloatN(resolved), FloatN(tuning::resolvedTrust) * trusted));
        return limits;
    }

    /// c sigma and sigma, the light included.
    template <class Field>
    HWY_INLINE QuadN densityAt(const Field& field, FloatN t, MaskN lanes)
    {
        rays_.counts.samples += count(lanes);
        rays_.counts.fetches += count(lanes) * brickCount_;
        const SampleN s = field(rays_.pointAt(t));
        const FloatN value = clamp(s.value, range_.lo, range_.hi);
        const QuadN density = valueOrZero(lanes & s.valid, rays_.lookup.at(value, lanes & s.valid).density());
        if constexpr (shaded) {
            const FloatN light = rays_.headlight(s.gradient);
            return {density.a * light, density.b * light, density.c * light, density.d};
        } else {
            return density;
        }
    }

    struct ErrorN
    {
        FloatN opacity; ///< of the step
        FloatN square;  ///< of what may go either way
        FloatN bias;    ///< what goes the same way in every step
    };

    /// Of a step that is taken to be as its middle, judged by the change since the last sample.
    HWY_INLINE ErrorN errorOf(const QuadN& density, FloatN h) const
    {
        const FloatN change = rays_.changeTo(density), weight = rays_.radiance.transmittance * h;
        // What the light does between samples is not known: half of it may be wrong.
        const FloatN unknown = shaded ? FloatN(0.5f) * density.d : FloatN(0.0f);
        const FloatN errs = weight * min(fma(FloatN(0.25f), change, unknown), bounds_.extinction);
        // What lies in the front half of a step hides what lies behind: always the same way, so it adds up.
        const FloatN opacity = min(density.d * h, 1.0f);
        const FloatN bias = weight * change * opacity * FloatN(1.0f / 12.0f);
        return {opacity, errs * errs, bias};
    }

    /// Where a step is good enough; suggests the next one.
    HWY_INLINE MaskN judge(const ErrorN& error, FloatN h, const LimitsN& limits, MaskN todo)
    {
        const FloatN squareShare = limits.squares * h;
        const FloatN share = rays_.budget.share(limits.perLength, h, error.opacity);
        const FloatN accepted = tuning::acceptedExcess;
        const MaskN good =
            todo & (limits.faint | ((error.square <= accepted * squareShare) & (error.bias <= accepted * share)));
        const MaskN tooFine = (error.square < FloatN(tuning::tooFineSquare) * squareShare) &
                              (error.bias < FloatN(tuning::tooFineBias) * share);
        const MaskN tooCoarse = (error.square > squareShare) | (error.bias > share);
        const FloatN factor = select(tooCoarse, tuning::shorten, select(tooFine, tuning::lengthen, 1.0f));
        rays_.step = select(todo, h * factor, rays_.step);
        return good;
    }

    HWY_INLINE std::uint64_t mergedPieces(MaskN lanes, FloatN length) const
    {
        // A ray crosses 1.5 planes through cell centres per cell on average.
        return static_cast<std::uint64_t>(
            sum(valueOrZero(lanes, max(floor(length * FloatN(1.5f / width_)) - FloatN(1.0f), 0.0f))));
    }

    BoundedRays& rays_;
    const RegionBounds& bounds_;
    const Range& range_;
    std::uint32_t brickCount_;
    float width_; ///< of a cell
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
