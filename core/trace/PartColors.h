// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// What colours of another field make of the parts of a piece, which the bounded method integrates in white. Per
/// instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_PART_COLORS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_PART_COLORS_H
#undef BRICKWALL_CORE_TRACE_PART_COLORS_H
#else
#define BRICKWALL_CORE_TRACE_PART_COLORS_H
#endif

#include "brickwall/core/trace/FieldColors.h"
#include "brickwall/core/trace/Parts.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// The colour field at a place on a piece.
struct ColorPlaceN
{
    FloatN value, slope; ///< slope per piece
    TransferPointN look; ///< of the value, within the range of the colours
};

HWY_INLINE void copyWhere(MaskN lanes, const ColorPlaceN& from, ColorPlaceN& to)
{
    to.value = select(lanes, from.value, to.value);
    to.slope = select(lanes, from.slope, to.slope);
    copyWhere(lanes, from.look, to.look);
}

/// What is known of the colours on a part before anything inside it is looked at.
struct ColorExtentN
{
    EnclosureN enclosure; ///< of the colour field
    FloatN h;             ///< of the part's piece
    float colorSlope;     ///< RegionBounds
};

/// How far a component of the colour can change over values that are so far apart.
HWY_INLINE FloatN largestTurn(FloatN apart, float colorSlope)
{
    // The slope may be infinite, and 0 times that is NaN.
    return valueOrZero(apart > FloatN(0.0f), min(apart * FloatN(colorSlope), 1.0f));
}

/// How much denser or thinner, with the light on it, a part may be at some places than at others, as a share of its
/// mean, twice: by what its ends differ from the mean, by what its front hides of its back, and by the light.
HWY_INLINE FloatN unevenness(const PlaceN& a, const PlaceN& b, const SegmentN& segment, FloatN length)
{
    const FloatN peak =
        abs(a.look.density().d * length - segment.depth) + abs(b.look.density().d * length - segment.depth);
    const FloatN depth = max(segment.depth, FloatN(1e-30f));
    return min(peak / depth, 2.0f) + min(segment.depth, 1.0f) + abs(b.shade - a.shade);
}

/// How far the values between two places may be from being evenly spread between theirs, as a share.
HWY_INLINE FloatN bendOf(const ColorPlaceN& a, const ColorPlaceN& b, FloatN h)
{
    const FloatN rise = b.value - a.value;
    const FloatN bend = max(abs(fnma(a.slope, h, rise)), abs(fnma(b.slope, h, rise)));
    const MaskN bent = bend >= abs(rise);
    return select(bent, 1.0f, bend / select(bent, 1.0f, abs(rise)));
}

/// How far a component of the colour changes on a part.
struct TurnsN
{
    FloatN inside; ///< between the values at its ends
    FloatN beyond; ///< between these and what the enclosure lets the field do, rounding apart
    MaskN steps;   ///< where that may be a step
};

HWY_INLINE TurnsN turnsOf(const TransferIntegralLookup& colors, const ColorPlaceN& a, const ColorPlaceN& b,
                          const ColorExtentN& extent)
{
    const FloatN lo = min(a.value, b.value), hi = max(a.value, b.value);
    const FloatN noise = FloatN(tuning::enclosureRounding) * max(abs(lo), abs(hi));
    const FloatN least = min(extent.enclosure.lo + noise, lo), most = max(extent.enclosure.hi - noise, hi);
    const FloatN beyond = max(most - hi, lo - least);
    TurnsN turns{largestTurn(hi - lo, extent.colorSlope), largestTurn(beyond, extent.colorSlope), firstLanes(0)};
    if (!std::isinf(extent.colorSlope))
        return turns;
    // There is a step in the region. Where no knot is in between, it is not on this part.
    const MaskN all = firstLanes(laneCount);
    const TransferPointN low = colors.at(least, all), high = colors.at(most, all);
    turns.steps = !(low.segment == high.segment);
    const FloatN apart = largestChange(high.limit - low.limit);
    turns.inside = select(turns.steps, turns.inside, apart);
    turns.beyond = select(turns.steps, turns.beyond, apart);
    return turns;
}

/// Gives a part from a to b, integrated in white, the mean colour over the values between its ends, and returns by how
/// much that is wrong, per transmittance:
/// - The mean of a product is not the product of the means: the difference is at most a quarter of how far the one
///   changes times how far the other does (Gruess, "Ueber das Maximum des absoluten Betrages ...", 1935).
/// - The mean over values is that along the ray as far as these are evenly spread (`misplaced` in Parts.h); a step may
///   be anywhere.
/// - What the field does beyond the values at the ends, as far as the enclosure lets it, is not in that mean.
/// Not inlined, nor is tintRounding: the five copies of each kernel took half of the sanitizers' time to compile it.
HWY_NOINLINE inline FloatN tint(const TransferIntegralLookup& colors, const PlaceN& a, const PlaceN& b,
                                const ColorPlaceN& ca, const ColorPlaceN& cb, const ColorExtentN& extent, FloatN length,
                                SegmentN& segment)
{
    const QuadN mean = colors.meanBetween(ca.look, cb.look);
    const TurnsN turns = turnsOf(colors, ca, cb, extent);
    const FloatN bend = bendOf(ca, cb, extent.h);
    const FloatN misplaced = select(turns.steps, bend, FloatN(0.5f) * bend);
    const FloatN share = fma(FloatN(0.25f), unevenness(a, b, segment, length), misplaced);
    const FloatN off = min(fma(turns.inside, min(share, 1.0f), turns.beyond), 1.0f);
    segment.red *= mean.a;
    segment.green *= mean.b;
    segment.blue *= mean.c;
    return segment.opacity * off;
}

