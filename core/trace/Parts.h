// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Parts of pieces (Pieces.h) in lanes: what a ray loses and gains on one, and how far that may be off. Per instruction
/// set, see core/simd/Lanes.h.
///
/// On a part the transfer function is not sampled but averaged over the values of B between the part's ends. That is
/// the mean along the ray as far as B is linear and runs from end to end; what it does besides, and what the mean
/// hides, is the error. Halving a part and comparing (Novins, Arvo, Salesin, "Adaptive Error Bracketing for
/// Controlled-Precision Volume Rendering", 1992) says how good it is.
#if defined(BRICKWALL_CORE_TRACE_PARTS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_PARTS_H
#undef BRICKWALL_CORE_TRACE_PARTS_H
#else
#define BRICKWALL_CORE_TRACE_PARTS_H
#endif

#include "brickwall/core/trace/BoundedTuning.h"
#include "brickwall/core/trace/Pieces.h"
#include "brickwall/core/trace/RegionBounds.h"
#include "brickwall/core/trace/Segments.h"
#include "brickwall/core/trace/TransferIntegralLookup.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// B and what the transfer function makes of it at a place on a piece.
struct PlaceN
{
    FloatN value, slope; ///< slope per piece
    TransferPointN look;
    FloatN shade; ///< cosine of gradient and ray, with its sign
};

/// What is known of a part before anything inside it is looked at.
struct ExtentN
{
    EnclosureN enclosure; ///< of B: Bernstein coefficients, which no polynomial leaves
    Range values;         ///< of the region's cells, which B cannot leave either
    const RegionBounds& bounds;
    FloatN h;      ///< of the part's piece
    FloatN length; ///< in voxels
};

/// A part of a piece with the error that it may have, per transmittance.
struct PartN
{
    SegmentN segment;
    FloatN error;
    FloatN rounding; ///< what no smaller parts would change
};

HWY_INLINE void copyWhere(MaskN lanes, const PlaceN& from, PlaceN& to)
{
    to.value = select(lanes, from.value, to.value);
    to.slope = select(lanes, from.slope, to.slope);
    to.shade = select(lanes, from.shade, to.shade);
    copyWhere(lanes, from.look, to.look);
}

/// How much denser or thinner a part may be at either end than in its mean.
HWY_INLINE FloatN peakOf(const PlaceN& a, const PlaceN& b, const QuadN& mean)
{
    return max(largestChange(mean - a.look.density()), largestChange(mean - b.look.density()));
}

/// The mean over values is that along the ray only as far as B is linear in between: what lies at one place, like a
/// thin shell, counts by 1 / slope there. How much denser or thinner it may be than taken, per length.
HWY_INLINE FloatN misplaced(const PlaceN& a, const PlaceN& b, const QuadN& mean, FloatN h)
{
    const FloatN rise = b.value - a.value;
    const FloatN bend = max(abs(fnma(a.slope, h, rise)), abs(fnma(b.slope, h, rise)));
    const MaskN bent = bend >= abs(rise);
    const FloatN uneven = select(bent, 1.0f, bend / select(bent, 1.0f, abs(rise)));
    const FloatN peak = peakOf(a, b, mean);
    return FloatN(0.5f) * uneven * peak;
}

/// What B shows beyond the values [lo, hi] that were averaged over, as far as the enclosure lets it go there. The
/// enclosure closes in on B with the square of h (variation diminishing), so that halving helps.
HWY_INLINE FloatN missedBeyond(FloatN lo, FloatN hi, const ExtentN& extent)
{
    const FloatN beyond = max(extent.enclosure.hi - hi, lo - extent.enclosure.lo);
    const FloatN noise = FloatN(tuning::enclosureRounding) * max(abs(lo), abs(hi));
    const FloatN unseen = max(beyond - noise, 0.0f);
    // The variation may be infinite, and 0 times that is NaN.
    return valueOrZero(unseen > FloatN(0.0f), unseen * FloatN(extent.bounds.variation) * extent.length);
}

