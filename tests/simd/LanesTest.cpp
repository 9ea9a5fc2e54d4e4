// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The lanes of every instruction set that this machine has, against one float at a time.
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "brickwall/tests/simd/LanesTest.cpp"
#include "brickwall/core/simd/ForEachTarget.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/simd/Lanes.h"
#include "brickwall/core/simd/Target.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

struct Lane
{
    alignas(64) float v[16];

    Lane() = default;
    explicit Lane(FloatN a) { store(a, v); }
};

Lane ramp(float first, float step)
{
    Lane lane;
    for (int i = 0; i < 16; ++i)
        lane.v[i] = first + step * static_cast<float>(i);
    return lane;
}

void testArithmetic()
{
    const Lane a = ramp(-3.75f, 0.5f), b = ramp(2.0f, -0.375f), c = ramp(0.5f, 1.0f);
    const FloatN x = load(a.v), y = load(b.v), z = load(c.v);
    const Lane sum(x + y), product(x * y), mad(fma(x, y, z)), nmad(fnma(x, y, z)), mixed(lerp(x, y, z)), low(min(x, y)),
        high(max(x, y)), below(floor(x)), size(abs(x)), root(sqrt(z)), minus(-x);
    for (int i = 0; i < laneCount; ++i) {
        EXPECT_EQ(sum.v[i], a.v[i] + b.v[i]);
        EXPECT_EQ(product.v[i], a.v[i] * b.v[i]);
        EXPECT_EQ(mad.v[i], a.v[i] * b.v[i] + c.v[i]);
        EXPECT_EQ(nmad.v[i], c.v[i] - a.v[i] * b.v[i]);
        EXPECT_EQ(mixed.v[i], a.v[i] + c.v[i] * (b.v[i] - a.v[i]));
        EXPECT_EQ(low.v[i], std::min(a.v[i], b.v[i]));
        EXPECT_EQ(high.v[i], std::max(a.v[i], b.v[i]));
        EXPECT_EQ(below.v[i], std::floor(a.v[i]));
        EXPECT_EQ(size.v[i], std::abs(a.v[i]));
        EXPECT_FLOAT_EQ(root.v[i], std::sqrt(c.v[i]));
        EXPECT_EQ(minus.v[i], -a.v[i]);
    }
}

void testFunctions()
{
    for (float first = -110.0f; first < 20.0f; first += 7.3f) {
        const Lane a = ramp(first, 0.31f), e(exp(load(a.v)));
        for (int i = 0; i < laneCount; ++i)
            EXPECT_NEAR(e.v[i], std::exp(double(a.v[i])), 4e-7 * std::exp(double(a.v[i])) + 1e-38) << a.v[i];
    }
    for (float first = 1e-30f; first < 1e30f; first *= 77.0f) {
        const Lane a = ramp(first, first), l(log(load(a.v)));
        for (int i = 0; i < laneCount; ++i)
            EXPECT_NEAR(l.v[i], std::log(double(a.v[i])), 4e-7 * std::abs(std::log(double(a.v[i]))) + 1e-7) << a.v[i];
    }
    for (float first = 2e-38f; first < 1e37f; first *= 7.7f) {
        const Lane a = ramp(first, 0.9f * first), root(cubeRoot(load(a.v)));
        for (int i = 0; i < laneCount; ++i)
            EXPECT_NEAR(root.v[i], std::cbrt(a.v[i]), 1e-3f * std::cbrt(a.v[i])) << a.v[i];
    }
}

void testMasks()
{
    const Lane a = ramp(0.0f, 1.0f);
    for (int n = 0; n <= laneCount; ++n) {
        const MaskN m = firstLanes(n);
        EXPECT_EQ(count(m), n);
        EXPECT_EQ(any(m), n > 0);
        EXPECT_EQ(none(m), n == 0);
        EXPECT_EQ(all(m), n == laneCount);
        EXPECT_EQ(count(!m), laneCount - n);
        EXPECT_EQ(count(andNot(firstLanes(laneCount), m)), laneCount - n);
        EXPECT_EQ(count(load(a.v) < FloatN(static_cast<float>(n))), n);
        const Lane chosen(select(m, load(a.v), -1.0f)), kept(valueOrZero(m, load(a.v)));
        for (int i = 0; i < laneCount; ++i) {
            EXPECT_EQ(chosen.v[i], i < n ? a.v[i] : -1.0f);
            EXPECT_EQ(kept.v[i], i < n ? a.v[i] : 0.0f);
        }
    }
    EXPECT_EQ(count(firstLanes(100)), laneCount);
    const FloatN nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(none((nan < FloatN(0.0f)) | (nan >= FloatN(0.0f))));
}

