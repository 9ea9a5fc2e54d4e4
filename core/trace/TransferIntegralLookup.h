// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Extinction, emission and their means over intervals of values in lanes, from the integrals of a transfer function.
/// Per instruction set, see core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_TRANSFER_INTEGRAL_LOOKUP_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_TRANSFER_INTEGRAL_LOOKUP_H
#undef BRICKWALL_CORE_TRACE_TRANSFER_INTEGRAL_LOOKUP_H
#else
#define BRICKWALL_CORE_TRACE_TRANSFER_INTEGRAL_LOOKUP_H
#endif

#include "brickwall/core/shade/TransferIntegral.h"
#include "brickwall/core/simd/Lanes.h"

#include <bit>
#include <cstdint>

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

HWY_INLINE QuadN operator+(const QuadN& p, const QuadN& q)
{
    return {p.a + q.a, p.b + q.b, p.c + q.c, p.d + q.d};
}
HWY_INLINE QuadN operator-(const QuadN& p, const QuadN& q)
{
    return {p.a - q.a, p.b - q.b, p.c - q.c, p.d - q.d};
}
HWY_INLINE QuadN operator*(const QuadN& p, FloatN s)
{
    return {p.a * s, p.b * s, p.c * s, p.d * s};
}
HWY_INLINE QuadN fma(const QuadN& p, FloatN s, const QuadN& q)
{
    return {fma(p.a, s, q.a), fma(p.b, s, q.b), fma(p.c, s, q.c), fma(p.d, s, q.d)};
}
HWY_INLINE QuadN select(MaskN m, const QuadN& p, const QuadN& q)
{
    return {select(m, p.a, q.a), select(m, p.b, q.b), select(m, p.c, q.c), select(m, p.d, q.d)};
}
HWY_INLINE QuadN valueOrZero(MaskN m, const QuadN& p)
{
    return {valueOrZero(m, p.a), valueOrZero(m, p.b), valueOrZero(m, p.c), valueOrZero(m, p.d)};
}

/// A value on a transfer function. Quads are (c sigma, sigma), see TransferIntegral.
struct TransferPointN
{
    FloatN value;   ///< as asked for
    FloatN inside;  ///< clamped to the range
    MaskN within;   ///< whether that was not necessary
    FloatN above;   ///< inside - the segment's lower knot
    FloatN segment; ///< an index
    QuadN limit;    ///< c sigma, sigma; outside the range that of its nearest end
    QuadN slope;    ///< d limit / d value, of the segment

    /// c sigma and sigma; 0 outside the range.
    HWY_INLINE QuadN density() const { return valueOrZero(within, limit); }
};

HWY_INLINE void copyWhere(MaskN lanes, const TransferPointN& from, TransferPointN& to)
{
    to.value = select(lanes, from.value, to.value);
    to.inside = select(lanes, from.inside, to.inside);
    to.within = (lanes & from.within) | andNot(to.within, lanes);
    to.above = select(lanes, from.above, to.above);
    to.segment = select(lanes, from.segment, to.segment);
    to.limit = select(lanes, from.limit, to.limit);
    to.slope = select(lanes, from.slope, to.slope);
}

class TransferIntegralLookup
{
public:
    explicit TransferIntegralLookup(const TransferIntegral& integral)
        : knots_(integral.knots.data()),
          records_(&integral.segments.front().integral.x),
          firstSegments_(integral.firstSegments.data()),
          buckets_(&integral.buckets.front().density.x),
          lo_(integral.range.lo),
          hi_(integral.range.hi),
          logarithmic_(integral.scale == Scale::logarithmic),
          colorSlope_(integral.colorSlope),
          bucketsPerUnit_(integral.bucketsPerUnit),
          bucketShift_(integral.bucketShift)
    {
    }

    float colorSlope() const { return colorSlope_; }

    /// c sigma and sigma where nothing else is asked of a value; 0 outside the range and in lanes that are not active.
    HWY_INLINE QuadN densityAt(FloatN value, MaskN active) const
    {
        const MaskN within = active & (value >= FloatN(lo_)) & (value <= FloatN(hi_));
        const BucketN bucket = bucketOf(select(within, value, lo_));
        const IntN line = bucket.index * IntN(8);
        const QuadN start = gatherQuads(QuadAt{buckets_}, line);
        if (!all(start.d == start.d)) // not a line in there
            return at(value, active).density();
        return valueOrZero(within, fma(gatherQuads(QuadAt{buckets_ + 4}, line), bucket.f, start));
    }

    /// Lanes that are not active get the lower end of the range.
    HWY_INLINE TransferPointN at(FloatN value, MaskN active) const
    {
        TransferPointN p;
        p.value = select(active, value, lo_);
        p.inside = clamp(p.value, lo_, hi_);
        p.within = (p.value >= FloatN(lo_)) & (p.value <= FloatN(hi_));
        p.segment = segmentOf(p.inside);
        const IntN index = toInt(p.segment);
        p.above = p.inside - gather(knots_, index);
        p.slope = quad(slopeAt, index);
        p.limit = fma(p.slope, p.above, quad(limitAt, index));
        return p;
    }

