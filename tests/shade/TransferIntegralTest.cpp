// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/TransferIntegral.h"

#include "brickwall/core/shade/ColorMaps.h"
#include "brickwall/core/shade/TransferIntegralTables.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <random>

namespace brickwall {
namespace {

TransferFunction rainbow(Range range, Scale scale, std::vector<OpacityPoint> opacity,
                         TransferFunction::Kind kind = TransferFunction::Kind::opacity)
{
    TransferFunction tf;
    tf.range = range;
    tf.scale = scale;
    tf.colors = {{0.0f, {0.0f, 0.2f, 1.0f}}, {0.4f, {1.0f, 1.0f, 0.0f}}, {1.0f, {1.0f, 0.6f, 0.0f}}};
    tf.opacity = std::move(opacity);
    tf.kind = kind;
    return tf;
}

/// As users make them: a few points anywhere, two in five of them invisible.
TransferFunction windows(unsigned seed, Scale scale)
{
    std::mt19937 random(seed);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    std::vector<OpacityPoint> points;
    for (int i = 0; i < 9; ++i)
        points.push_back({unit(random), unit(random) < 0.4f ? 0.0f : 3.0f * unit(random)});
    std::sort(points.begin(), points.end(), [](auto& a, auto& b) { return a.t < b.t; });
    return rainbow(scale == Scale::linear ? Range{-3.0f, 5.0f} : Range{1e-6f, 1e3f}, scale, points,
                   TransferFunction::Kind::extinction);
}

TransferFunction likeXf(bool noisy)
{
    std::mt19937 random(3);
    std::uniform_real_distribution<float> unit(0.0f, 1.0f);
    TransferFunction tf = rainbow({-2.0f, 7.0f}, Scale::linear, {});
    tf.colors = colorMap("viridis");
    for (int i = 0; i < 128; ++i)
        tf.opacity.push_back({float(i) / 127.0f, noisy ? unit(random) : std::exp(-0.01f * float((i - 60) * (i - 60)))});
    return tf;
}

struct Named
{
    std::string name;
    TransferFunction tf;
};

std::vector<Named> functions()
{
    using Kind = TransferFunction::Kind;
    const Range decades{1e-3f, 1e3f};
    return {{"extinction ramp", rainbow({-3, 5}, Scale::linear, {{0, 0}, {1, 2}}, Kind::extinction)},
            {"opacity ramp", rainbow({-3, 5}, Scale::linear, {{0, 0}, {1, 0.5f}})},
            {"full opacity", rainbow({-3, 5}, Scale::linear, {{0, 0}, {0.5f, 1}, {0.7f, 1}, {1, 0}})},
            {"spike", rainbow({-3, 5}, Scale::linear, {{0.60310f, 0}, {0.60315f, 0.9f}, {0.60320f, 0}})},
            {"steps", rainbow({0, 1}, Scale::linear, {{0.2f, 0}, {0.2f, 0.3f}, {0.7f, 0.4f}, {0.7f, 0.01f}})},
            {"decades", rainbow(decades, Scale::logarithmic, {{0, 0.3f}, {0.3f, 0}, {0.5f, 0.1f}, {1, 0.9f}})},
            {"spikes in decades", rainbow(decades, Scale::logarithmic, {{0.3f, 0}, {0.30005f, 0.9f}, {0.3001f, 0}})},
            {"smooth .xf", likeXf(false)},
            {"noisy .xf", likeXf(true)},
            {"windows", windows(7, Scale::linear)},
            {"windows in decades", windows(8, Scale::logarithmic)},
            {"tiny densities", rainbow({0, 1e-24f}, Scale::linear, {{0, 0}, {1, 0.5f}})},
            {"huge densities", rainbow({1e20f, 1e24f}, Scale::logarithmic, {{0, 0}, {1, 0.5f}})}};
}

/// Values of all segments, more where there are more of them, and of the range as a whole.
std::vector<float> valuesOf(const TransferIntegral& f)
{
    std::vector<float> values;
    for (std::size_t i = 0; i < f.segments.size(); ++i)
        for (const double x : {0.0, 0.1, 0.3, 0.5, 0.77, 0.95})
            values.push_back(float(std::lerp(double(f.knots[i]), double(f.knots[i + 1]), x)));
    for (int i = 0; i < 1000; ++i)
        values.push_back(float(std::lerp(double(f.range.lo), double(f.range.hi), i / 1000.0)));
    std::sort(values.begin(), values.end());
    return values;
}

vec4d densityAt(const TransferIntegral& f, float v)
{
    const int i = f.segmentOf(v);
    return vec4d(f.segments[i].density) + vec4d(f.segments[i].slope) * (double(v) - f.knots[i]);
}

vec4d integralAt(const TransferIntegral& f, float v)
{
    const TransferIntegral::Segment& s = f.segments[f.segmentOf(v)];
    const double x = double(v) - f.knots[f.segmentOf(v)];
    return vec4d(s.integral) + vec4d(s.rest) + vec4d(s.density) * x + vec4d(s.slope) * (0.5 * x * x);
}

/// What the rounding of values and knots does to a function as steep as this or its neighbours.
double blur(const TransferIntegral& f, float v)
{
    const int i = f.segmentOf(v), last = int(f.segments.size()) - 1;
    double steepest = 0.0;
    for (const int j : {std::max(i - 1, 0), i, std::min(i + 1, last)})
        steepest = std::max(steepest, double(std::abs(f.segments[j].slope.w)));
    return steepest * std::abs(v) * 1.5e-7;
}

TEST(TransferIntegral, MeetsTheExactFunction)
{
    for (const auto& [name, tf] : functions()) {
        const TransferIntegral f = integrate(tf);
        const double largest = f.largestExtinction(tf.range);
        for (const float v : valuesOf(f)) {
            const double sigma = extinctionAt(tf, v);
            const vec4d exact(colorAt(tf, v) * sigma, sigma), found = densityAt(f, v);
            const double allowed = 1e-5 * sigma + 1e-9 * largest + 2e-7 * f.segments[f.segmentOf(v)].density.w;
            const bool atStep = f.knots[f.segmentOf(v)] == v || std::nextafter(v, tf.range.hi + 1.0f) >= tf.range.hi;
            if (atStep && name == "steps")
                continue;
            for (int c = 0; c < 4; ++c)
                ASSERT_NEAR(found[c], exact[c], allowed + 2.0 * blur(f, v)) << name << " at " << v;
        }
    }
}

/// Where a value is in its bucket, as lanes find it.
float placeInBucket(const TransferIntegral& f, float v)
{
    const int bucket = f.bucketOf(v);
    if (f.scale == Scale::linear)
        return (v - f.range.lo) * f.bucketsPerUnit - float(bucket);
    const auto bits = std::bit_cast<std::uint32_t>(v) - std::bit_cast<std::uint32_t>(f.range.lo);
    return float(bits - (std::uint32_t(bucket) << f.bucketShift)) / float(1u << f.bucketShift);
}

TEST(TransferIntegral, LinesOfBucketsMeetTheSegmentsOrSayThatTheyDoNot)
{
    for (const auto& [name, tf] : functions()) {
        const TransferIntegral f = integrate(tf);
        ASSERT_EQ(int(f.buckets.size()), f.bucketCount()) << name;
        const double largest = f.largestExtinction(tf.range);
        std::size_t lines = 0;
        const std::vector<float> values = valuesOf(f);
        for (const float v : values) {
            const TransferIntegral::Bucket& bucket = f.buckets[f.bucketOf(v)];
            if (std::isnan(bucket.density.w))
                continue;
            ++lines;
            const vec4d found = vec4d(bucket.density) + vec4d(bucket.rise) * double(placeInBucket(f, v));
            const vec4d exact = densityAt(f, v);
            for (int c = 0; c < 4; ++c)
                ASSERT_NEAR(found[c], exact[c],
                            1.1e-4 * exact.w + 1.1e-6 * largest + 2.0 * blur(f, v) + 3e-4 * std::abs(bucket.rise.w))
                    << name << " at " << v;
        }
        if (name == "extinction ramp") {
            EXPECT_GT(lines, values.size() / 2);
        }
    }
}

TEST(TransferIntegral, OrdinaryFunctionsAreSmall)
{
    for (const auto& [name, tf] : functions())
        if (name != "noisy .xf") {
            const TransferIntegral f = integrate(tf);
            EXPECT_LT(f.segments.size() * sizeof f.segments[0], 150'000u) << name;
            RecordProperty(name, int(f.segments.size()));
            EXPECT_GE(f.bucketCount(), 500) << name;
        }
}

TEST(TransferIntegral, KnotsAscendAndFindTheirSegment)
{
    for (const auto& [name, tf] : functions()) {
        const TransferIntegral f = integrate(tf);
        ASSERT_EQ(f.knots.size(), f.segments.size() + 1);
        EXPECT_EQ(f.knots.front(), tf.range.lo);
        EXPECT_EQ(f.knots.back(), tf.range.hi);
        for (const float v : valuesOf(f)) {
            const int i = f.segmentOf(v);
            ASSERT_LE(f.knots[i], v) << name;
            ASSERT_TRUE(v < f.knots[i + 1] || v == tf.range.hi) << name;
        }
        EXPECT_EQ(f.segmentOf(tf.range.hi), int(f.segments.size()) - 1);
    }
}

TEST(TransferIntegral, IsTheIntegralOfTheFunction)
{
    for (const auto& [name, tf] : functions()) {
        const TransferIntegral f = integrate(tf);
        const std::vector<float> values = valuesOf(f);
        vec4d sum(0.0);
        for (std::size_t i = 0; i < f.segments.size(); ++i) {
            // Boole's rule over what is smooth; the ends from inside, for there may be steps.
            const double a = f.knots[i], w = double(f.knots[i + 1]) - a;
            const auto at = [&, &tf = tf](double x) { // bindings are not captured by clang 14
                const double v = a + w * std::clamp(x, 1e-6, 1.0 - 1e-6), sigma = extinctionAt(tf, v);
                return vec4d(colorAt(tf, v) * sigma, sigma);
            };
            sum += (w / 90.0) * (7.0 * (at(0) + at(1)) + 32.0 * (at(0.25) + at(0.75)) + 12.0 * at(0.5));
        }
        const vec4d total = integralAt(f, tf.range.hi);
        // Knots are floats: a spike of 1e-4 of the range has its edges within a thousandth of its width.
        const double allowed = name.find("spike") != std::string::npos ? 2e-3 : 3e-6;
        for (int c = 0; c < 4; ++c)
            EXPECT_NEAR(total[c], sum[c], allowed * sum.w) << name;
        for (std::size_t i = 1; i < values.size(); ++i) {
            const vec4d a = integralAt(f, values[i - 1]), b = integralAt(f, values[i]);
            ASSERT_GE(b.w - a.w, -1e-12 * total.w) << name << " at " << values[i];
        }
    }
}

TEST(TransferIntegral, IsContinuous)
{
    for (const auto& [name, tf] : functions()) {
        const TransferIntegral f = integrate(tf);
        for (std::size_t i = 0; i + 1 < f.segments.size(); ++i) {
            const TransferIntegral::Segment &s = f.segments[i], &next = f.segments[i + 1];
            const double x = double(f.knots[i + 1]) - f.knots[i];
            const double end = double(s.integral.w) + s.rest.w + s.density.w * x + s.slope.w * (0.5 * x * x);
            const double own = x * std::max(s.density.w, next.density.w);
            ASSERT_NEAR(end, double(next.integral.w) + next.rest.w, 1e-6 * own + 1e-14 * end)
                << name << " segment " << i;
        }
    }
}

TEST(TransferIntegral, ASpikeOfAnyWidthHasItsArea)
{
    for (const float half : {0.1f, 1e-3f, 1e-4f, 1e-5f}) {
        TransferFunction tf = rainbow({0, 1}, Scale::linear, {{0.25f - half, 0}, {0.25f, 8}, {0.25f + half, 0}},
                                      TransferFunction::Kind::extinction);
        const TransferIntegral f = integrate(tf);
        const double area = 8.0 * half;
        EXPECT_NEAR(integralAt(f, 1.0f).w, area, area * (1e-5 + 3e-8 / half));
        EXPECT_FLOAT_EQ(f.largestExtinction({0, 1}), 8.0f);
        EXPECT_EQ(f.largestExtinction({0.25f + 2 * half, 1}), 0.0f);
        EXPECT_FLOAT_EQ(f.visible.lo, 0.25f - half);
        EXPECT_FLOAT_EQ(f.visible.hi, 0.25f + half);
    }
}

TEST(TransferIntegral, KeepsSteps)
{
    TransferFunction tf = rainbow({0, 2}, Scale::linear, {{0.25f, 0}, {0.25f, 3}, {0.75f, 3}, {0.75f, 1}},
                                  TransferFunction::Kind::extinction);
    tf.colors = {{0, {0.5f, 0.5f, 0.5f}}};
    const TransferIntegral f = integrate(tf);
    EXPECT_EQ(f.segments.size(), 3u);
    EXPECT_EQ(densityAt(f, std::nextafter(0.5f, 0.0f)).w, 0.0);
    EXPECT_EQ(densityAt(f, 0.5f).w, 3.0);
    EXPECT_EQ(densityAt(f, std::nextafter(1.5f, 0.0f)).w, 3.0);
    EXPECT_EQ(densityAt(f, 1.5f).w, 1.0);
    EXPECT_EQ(integralAt(f, 2.0f), vec4d(1.75, 1.75, 1.75, 3.5));
    EXPECT_EQ(f.visible, (Range{0.5f, 2.0f}));

    const float infinity = std::numeric_limits<float>::infinity();
    EXPECT_EQ(f.largestVariation({0, 2}), infinity);
    EXPECT_EQ(f.largestVariation({0, 0.5f}), infinity);
    EXPECT_EQ(f.largestVariation({0.5f, 1.4f}), 0.0f);
    EXPECT_EQ(f.largestVariation({1.6f, 2.0f}), 0.0f);
    EXPECT_EQ(f.largestVariation({1.6f, 2.1f}), infinity); // the range ends visibly
    EXPECT_EQ(f.largestVariation({2.5f, 3.0f}), 0.0f);
    EXPECT_EQ(f.largestVariation({-1.0f, 0.1f}), 0.0f); // and begins invisibly
}

TEST(TransferIntegral, BoundsHoldOverAnyRange)
{
    std::mt19937 random(5);
    for (const auto& [name, tf] : functions()) {
        const TransferIntegral f = integrate(tf);
        const std::vector<float> values = valuesOf(f);
        std::uniform_int_distribution<int> any(0, int(values.size()) - 1), few(0, 40);
        for (int trial = 0; trial < 300; ++trial) {
            const int a = any(random),
                      b = std::min(a + (trial % 2 ? few(random) : any(random)), int(values.size()) - 1);
            const Range r{values[a], values[b]};
            const double bound = f.largestExtinction(r), variation = f.largestVariation(r);
            const double logVariation = f.largestLogVariation(r);
            double largest = 0.0;
            for (int i = a; i <= b; ++i) {
                largest = std::max(largest, densityAt(f, values[i]).w);
                const double dv = i > a ? double(values[i]) - values[i - 1] : 0.0;
                if (dv <= 1e-3 * (double(f.knots[1]) - f.knots[0]))
                    continue;
                const vec4d d = densityAt(f, values[i]) - densityAt(f, values[i - 1]);
                const double noise = 4e-7 * bound;
                const double ratio = f.scale == Scale::logarithmic ? std::log(double(values[i]) / values[i - 1]) : 1.0;
                for (int c = 0; c < 3; ++c) {
                    ASSERT_LE(std::abs(d[c]), variation * dv + noise) << name;
                    ASSERT_LE(std::abs(d.w - d[c]), variation * dv + noise) << name;
                    ASSERT_LE(std::abs(d[c]), logVariation * ratio + noise) << name;
                    ASSERT_LE(std::abs(d.w - d[c]), logVariation * ratio + noise) << name;
                }
            }
            ASSERT_LE(largest, bound) << name;
            ASSERT_LE(bound, 1.001 * largest + 0.1 * f.largestExtinction(tf.range)) << name;
        }
    }
}

TEST(TransferIntegral, OneValueHasItsOwnExtinction)
{
    for (const auto& [name, tf] : functions()) {
        const TransferIntegral f = integrate(tf);
        for (const float v : valuesOf(f)) {
            const double own = std::max(0.0, densityAt(f, v).w);
            ASSERT_NEAR(f.largestExtinction({v, v}), own, 1e-6 * f.segments[f.segmentOf(v)].density.w + 1e-6 * own)
                << name << " at " << v;
        }
    }
}

TEST(TransferIntegral, TheLimitsOfARangeAreWhatTheQueriesSayOneByOne)
{
    for (const Scale scale : {Scale::linear, Scale::logarithmic})
        for (unsigned seed = 1; seed <= 6; ++seed) {
            const TransferIntegral integral = integrate(windows(seed, scale));
            std::mt19937 random(seed);
            const Range all = integral.range;
            std::uniform_real_distribution<float> unit(-0.2f, 1.2f);
            for (int i = 0; i < 500; ++i) {
                const auto value = [&](float u) {
                    return scale == Scale::linear ? all.lo + u * all.span() : all.lo * std::pow(all.hi / all.lo, u);
                };
                const float a = value(unit(random)), b = i % 3 == 0 ? a * 1.001f : value(unit(random));
                const Range range{std::min(a, b), std::max(a, b)};
                const TransferLimits limits = limitsOver(integral, range);
                ASSERT_EQ(limits.extinction, integral.largestExtinction(range));
                if (limits.extinction > 0.0f) {
                    ASSERT_EQ(limits.variation, integral.largestVariation(range));
                    ASSERT_EQ(limits.logVariation, integral.largestLogVariation(range));
                }
            }
        }
}

TEST(TransferIntegral, TheLargestExtinctionOfARampIsAtItsEnd)
{
    const TransferIntegral f =
        integrate(rainbow({-1, 1}, Scale::linear, {{0, 0.25f}, {1, 2.25f}}, TransferFunction::Kind::extinction));
    EXPECT_NEAR(f.largestExtinction({-0.9f, 0.3f}), 1.55f, 2e-6f);  // rounded upwards
    EXPECT_NEAR(f.largestExtinction({-9.0f, -1.0f}), 0.25f, 2e-6f); // ends belong to their range
    EXPECT_NEAR(f.largestExtinction({1.0f, 9.0f}), 2.25f, 2e-6f);
    EXPECT_EQ(f.largestExtinction({-9.0f, -1.0001f}), 0.0f);
    EXPECT_EQ(f.largestExtinction({1.0001f, 9.0f}), 0.0f);
}

/// Regions that a narrow window does not touch have to be skipped, or the skipping is worth nothing.
TEST(TransferIntegral, GapsBetweenWindowsAreKnownToBeEmpty)
{
    int empty = 0;
    for (unsigned seed = 0; seed < 20; ++seed) {
        const TransferFunction tf = windows(seed, seed % 2 ? Scale::linear : Scale::logarithmic);
        const TransferIntegral f = integrate(tf);
        for (std::size_t i = 1; i < tf.opacity.size(); ++i) {
            if (tf.opacity[i - 1].value > 0.0f || tf.opacity[i].value > 0.0f)
                continue;
            const auto valueAt = [&](double t) {
                const double lo = tf.range.lo, hi = tf.range.hi;
                return float(tf.scale == Scale::linear ? std::lerp(lo, hi, t) : lo * std::pow(hi / lo, t));
            };
            const Range gap{valueAt(std::lerp(double(tf.opacity[i - 1].t), double(tf.opacity[i].t), 0.01)),
                            valueAt(std::lerp(double(tf.opacity[i - 1].t), double(tf.opacity[i].t), 0.99))};
            EXPECT_EQ(f.largestExtinction(gap), 0.0f) << seed;
            ++empty;
        }
    }
    EXPECT_GT(empty, 10);
}

TEST(TransferIntegral, NothingIsVisibleOutsideTheRange)
{
    for (const auto& [name, tf] : functions()) {
        const TransferIntegral f = integrate(tf);
        const float below = std::nextafter(tf.range.lo, -1e30f), above = std::nextafter(tf.range.hi, 1e30f);
        EXPECT_EQ(f.largestExtinction({-1e30f, below}), 0.0f) << name;
        EXPECT_EQ(f.largestExtinction({above, 1e30f}), 0.0f) << name;
        EXPECT_EQ(f.largestExtinction({}), 0.0f) << name;
    }
    const TransferIntegral none = integrate(rainbow({0, 1}, Scale::linear, {{0, 0}}));
    EXPECT_TRUE(none.visible.empty());
    EXPECT_EQ(none.segments.size(), 2u);
}

} // namespace
} // namespace brickwall