void testGather()
{
    std::vector<float> table(2000);
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = static_cast<float>(i * i % 101);
    const Lane places = ramp(3.9f, 61.0f);
    const IntN index = toInt(load(places.v));
    const Lane found(gather(table.data(), index)),
        other(gather(table.data() + 40, index * IntN(2) - IntN(7) + IntN(1)));
    const auto at = [&](int lane, int more) {
        return table[static_cast<std::size_t>(places.v[lane]) + std::size_t(more)];
    };
    const QuadN quad = gatherQuads(QuadAt{table.data()}, index);
    const QuadN pairs = gatherQuads(PairsAt{table.data(), table.data() + 17}, index);
    const Lane a(quad.a), b(quad.b), c(quad.c), d(quad.d), e(pairs.a), f(pairs.b), g(pairs.c), h(pairs.d);
    for (int i = 0; i < laneCount; ++i) {
        EXPECT_EQ(a.v[i], at(i, 0));
        EXPECT_EQ(b.v[i], at(i, 1));
        EXPECT_EQ(c.v[i], at(i, 2));
        EXPECT_EQ(d.v[i], at(i, 3));
        EXPECT_EQ(e.v[i], at(i, 0));
        EXPECT_EQ(f.v[i], at(i, 1));
        EXPECT_EQ(g.v[i], at(i, 17));
        EXPECT_EQ(h.v[i], at(i, 18));
        EXPECT_EQ(found.v[i], table[static_cast<std::size_t>(places.v[i])]);
        EXPECT_EQ(other.v[i], table[2 * static_cast<std::size_t>(places.v[i]) + 34]);
    }
}

void testBits()
{
    std::vector<float> table(1 << 12);
    for (std::size_t i = 0; i < table.size(); ++i)
        table[i] = static_cast<float>(i);
    for (float first = 1e-30f; first < 1e30f; first *= 33.0f)
        for (const int shift : {19, 22}) {
            const Lane a = ramp(first, 0.3f * first);
            // Indices into a table are how lanes of integers show.
            const Lane bucket(gather(table.data(), shiftRight(bitsOf(load(a.v)), shift)));
            const Lane below(gather(table.data() + 1, shiftRight(IntN(0) - bitsOf(FloatN(1e-42f)), shift)));
            for (int i = 0; i < laneCount; ++i) {
                EXPECT_EQ(bucket.v[i], static_cast<float>(std::bit_cast<std::uint32_t>(a.v[i]) >> shift)) << a.v[i];
                EXPECT_EQ(below.v[i], 0.0f); // -1 stays -1
            }
        }
}

/// How many lanes there are, so that the caller knows which set it was.
int testLanes()
{
    testArithmetic();
    testFunctions();
    testMasks();
    testGather();
    testBits();
    return laneCount;
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace brickwall {

HWY_EXPORT(testLanes);

TEST(Lanes, ComputeWhatOneFloatAtATimeDoes)
{
    for (const std::string& target : laneTargets()) {
        SCOPED_TRACE(target);
        chooseLaneTarget(target);
        EXPECT_EQ(laneTarget(), target);
        EXPECT_EQ(HWY_DYNAMIC_DISPATCH(testLanes)(), laneCount());
    }
    chooseLaneTarget("");
    EXPECT_EQ(laneTarget(), laneTargets().front());
    EXPECT_THROW(chooseLaneTarget("abacus"), Error);
}

TEST(Lanes, AreAPowerOfTwoUpToSixteen)
{
    const int n = laneCount();
    EXPECT_TRUE(n == 1 || n == 4 || n == 8 || n == 16) << n;
    EXPECT_FALSE(laneTarget().empty());
#ifdef HWY_COMPILE_ONLY_SCALAR
    EXPECT_EQ(n, 1);
#endif
}

} // namespace brickwall
#endif
