// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/TransferIntegralTables.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace brickwall {
namespace {

constexpr int mostBuckets = 4096; // 128 KB of lines, of which neighbouring rays use a small part

std::vector<std::vector<float>> maximaOf(std::vector<float> values)
{
    std::vector<std::vector<float>> levels{std::move(values)};
    const std::size_t size = levels[0].size();
    for (std::size_t width = 2; width <= size; width *= 2) {
        const std::vector<float>& half = levels.back();
        std::vector<float> level(size - width + 1);
        for (std::size_t i = 0; i < level.size(); ++i)
            level[i] = std::max(half[i], half[i + width / 2]);
        levels.push_back(std::move(level));
    }
    return levels;
}

/// Over first .. end - 1; 0 if there are none.
float maximumOver(const std::vector<std::vector<float>>& levels, int first, int end)
{
    if (first >= end)
        return 0.0f;
    const int k = int(std::bit_width(unsigned(end - first))) - 1;
    return std::max(levels[k][first], levels[k][end - (1 << k)]);
}

float roundedUp(float x)
{
    return x > 0.0f ? x * (1.0f + 4.0f * std::numeric_limits<float>::epsilon()) : 0.0f;
}

float extinctionIn(const TransferIntegral& f, int segment, float value)
{
    const TransferIntegral::Segment& s = f.segments[segment];
    return std::max(0.0f, s.density.w + s.slope.w * (value - f.knots[segment]));
}

float variationOf(const TransferIntegral::Segment& segment)
{
    const vec4f& s = segment.slope;
    float largest = std::abs(s.w);
    for (int c = 0; c < 3; ++c)
        largest = std::max({largest, std::abs(s[c]), std::abs(s.w - s[c])});
    return roundedUp(largest);
}

void tabulateMaxima(TransferIntegral& f, const std::vector<bool>& steps)
{
    std::vector<float> extinction, variation, logVariation;
    for (int i = 0; i < int(f.segments.size()); ++i) {
        extinction.push_back(roundedUp(std::max(f.segments[i].density.w, extinctionIn(f, i, f.knots[i + 1]))));
        variation.push_back(steps[i] ? std::numeric_limits<float>::infinity() : variationOf(f.segments[i]));
        logVariation.push_back(variation.back() * f.knots[i + 1]); // the density is linear in v
    }
    if (f.scale == Scale::logarithmic)
        f.maxLogVariation = maximaOf(std::move(logVariation));
    f.maxExtinction = maximaOf(std::move(extinction));
    f.maxVariation = maximaOf(std::move(variation));
}

void tabulateBuckets(TransferIntegral& f)
{
    if (f.scale == Scale::linear) {
        f.bucketsPerUnit = float(mostBuckets / (double(f.range.hi) - double(f.range.lo)));
    } else {
        const auto span = std::bit_cast<std::uint32_t>(f.range.hi) - std::bit_cast<std::uint32_t>(f.range.lo);
        f.bucketShift = std::max(0, int(std::bit_width(span)) - int(std::bit_width(unsigned(mostBuckets - 1))));
    }
    // firstSegments[b] is the last segment that begins in a bucket below b: buckets ascend with the value.
    f.firstSegments.assign(std::size_t(f.bucketOf(f.range.hi)) + 2, 0.0f);
    for (std::size_t i = 0; i < f.segments.size(); ++i)
        f.firstSegments[std::size_t(f.bucketOf(f.knots[i])) + 1] = float(i);
    for (std::size_t b = 1; b < f.firstSegments.size(); ++b)
        f.firstSegments[b] = std::max(f.firstSegments[b], f.firstSegments[b - 1]);
}

/// Where a value is, in buckets, as lanes find it: linear in the value, or in its bits.
double bucketPlace(const TransferIntegral& f, double value)
{
    if (f.scale == Scale::linear)
        return (value - double(f.range.lo)) * double(f.bucketsPerUnit);
    const auto bits = [](float v) { return double(std::bit_cast<std::uint32_t>(v)); };
    return (bits(float(value)) - bits(f.range.lo)) / double(1u << f.bucketShift);
}

/// A bucket's lower edge; `bucketOf` rounds, so that values next to it may count for the other side.
double bucketEdge(const TransferIntegral& f, std::size_t bucket)
{
    if (f.scale == Scale::linear)
        return double(f.range.lo) + double(bucket) / double(f.bucketsPerUnit);
    const auto bits = std::bit_cast<std::uint32_t>(f.range.lo) + (std::uint32_t(bucket) << f.bucketShift);
    return double(std::bit_cast<float>(bits));
}

vec4d densityIn(const TransferIntegral& f, int segment, double value)
{
    const TransferIntegral::Segment& s = f.segments[segment];
    return glm::max(vec4d(s.density) + vec4d(s.slope) * (value - double(f.knots[segment])), 0.0);
}

/// The line through the ends of a bucket, if it says what is in between.
TransferIntegral::Bucket bucketLine(const TransferIntegral& f, std::size_t bucket)
{
    const int first = int(f.firstSegments[bucket]), last = int(f.firstSegments[bucket + 1]);
    const double lo = bucketEdge(f, bucket), hi = bucketEdge(f, bucket + 1);
    const vec4d start = densityIn(f, first, lo), rise = densityIn(f, last, hi) - start;
    const auto isMet = [&](int segment, double value) {
        const vec4d exact = densityIn(f, segment, value);
        const vec4d off = glm::abs(exact - start - rise * (bucketPlace(f, value) - double(bucket)));
        const double allowed = 1e-4 * exact.w + 1e-6 * double(f.maxExtinction.back().front());
        return std::max({off.x, off.y, off.z, off.w}) <= allowed;
    };
    bool met = true;
    for (int knot = first + 1; knot <= last; ++knot)
        met = met && isMet(knot - 1, f.knots[knot]) && isMet(knot, f.knots[knot]);
    // The bits of values double their meaning where the exponent changes.
    const double power = std::exp2(std::floor(std::log2(hi)));
    if (f.scale == Scale::logarithmic && power > lo)
        met = met && isMet(power < f.knots[last] ? first : last, power);
    const float absent = met ? 0.0f : std::numeric_limits<float>::quiet_NaN();
    return {vec4f(start) + absent, vec4f(rise)};
}

void tabulateBucketLines(TransferIntegral& f)
{
    for (std::size_t b = 0; b < std::size_t(f.bucketCount()); ++b)
        f.buckets.push_back(bucketLine(f, b));
}

float perValue(const TransferIntegral::Segment& segment, float)
{
    return variationOf(segment);
}

/// Per share of the value, at most: at the segment's upper end.
float perShare(const TransferIntegral::Segment& segment, float end)
{
    return variationOf(segment) * end;
}

bool hasStepAtEnd(const TransferIntegral& f, const Range& r)
{
    return (f.opensWithStep && r.lo < f.range.lo) || (f.closesWithStep && r.hi > f.range.hi);
}

/// The largest variation(segment, its upper knot) of segments `a` to `b`, which `maxima` has but for steps at a
/// segment's lower end. All values are above the lower end of `a`: no matter whether there is a step.
template <class Variation>
float variationIn(const TransferIntegral& f, int a, int b, const std::vector<std::vector<float>>& maxima,
                  const Variation& variation)
{
    return std::max(variation(f.segments[a], f.knots[a + 1]), maximumOver(maxima, a + 1, b + 1));
}

/// The same of the segments that the values of `r` touch; infinite if there is a step among them.
template <class Variation>
float variationOver(const TransferIntegral& f, const Range& r, const std::vector<std::vector<float>>& maxima,
                    const Variation& variation)
{
    const float lo = std::max(r.lo, f.range.lo), hi = std::min(r.hi, f.range.hi);
    if (!(lo <= hi))
        return 0.0f;
    if (hasStepAtEnd(f, r))
        return std::numeric_limits<float>::infinity();
    return variationIn(f, f.segmentOf(lo), f.segmentOf(hi), maxima, variation);
}

/// The largest extinction from a value in segment `a` to one in segment `b`.
float extinctionFrom(const TransferIntegral& f, int a, float lo, int b, float hi)
{
    float ends = std::max(extinctionIn(f, a, lo), extinctionIn(f, b, hi));
    if (a < b)
        ends = std::max({ends, extinctionIn(f, a, f.knots[a + 1]), f.segments[b].density.w});
    return std::max(roundedUp(ends), maximumOver(f.maxExtinction, a + 1, b));
}

} // namespace

