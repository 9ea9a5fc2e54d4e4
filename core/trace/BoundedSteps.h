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
#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

template <bool shaded, bool colored>
class BoundedSteps
{
public:
    HWY_INLINE BoundedSteps(BoundedRays& rays, const Region& region, std::uint32_t index)
        : rays_(rays),
          bounds_(rays.scene.regionBounds[index]),
          range_(rays.scene.field->regionRanges[index]),
          index_(index),
          brickCount_(region.brickCount),
          width_(static_cast<float>(1 << region.finestLevel)),
          shortest_(width_ * (brickCount_ == 1 ? tuning::shortestStep : tuning::shortestStepOfSeveral))
    {
    }

    /// Through [t0, t1] of the region, in which field(point) samples B; returns where it got to.
    template <class Field>
    HWY_INLINE FloatN operator()(MaskN active, FloatN t0, FloatN t1, const Field& field)
    {
        BoundedRays& r = rays_;
        const MaskN first = active & (r.step <= FloatN(0.0f));
        r.step = select(first, FloatN(tuning::firstStep * width_), r.step);
        const LimitsN limits = limitsOf(t0, t1 - t0, active);
        const MaskN lanes = active & (limits.faint | (min(r.step, limits.longest) >= FloatN(shortest_)));
        const MaskN fresh = andNot(lanes & (r.lastAt < t0), limits.faint);
        if (any(fresh)) {
            r.last = select(fresh, densityAt(field, t0), r.last);
            r.lastStep = select(fresh, 0.0f, r.lastStep);
            countSamples(static_cast<std::uint64_t>(count(fresh)));
        }
        const FloatN t = any(lanes) ? march(lanes, t0, t1, limits, field) : t0;
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

    HWY_INLINE LimitsN limitsOf(FloatN t0, FloatN length, MaskN active) const
    {
        LimitsN limits;
        const FloatN through = rays_.radiance.transmittance, most = through * FloatN(bounds_.extinction);
        limits.perLength = rays_.budget.perLength(t0);
        limits.squares = rays_.budget.squares(limits.perLength);
        limits.faint = most * most * length <= limits.squares;
        limits.longest = length;
        // Between samples, extinction cannot change by more than this share of its largest, or that does not matter.
        const float resolved = tuning::resolvedChange * bounds_.extinction / std::max(bounds_.variationAlong, 1e-30f);
        constexpr float excess = tuning::resolvedTrust * tuning::resolvedTrust * tuning::resolvedTrust;
        const FloatN worst = FloatN(0.25f / tuning::trust) * through * FloatN(bounds_.variationAlong); // h^2
        const FloatN wanted = min(rays_.step, length), square = worst * worst;
        const FloatN errs = wanted * wanted * wanted * square;
        const MaskN allowed =
            (errs <= limits.squares) | ((errs <= FloatN(excess) * limits.squares) & (wanted <= FloatN(resolved)));
        if (any(andNot(andNot(active, limits.faint), allowed))) {
            const FloatN trusted = cubeRoot(limits.squares / max(square, FloatN(1e-30f)));
            limits.longest = min(length, max(trusted, min(FloatN(resolved), FloatN(tuning::resolvedTrust) * trusted)));
        }
        return limits;
    }

    /// Steps of the same length from `start` up to where the lanes end.
    struct StepN
    {
        FloatN start, h;
        FloatN taken, left; ///< their numbers
        FloatN squares;     ///< what errors of one may be, squared
        FloatN reciprocal;  ///< 1 / (12 h)
    };

    HWY_INLINE void divide(MaskN lanes, FloatN start, FloatN t1, FloatN wanted, const LimitsN& limits,
                           StepN& step) const
    {
        const FloatN length = t1 - start;
        step.start = select(lanes, start, step.start);
        step.taken = select(lanes, 0.0f, step.taken);
        step.left = select(lanes, ceil(length / wanted), step.left);
        step.h = select(lanes, length / step.left, step.h);
        step.squares = limits.squares * step.h * shortSteps(step.h);
        step.reciprocal = FloatN(1.0f / 12.0f) / step.h;
    }

    /// How much more than their share by length the squares of steps may be: errors equal per length would put too many
    /// steps where the data are dense, for the least work errors are equal per step. Half way, and not to overdraw.
    HWY_INLINE FloatN shortSteps(FloatN h) const { return min(sqrt(FloatN(width_) / h), tuning::mostShortSteps); }

    /// What steps have erred, and might have.
    struct ErrorsN
    {
        FloatN squares; ///< of what may go either way
        FloatN biases;  ///< what goes the same way in every step
        FloatN shares;  ///< of the budget, for biases
    };

    /// In equal steps from t0, shorter ones from where they do not do, to t1 or to where they would be too short.
    template <class Field>
    HWY_INLINE FloatN march(MaskN lanes, FloatN t0, FloatN t1, const LimitsN& limits, const Field& field)
    {
        BoundedRays& r = rays_;
        StepN step{t0, 1.0f, 0.0f, 1.0f, 0.0f, 0.0f};
        divide(lanes, t0, t1, select(limits.faint, t1 - t0, min(r.step, limits.longest)), limits, step);
        ErrorsN sum{0.0f, 0.0f, 0.0f};
        MaskN todo = lanes, shorter = firstLanes(0);
        FloatN t = t0, end = t1;
        while (any(todo)) {
            const QuadN density = densityAt(field, fma(0.5f, step.h, t)), rise = density - r.last;
            countSamples(static_cast<std::uint64_t>(count(todo)));
            const ErrorsN error = errorOf(density, rise, step.h, limits);
            const FloatN excess = tuning::acceptedExcess;
            const MaskN small = (error.squares <= excess * step.squares) & (error.biases <= excess * error.shares);
            const MaskN good = todo & (limits.faint | small), bad = andNot(todo, good);
            sum.squares += valueOrZero(good, error.squares);
            sum.biases += valueOrZero(good, error.biases);
            sum.shares += valueOrZero(good, error.shares);
            r.add(good, SegmentN(corrected(density, rise, step, limits.faint), 1.0f, step.h), t, step.h);
            r.last = select(good, density, r.last);
            r.lastStep = select(good, step.h, r.lastStep);
            // Where to go next does not wait for what was found here: the next cells are fetched meanwhile.
            step.taken += FloatN(1.0f);
            step.left = step.left - FloatN(1.0f);
            t = fma(step.taken, step.h, step.start);
            todo = todo & (step.left > FloatN(0.5f)) & r.goOn();
            if (any(bad)) {
                t = select(bad, fma(step.taken - FloatN(1.0f), step.h, step.start), t);
                divide(bad, t, t1, step.h * FloatN(tuning::shorten), limits, step);
                const MaskN tooShort = bad & (step.h < FloatN(shortest_));
                end = select(tooShort, t, end);
                shorter = shorter | bad;
                todo = andNot(todo | bad, tooShort);
            }
        }
        const FloatN length = end - t0;
        charge(lanes & (length > FloatN(0.0f)), length, sum);
        suggest(lanes, shorter, step, sum, limits.squares * length * shortSteps(step.h));
        return select(lanes, end, t0);
    }

    /// Of a step that is taken to be as its middle, judged by the change since the last sample.
    HWY_INLINE ErrorsN errorOf(const QuadN& density, const QuadN& rise, FloatN h, const LimitsN& limits) const
    {
        const FloatN change = largestChange(rise), weight = rays_.radiance.transmittance * h;
        // What the light does between samples is not known: half of it may be wrong.
        const FloatN unknown = shaded ? FloatN(0.5f) * density.d : FloatN(0.0f);
        const FloatN errs = weight * min(fma(FloatN(0.25f), change, unknown), bounds_.extinction);
        // What lies in the front half of a step hides what lies behind: always the same way, so it adds up.
        const FloatN opacity = min(density.d * h, 1.0f);
        const FloatN bias = weight * change * opacity * FloatN(1.0f / 12.0f);
        return {errs * errs, bias, rays_.budget.share(limits.perLength, h, opacity)};
    }

    /// The midpoint rule errs by h^2 / 24 times what the slope changes by from one end of a step to the other (Euler
    /// and Maclaurin). That cancels from step to step as long as their lengths are the same, and leaves (h - h_before)
    /// / 12 times the change of the density where they are not. Steps of very different lengths do not know each
    /// other's slope, nor do faint ones, which may be as long as they like.
    HWY_INLINE QuadN corrected(const QuadN& density, const QuadN& rise, const StepN& step, MaskN faint) const
    {
        const FloatN before = rays_.lastStep, half = FloatN(0.5f) * step.h;
        const MaskN alike = (before == FloatN(0.0f)) | ((before >= half) & (before <= step.h + step.h));
        const FloatN share = valueOrZero(andNot(alike, faint), (before - step.h) * step.reciprocal);
        const QuadN d = fma(rise, share, density);
        return {max(d.a, 0.0f), max(d.b, 0.0f), max(d.c, 0.0f), max(d.d, 0.0f)};
    }

    /// c sigma and sigma, the light included.
    template <class Field>
    HWY_INLINE QuadN densityAt(const Field& field, FloatN t) const
    {
        const SampleN s = field(rays_.pointAt(t));
        QuadN density = rays_.lookup.densityAt(clamp(s.value, range_.lo, range_.hi), s.valid);
        if constexpr (colored) {
            if (any(density.d > FloatN(0.0f))) {
                const FloatN value = colorValueAt(rays_.scene, index_, rays_.pointAt(t));
                density = withColor(density, rays_.colors.densityAt(value, s.valid));
            }
        }
        if constexpr (shaded) {
            const FloatN light = rays_.headlight(s.gradient);
            return {density.a * light, density.b * light, density.c * light, density.d};
        } else {
            return density;
        }
    }

    HWY_INLINE void charge(MaskN lanes, FloatN length, const ErrorsN& sum)
    {
        rays_.budget.addToSum(lanes, sum.biases);
        rays_.budget.addToSquares(sum.squares);
        // A ray crosses 1.5 planes through cell centres per cell on average.
        const FloatN pieces = max(floor(length * FloatN(1.5f / width_)) - FloatN(1.0f), 0.0f);
        rays_.counts.piecesMerged +=
            static_cast<std::uint64_t>(brickwall::HWY_NAMESPACE::sum(valueOrZero(lanes, pieces)));
    }

    /// The next step: longer or shorter by what these have erred against what they might have.
    HWY_INLINE void suggest(MaskN lanes, MaskN shortened, const StepN& step, const ErrorsN& sum, FloatN squares)
    {
        const MaskN tooFine = (sum.squares < FloatN(tuning::tooFineSquare) * squares) &
                              (sum.biases < FloatN(tuning::tooFineBias) * sum.shares);
        const MaskN tooCoarse = (sum.squares > squares) | (sum.biases > sum.shares);
        const FloatN longer = max(rays_.step, step.h * select(tooFine, tuning::lengthen, 1.0f));
        const FloatN next = select(shortened, step.h, select(tooCoarse, step.h * FloatN(tuning::shorten), longer));
        rays_.step = select(lanes, next, rays_.step);
    }

    HWY_INLINE void countSamples(std::uint64_t n)
    {
        constexpr std::uint64_t fields = colored ? 2 : 1;
        rays_.counts.samples += n * fields;
        rays_.counts.fetches += n * fields * brickCount_;
    }

    BoundedRays& rays_;
    const RegionBounds& bounds_;
    const Range& range_;
    std::uint32_t index_; ///< of the region
    std::uint32_t brickCount_;
    float width_;    ///< of a cell
    float shortest_; ///< step
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
