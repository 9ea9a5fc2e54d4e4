// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Segments of rays in lanes, each with a mean colour and extinction, and the light on them. Per instruction set, see
/// core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_SEGMENTS_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_SEGMENTS_H
#undef BRICKWALL_CORE_TRACE_SEGMENTS_H
#else
#define BRICKWALL_CORE_TRACE_SEGMENTS_H
#endif

#include "brickwall/core/simd/Lanes.h"

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

/// Of a difference (c sigma, sigma): the largest change of what is seen, whatever colour in [0, 1] lies behind.
HWY_INLINE FloatN largestChange(const QuadN& d)
{
    return max(max(max(abs(d.a), abs(d.a - d.d)), max(abs(d.b), abs(d.b - d.d))),
               max(max(abs(d.c), abs(d.c - d.d)), abs(d.d)));
}

/// (1 - e^-x) / x and `through` = e^-x: a series where lanes are thin, which needs neither exponential nor division.
HWY_INLINE FloatN absorbedPerDepth(FloatN x, FloatN& through)
{
    FloatN series = fnma(x, 1.0f / 40320.0f, 1.0f / 5040.0f);
    for (const float factorial : {720.0f, 120.0f, 24.0f, 6.0f, 2.0f, 1.0f})
        series = fnma(x, series, 1.0f / factorial);
    const MaskN thin = x <= FloatN(0.5f);
    const FloatN seriesThrough = fnma(x, series, 1.0f);
    if (all(thin)) {
        through = seriesThrough;
        return series;
    }
    through = select(thin, seriesThrough, exp(-x));
    return select(thin, series, (FloatN(1.0f) - through) / select(thin, 1.0f, x));
}

/// A segment of a ray with the mean colour and extinction that it has.
struct SegmentN
{
    FloatN red, green, blue;        ///< that it adds
    FloatN depth, through, opacity; ///< through = exp(-depth) = 1 - opacity

    /// `mean` is (c sigma, sigma), `shade` what the light makes of the colour.
    HWY_INLINE SegmentN(const QuadN& mean, FloatN shade, FloatN length)
    {
        depth = mean.d * length;
        const FloatN ratio = absorbedPerDepth(depth, through);
        opacity = depth * ratio;
        const FloatN scale = length * ratio * shade;
        red = mean.a * scale;
        green = mean.b * scale;
        blue = mean.c * scale;
    }

    /// This one in front of another.
    HWY_INLINE void append(const SegmentN& next)
    {
        red = fma(through, next.red, red);
        green = fma(through, next.green, green);
        blue = fma(through, next.blue, blue);
        opacity = fma(through, next.opacity, opacity);
        depth += next.depth;
        through *= next.through;
    }

    /// How far another estimate of the same is off, whatever colour in [0, 1] lies behind.
    HWY_INLINE FloatN differenceFrom(const SegmentN& other) const
    {
        const FloatN a = opacity - other.opacity;
        const FloatN r = red - other.red, g = green - other.green, b = blue - other.blue;
        return max(max(max(abs(r), abs(r - a)), max(abs(g), abs(g - a))), max(max(abs(b), abs(b - a)), abs(a)));
    }
};

/// The mean of |x| for an x that is linear between two values.
HWY_INLINE FloatN meanMagnitude(FloatN a, FloatN b)
{
    const FloatN sum = abs(a) + abs(b);
    const FloatN crossing = fma(a, a, b * b) / max(sum, FloatN(1e-10f));
    return FloatN(0.5f) * select(a * b < FloatN(0.0f), crossing, sum);
}

/// The mean of |cosine| over the half from a to m: of the parabola through a, m and b, or where it changes its sign, of
/// the line.
HWY_INLINE FloatN meanOverFirstHalf(FloatN a, FloatN m, FloatN b)
{
    const FloatN parabola = fma(FloatN(5.0f), a, fnma(FloatN(1.0f), b, FloatN(8.0f) * m)) * FloatN(1.0f / 12.0f);
    const MaskN turns = (a * m < FloatN(0.0f)) | (m * b < FloatN(0.0f));
    return select(turns, meanMagnitude(a, m), min(abs(parabola), 1.0f));
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