void tabulateQueries(TransferIntegral& integral, const std::vector<bool>& steps)
{
    tabulateMaxima(integral, steps);
    tabulateBuckets(integral);
    tabulateBucketLines(integral);
}

int TransferIntegral::bucketOf(float value) const
{
    if (scale == Scale::linear)
        return int((value - range.lo) * bucketsPerUnit);
    return int((std::bit_cast<std::uint32_t>(value) - std::bit_cast<std::uint32_t>(range.lo)) >> bucketShift);
}

int TransferIntegral::segmentOf(float value) const
{
    const std::size_t bucket = std::size_t(bucketOf(value));
    const auto first = knots.begin() + int(firstSegments[bucket]);
    const auto last = knots.begin() + int(firstSegments[bucket + 1]);
    return int(std::upper_bound(first + 1, last + 1, value) - knots.begin()) - 1;
}

float TransferIntegral::largestExtinction(const Range& r) const
{
    const float lo = std::max(r.lo, range.lo), hi = std::min(r.hi, range.hi);
    if (!(lo <= hi))
        return 0.0f;
    return extinctionFrom(*this, segmentOf(lo), lo, segmentOf(hi), hi);
}

float TransferIntegral::largestVariation(const Range& r) const
{
    return variationOver(*this, r, maxVariation, perValue);
}

float TransferIntegral::largestLogVariation(const Range& r) const
{
    if (scale != Scale::logarithmic)
        return std::numeric_limits<float>::infinity();
    return variationOver(*this, r, maxLogVariation, perShare);
}

TransferLimits limitsOver(const TransferIntegral& f, const Range& r)
{
    const float lo = std::max(r.lo, f.range.lo), hi = std::min(r.hi, f.range.hi);
    if (!(lo <= hi))
        return {};
    const int a = f.segmentOf(lo), b = f.segmentOf(hi);
    TransferLimits limits;
    limits.extinction = extinctionFrom(f, a, lo, b, hi);
    if (!(limits.extinction > 0.0f))
        return limits;
    limits.variation = limits.logVariation = std::numeric_limits<float>::infinity();
    if (hasStepAtEnd(f, r))
        return limits;
    limits.variation = variationIn(f, a, b, f.maxVariation, perValue);
    if (f.scale == Scale::logarithmic)
        limits.logVariation = variationIn(f, a, b, f.maxLogVariation, perShare);
    return limits;
}

} // namespace brickwall