    /// Q and S, constant outside the range.
    HWY_INLINE QuadN integral(const TransferPointN& p) const
    {
        return fma(fma(p.slope, p.above * FloatN(-0.5f), p.limit), p.above, quad(integralAt, toInt(p.segment)));
    }

    /// The mean of c sigma and sigma over the values between two points, either of which may be the larger; the density
    /// where they are the same. Without cancellation: whole segments count by the difference of their integrals, parts
    /// of segments by themselves.
    HWY_INLINE QuadN meanBetween(const TransferPointN& a, const TransferPointN& b) const
    {
        const MaskN together = a.segment == b.segment;
        const FloatN apart = abs(b.value - a.value), covered = abs(b.inside - a.inside);
        // Of the interval, as much as lies in the range; a point alone lies in it or not.
        const MaskN distinct = apart > FloatN(1e-37f); // denormals have no reciprocals
        const FloatN length = select(distinct, apart, 1.0f);
        const FloatN share = select(distinct, covered / length, valueOrZero(a.within, FloatN(1.0f)));
        const QuadN inOne = (a.limit + b.limit) * (FloatN(0.5f) * share);
        const MaskN one = together | !distinct;
        if (all(one))
            return inOne;
        return select(one, inOne, acrossSegments(a, b, together) * (FloatN(1.0f) / length));
    }

private:
    static constexpr int integralAt = 0, restAt = 4, limitAt = 8, slopeAt = 12;
    static_assert(sizeof(TransferIntegral::Segment) == 16 * sizeof(float));

    HWY_INLINE QuadN quad(int part, IntN segment) const
    {
        return gatherQuads(QuadAt{records_ + part}, segment * IntN(16));
    }

    /// The integral from the lower to the upper of two points in different segments.
    HWY_INLINE QuadN acrossSegments(const TransferPointN& a, const TransferPointN& b, MaskN together) const
    {
        const MaskN ascending = a.segment < b.segment;
        const auto lower = [&](auto get) LANES_LAMBDA { return select(ascending, get(a), get(b)); };
        const auto upper = [&](auto get) LANES_LAMBDA { return select(ascending, get(b), get(a)); };
        const auto limit = [](const TransferPointN& p) LANES_LAMBDA { return p.limit; };
        const auto slope = [](const TransferPointN& p) LANES_LAMBDA { return p.slope; };
        const auto inside = [](const TransferPointN& p) LANES_LAMBDA { return p.inside; };
        const auto above = [](const TransferPointN& p) LANES_LAMBDA { return p.above; };
        const auto segment = [](const TransferPointN& p) LANES_LAMBDA { return p.segment; };

        const IntN first = toInt(lower(segment) + valueOrZero(!together, FloatN(1.0f)));
        const IntN last = toInt(upper(segment));
        const FloatN below = gather(knots_, first) - lower(inside), beyond = upper(above);
        const QuadN start = fma(lower(slope), below * FloatN(0.5f), lower(limit)) * below;
        const QuadN end = fma(upper(slope), beyond * FloatN(-0.5f), upper(limit)) * beyond;

        const QuadN to = quad(integralAt, last);
        QuadN between = to - quad(integralAt, first);
        // Narrow against what lies below: the integrals' last digits count.
        const MaskN narrow = andNot(between.d < to.d * FloatN(1e-3f), first == last);
        if (any(narrow))
            between = between + valueOrZero(narrow, quad(restAt, last) - quad(restAt, first));
        return between + start + end;
    }

    HWY_INLINE FloatN segmentOf(FloatN value) const
    {
        const IntN bucket = bucketOf(value).index;
        FloatN first = gather(firstSegments_, bucket), last = gather(firstSegments_ + 1, bucket);
        while (any(first < last)) {
            const FloatN middle = floor(fma(first + last, 0.5f, 0.5f));
            const MaskN reached = gather(knots_, toInt(middle)) <= value;
            first = select(reached, middle, first);
            last = select(reached, last, max(middle - FloatN(1.0f), first));
        }
        return first;
    }

    struct BucketN
    {
        IntN index;
        FloatN f; ///< where in it, in [0, 1] up to rounding
    };

    HWY_INLINE BucketN bucketOf(FloatN value) const
    {
        if (logarithmic_) {
            const IntN bits = bitsOf(value) - IntN(std::bit_cast<std::int32_t>(lo_));
            const IntN index = shiftRight(bits, bucketShift_);
            return {index, toFloat(bits - shiftLeft(index, bucketShift_)) * FloatN(1.0f / float(1 << bucketShift_))};
        }
        const FloatN x = (value - FloatN(lo_)) * FloatN(bucketsPerUnit_);
        const IntN index = toInt(x);
        return {index, x - toFloat(index)};
    }

    const float* knots_;
    const float* records_;
    const float* firstSegments_;
    const float* buckets_;
    float lo_, hi_;
    bool logarithmic_;
    float colorSlope_;
    float bucketsPerUnit_;
    int bucketShift_;
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