/// The largest difference between the colours of two densities, 0 if one is transparent.
HWY_INLINE FloatN colorTurn(const QuadN& p, const QuadN& q)
{
    const FloatN both = p.d * q.d;
    const FloatN cross =
        max(max(abs(fnma(p.a, q.d, q.a * p.d)), abs(fnma(p.b, q.d, q.b * p.d))), abs(fnma(p.c, q.d, q.c * p.d)));
    const MaskN seen = both > FloatN(0.0f);
    return valueOrZero(seen, cross / select(seen, both, 1.0f));
}

/// The mean colour of a segment, and the light on it, count the front no more than the back, though it hides it: by how
/// much that is wrong if they run from one end to the other.
template <bool shaded>
HWY_INLINE FloatN hiddenColor(const PlaceN& a, const PlaceN& b, const QuadN& mean, const SegmentN& segment,
                              float colorSlope)
{
    const QuadN front = a.look.density(), back = b.look.density();
    const FloatN known = max(colorTurn(front, mean), colorTurn(back, mean));
    // What is transparent at an end has no colour there: then as much as the values allow.
    const FloatN apart = abs(b.look.inside - a.look.inside);
    const FloatN possible = valueOrZero(apart > FloatN(0.0f), min(apart * FloatN(colorSlope), 1.0f));
    const MaskN bothSeen = (front.d > FloatN(0.0f)) & (back.d > FloatN(0.0f));
    FloatN turn = select(bothSeen, known, possible);
    if constexpr (shaded)
        turn += abs(b.shade - a.shade);
    return segment.opacity * turn * min(segment.depth * FloatN(tuning::hidingPerDepth), 1.0f);
}

/// Whether B may turn round twice between two places, which would be a dip of the light that neither of them shows: the
/// slope's middle Bernstein coefficient has the other sign than both its ends.
HWY_INLINE MaskN mayTurnTwice(const PlaceN& a, const PlaceN& b, FloatN h)
{
    const FloatN middle = FloatN(3.0f) * (b.value - a.value) - h * (a.slope + b.slope);
    const FloatN noise = FloatN(3.0f * tuning::valueRounding) * max(abs(a.value), abs(b.value));
    return (a.slope * b.slope > FloatN(0.0f)) & (middle * a.slope < FloatN(0.0f)) & (abs(middle) > noise);
}

/// By how much the density differs from its mean if rounding has moved all values of a part across a knot or a step.
HWY_INLINE FloatN acrossNoise(const TransferIntegralLookup& lookup, MaskN lanes, FloatN lo, FloatN hi,
                              const QuadN& mean)
{
    return max(largestChange(mean - lookup.at(lo, lanes).density()),
               largestChange(mean - lookup.at(hi, lanes).density()));
}

/// Where B hardly changes, rounding of its values decides how long a ray stays in a thin shell, or whether it has
/// entered what is opaque; and that of the values where a shell begins and ends, how thick it is.
HWY_INLINE FloatN roundingOf(const TransferIntegralLookup& lookup, MaskN lanes, const PlaceN& a, const PlaceN& b,
                             const QuadN& mean, const ExtentN& extent, FloatN length)
{
    const FloatN lo = min(a.value, b.value), hi = max(a.value, b.value), rise = hi - lo;
    const FloatN noise = FloatN(tuning::valueRounding) * max(abs(lo), abs(hi));
    const MaskN lost = noise >= rise;
    const FloatN share = select(lost, 1.0f, noise / select(lost, 1.0f, rise));
    constexpr float knot = tuning::knotRounding, ofValues = knot / tuning::valueRounding;
    const FloatN inside =
        min(0.5f * knot * extent.bounds.relativeVariation, ofValues * share * FloatN(extent.bounds.extinction));
    const MaskN atKnot = lost | !(a.look.segment == b.look.segment);
    FloatN off = max(share * peakOf(a, b, mean), valueOrZero(atKnot, inside));
    const FloatN below = max(lo - noise, extent.values.lo), above = min(hi + noise, extent.values.hi);
    const MaskN unclear = lanes & lost & ((below < lo) | (above > hi));
    if (any(unclear))
        off = select(unclear, acrossNoise(lookup, unclear, below, above, mean), off);
    return off * length;
}