/// Where the field hardly changes, rounding of its values decides on which side of a step of the colours a part is.
HWY_NOINLINE inline FloatN tintRounding(const TransferIntegralLookup& colors, MaskN lanes, const ColorPlaceN& a,
                                        const ColorPlaceN& b, float colorSlope)
{
    if (!std::isinf(colorSlope))
        return 0.0f;
    const FloatN lo = min(a.value, b.value), hi = max(a.value, b.value);
    const FloatN noise = FloatN(tuning::valueRounding) * max(abs(lo), abs(hi));
    const MaskN lost = lanes & (noise >= hi - lo);
    if (none(lost))
        return 0.0f;
    const QuadN below = colors.at(lo - noise, lost).limit, above = colors.at(hi + noise, lost).limit;
    return valueOrZero(lost, largestChange(above - below));
}

/// The parts of a volume whose colours are its own field's: nothing is to be done.
struct NoTints
{
    HWY_INLINE FloatN whole(const PlaceN&, const PlaceN&, SegmentN&) const { return 0.0f; }
    HWY_INLINE FloatN first(const PlaceN&, const PlaceN&, SegmentN&) const { return 0.0f; }
    HWY_INLINE FloatN second(const PlaceN&, const PlaceN&, SegmentN&) const { return 0.0f; }
};

/// Of a part with the places a, m (the middle) and b, whose halves may be tinted by themselves.
struct TintsN
{
    const TransferIntegralLookup& colors;
    const ColorPlaceN &a, &m, &b;
    const ColorExtentN& extent;
    FloatN length;

    HWY_INLINE FloatN whole(const PlaceN& start, const PlaceN& end, SegmentN& segment) const
    {
        return tint(colors, start, end, a, b, extent, length, segment);
    }
    HWY_INLINE FloatN first(const PlaceN& start, const PlaceN& end, SegmentN& segment) const
    {
        return tint(colors, start, end, a, m, half(a, m), FloatN(0.5f) * length, segment);
    }
    HWY_INLINE FloatN second(const PlaceN& start, const PlaceN& end, SegmentN& segment) const
    {
        return tint(colors, start, end, m, b, half(m, b), FloatN(0.5f) * length, segment);
    }

private:
    /// What the enclosure lets the field do is charged once, to both halves.
    HWY_INLINE ColorExtentN half(const ColorPlaceN& start, const ColorPlaceN& end) const
    {
        const FloatN lo = min(min(a.value, b.value), m.value), hi = max(max(a.value, b.value), m.value);
        const FloatN below = max(lo - extent.enclosure.lo, 0.0f), above = max(extent.enclosure.hi - hi, 0.0f);
        return {{min(start.value, end.value) - below, max(start.value, end.value) + above},
                FloatN(0.5f) * extent.h,
                extent.colorSlope};
    }
};

/// The colour field on the pieces of a region. Pieces: OneBrickPieces or SeveralBricksPieces.
template <class Pieces>
class PieceColors
{
public:
    HWY_INLINE PieceColors(const TraceScene& scene, const Region& region, const RayN& ray,
                           const TransferIntegralLookup& colors)
        : colors_(colors),
          ends_(scene.colors.integral->range),
          piece_(*scene.regions, region, scene.colors.field->values.data(), scene.origin, ray)
    {
    }

    HWY_INLINE void load(FloatN t0, FloatN t1) { piece_.load(t0, t1); }
    HWY_INLINE int fetches() const { return piece_.fetches(); }

    HWY_INLINE ColorPlaceN at(FloatN s, MaskN lanes) const
    {
        ColorPlaceN place;
        piece_.at(s, place.value, place.slope);
        place.value = clamp(place.value, ends_.lo, ends_.hi);
        place.look = colors_.at(place.value, lanes);
        return place;
    }

    /// Of the values that the colours are of, on [s0, s1].
    HWY_INLINE EnclosureN enclosure(FloatN s0, FloatN s1) const
    {
        const EnclosureN e = piece_.enclosure(s0, s1);
        return {clamp(e.lo, ends_.lo, ends_.hi), clamp(e.hi, ends_.lo, ends_.hi)};
    }

private:
    const TransferIntegralLookup& colors_;
    Range ends_;
    Pieces piece_;
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