/// Whether the values of a part are the same but for rounding, and so more parts would not say more of them.
HWY_INLINE MaskN isRounding(const PlaceN& a, const PlaceN& m, const PlaceN& b)
{
    const FloatN noise = FloatN(tuning::enclosureRounding) * max(abs(a.value), abs(b.value));
    return (abs(m.value - a.value) <= noise) & (abs(b.value - m.value) <= noise);
}

/// A part from a to b by the mean of colour and extinction over the values between its ends.
/// `tints` gives white parts their colours (PartColors.h).
template <bool shaded, class Tints>
HWY_INLINE PartN wholePart(const TransferIntegralLookup& lookup, MaskN lanes, const PlaceN& a, const PlaceN& b,
                           const ExtentN& extent, const Tints& tints)
{
    const QuadN mean = lookup.meanBetween(a.look, b.look);
    SegmentN segment(mean, meanMagnitude(a.shade, b.shade), extent.length);
    const FloatN missed = missedBeyond(min(a.value, b.value), max(a.value, b.value), extent);
    FloatN error = fma(extent.length, misplaced(a, b, mean, extent.h), missed);
    error += hiddenColor<shaded>(a, b, mean, segment, lookup.colorSlope());
    if constexpr (shaded) {
        FloatN turn = fma(abs(b.shade - a.shade), tuning::unseenTurnShare, tuning::unseenTurn);
        turn += valueOrZero(mayTurnTwice(a, b, extent.h), FloatN(tuning::unseenDip));
        error = fma(segment.opacity, turn, error);
    }
    error += tints.whole(a, b, segment);
    return {segment, error, roundingOf(lookup, lanes, a, b, mean, extent, extent.length)};
}

/// The same part by two halves of that kind, with m in the middle. What they change against the whole says how good
/// they are.
template <bool shaded, class Tints>
HWY_INLINE PartN halvedPart(const TransferIntegralLookup& lookup, MaskN lanes, const PlaceN& a, const PlaceN& m,
                            const PlaceN& b, const SegmentN& whole, const ExtentN& extent, const Tints& tints)
{
    const QuadN first = lookup.meanBetween(a.look, m.look), second = lookup.meanBetween(m.look, b.look);
    const FloatN half = FloatN(0.5f) * extent.length;
    SegmentN segment(first, shaded ? meanOverFirstHalf(a.shade, m.shade, b.shade) : FloatN(1.0f), half);
    SegmentN behind(second, shaded ? meanOverFirstHalf(b.shade, m.shade, a.shade) : FloatN(1.0f), half);
    FloatN hiddenColors = fma(segment.through, hiddenColor<shaded>(m, b, second, behind, lookup.colorSlope()),
                              hiddenColor<shaded>(a, m, first, segment, lookup.colorSlope()));
    hiddenColors += fma(segment.through, tints.second(m, b, behind), tints.first(a, m, segment));
    segment.append(behind);

    const FloatN lo = min(min(a.value, b.value), m.value), hi = max(max(a.value, b.value), m.value);
    const FloatN missed = missedBeyond(lo, hi, extent);
    const FloatN halfH = FloatN(0.5f) * extent.h;
    const FloatN shifted = half * (misplaced(a, m, first, halfH) + misplaced(m, b, second, halfH));
    const FloatN hidden = select(isRounding(a, m, b), 0.0f, missed + shifted);
    FloatN error = fma(FloatN(0.5f), segment.differenceFrom(whole), hidden + hiddenColors);
    if constexpr (shaded) {
        const FloatN turn = max(abs(m.shade - a.shade), abs(b.shade - m.shade));
        const MaskN dips = mayTurnTwice(a, m, halfH) | mayTurnTwice(m, b, halfH);
        const FloatN dip = valueOrZero(dips, FloatN(tuning::unseenDip));
        error = fma(segment.opacity, fma(FloatN(tuning::turnShare), turn * turn, dip), error);
    }
    return {segment, error,
            max(roundingOf(lookup, lanes, a, m, first, extent, half),
                roundingOf(lookup, lanes, m, b, second, extent, half))};
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
