// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Lanes: `laneCount` floats, ints or booleans that one instruction handles, with operators, so that a kernel reads
/// like the code for one ray. Thin wrappers over Highway (github.com/google/highway, 1.0.3), the only ones that know
/// its names.
///
/// Compiled once per instruction set, each in its own namespace brickwall::HWY_NAMESPACE; hence no `#pragma once` but a
/// guard that flips with the set. To be included by sources that start with ForEachTarget.h.
#if defined(BRICKWALL_CORE_SIMD_LANES_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_SIMD_LANES_H
#undef BRICKWALL_CORE_SIMD_LANES_H
#else
#define BRICKWALL_CORE_SIMD_LANES_H
#endif

#include <hwy/contrib/math/math-inl.h>
#include <hwy/highway.h>

#include <cstdint>

/// For lambdas that work on lanes: compiled for the instruction set at hand, and never called through memory.
#ifndef LANES_LAMBDA
#define LANES_LAMBDA HWY_ATTR __attribute__((always_inline))
#endif

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;
using FloatTag = hn::ScalableTag<float>;
using IntTag = hn::ScalableTag<std::int32_t>;

/// At most 16; the widths of all sets that are compiled are known at compile time.
inline constexpr int laneCount = static_cast<int>(hn::MaxLanes(FloatTag()));
static_assert(laneCount >= 1 && laneCount <= 16);

struct MaskN
{
    hn::Mask<FloatTag> m;
};

HWY_INLINE MaskN operator&(MaskN a, MaskN b)
{
    return {hn::And(a.m, b.m)};
}
HWY_INLINE MaskN operator|(MaskN a, MaskN b)
{
    return {hn::Or(a.m, b.m)};
}
HWY_INLINE MaskN operator!(MaskN a)
{
    return {hn::Not(a.m)};
}
HWY_INLINE MaskN andNot(MaskN a, MaskN b)
{
    return {hn::AndNot(b.m, a.m)};
} ///< a and not b
HWY_INLINE bool none(MaskN a)
{
    return hn::AllFalse(FloatTag(), a.m);
}
HWY_INLINE bool any(MaskN a)
{
    return !none(a);
}
HWY_INLINE bool all(MaskN a)
{
    return hn::AllTrue(FloatTag(), a.m);
}
HWY_INLINE int count(MaskN a)
{
    return static_cast<int>(hn::CountTrue(FloatTag(), a.m));
}
/// The first n lanes; all for n >= laneCount.
HWY_INLINE MaskN firstLanes(int n)
{
    return {hn::FirstN(FloatTag(), static_cast<std::size_t>(n))};
}

struct FloatN
{
    hn::Vec<FloatTag> v;

    FloatN() = default;
    HWY_INLINE FloatN(hn::Vec<FloatTag> raw) : v(raw) {}
    HWY_INLINE FloatN(float s) : v(hn::Set(FloatTag(), s)) {}

    HWY_INLINE FloatN& operator+=(FloatN b) { return *this = hn::Add(v, b.v); }
    HWY_INLINE FloatN& operator*=(FloatN b) { return *this = hn::Mul(v, b.v); }
};

HWY_INLINE FloatN operator+(FloatN a, FloatN b)
{
    return hn::Add(a.v, b.v);
}
HWY_INLINE FloatN operator-(FloatN a, FloatN b)
{
    return hn::Sub(a.v, b.v);
}
HWY_INLINE FloatN operator*(FloatN a, FloatN b)
{
    return hn::Mul(a.v, b.v);
}
HWY_INLINE FloatN operator/(FloatN a, FloatN b)
{
    return hn::Div(a.v, b.v);
}
HWY_INLINE FloatN operator-(FloatN a)
{
    return hn::Neg(a.v);
}
HWY_INLINE MaskN operator<(FloatN a, FloatN b)
{
    return {hn::Lt(a.v, b.v)};
}
HWY_INLINE MaskN operator<=(FloatN a, FloatN b)
{
    return {hn::Le(a.v, b.v)};
}
HWY_INLINE MaskN operator>(FloatN a, FloatN b)
{
    return {hn::Gt(a.v, b.v)};
}
HWY_INLINE MaskN operator>=(FloatN a, FloatN b)
{
    return {hn::Ge(a.v, b.v)};
}
HWY_INLINE MaskN operator==(FloatN a, FloatN b)
{
    return {hn::Eq(a.v, b.v)};
}

HWY_INLINE FloatN fma(FloatN a, FloatN b, FloatN c)
{
    return hn::MulAdd(a.v, b.v, c.v);
} ///< a b + c
HWY_INLINE FloatN fnma(FloatN a, FloatN b, FloatN c)
{
    return hn::NegMulAdd(a.v, b.v, c.v);
} ///< c - a b
HWY_INLINE FloatN lerp(FloatN a, FloatN b, FloatN f)
{
    return fma(f, b - a, a);
}
/// Where a lane is NaN, the result is either of the two.
HWY_INLINE FloatN min(FloatN a, FloatN b)
{
    return hn::Min(a.v, b.v);
}
HWY_INLINE FloatN max(FloatN a, FloatN b)
{
    return hn::Max(a.v, b.v);
}
HWY_INLINE FloatN clamp(FloatN a, FloatN lo, FloatN hi)
{
    return min(max(a, lo), hi);
}
HWY_INLINE FloatN abs(FloatN a)
{
    return hn::Abs(a.v);
}
HWY_INLINE FloatN floor(FloatN a)
{
    return hn::Floor(a.v);
}
HWY_INLINE FloatN ceil(FloatN a)
{
    return hn::Ceil(a.v);
}
HWY_INLINE FloatN sqrt(FloatN a)
{
    return hn::Sqrt(a.v);
}
HWY_INLINE FloatN exp(FloatN a)
{
    return hn::Exp(FloatTag(), a.v);
} ///< 0 below about -104
HWY_INLINE FloatN log(FloatN a)
{
    return hn::Log(FloatTag(), a.v);
} ///< for a > 0
/// Within 1e-3 of it, for a > 0 that is not denormal. (The exponent divided by three, as an integer, and one step of
/// Newton's method.)
HWY_INLINE FloatN cubeRoot(FloatN a)
{
    const hn::Vec<IntTag> bits = hn::BitCast(IntTag(), a.v);
    const auto third = hn::ConvertTo(IntTag(), hn::Mul(hn::ConvertTo(FloatTag(), bits), hn::Set(FloatTag(), 1.0f / 3)));
    FloatN x = hn::BitCast(FloatTag(), hn::Add(third, hn::Set(IntTag(), 0x2a5137a0)));
    for (int i = 0; i < 2; ++i)
        x = (x + x + a / (x * x)) * FloatN(1.0f / 3.0f);
    return x;
}
HWY_INLINE FloatN select(MaskN m, FloatN yes, FloatN no)
{
    return hn::IfThenElse(m.m, yes.v, no.v);
}
HWY_INLINE FloatN valueOrZero(MaskN m, FloatN yes)
{
    return hn::IfThenElseZero(m.m, yes.v);
}

/// Of all lanes, in an order of its own.
HWY_INLINE float sum(FloatN a)
{
    return hn::GetLane(hn::SumOfLanes(FloatTag(), a.v));
}

/// Aligned to the size of the lanes.
HWY_INLINE FloatN load(const float* p)
{
    return hn::Load(FloatTag(), p);
}
HWY_INLINE void store(FloatN a, float* p)
{
    hn::Store(a.v, FloatTag(), p);
}

struct IntN
{
    hn::Vec<IntTag> v;

    IntN() = default;
    HWY_INLINE IntN(hn::Vec<IntTag> raw) : v(raw) {}
    HWY_INLINE IntN(std::int32_t s) : v(hn::Set(IntTag(), s)) {}
};

HWY_INLINE IntN operator+(IntN a, IntN b)
{
    return hn::Add(a.v, b.v);
}
HWY_INLINE IntN operator-(IntN a, IntN b)
{
    return hn::Sub(a.v, b.v);
}
HWY_INLINE IntN operator*(IntN a, IntN b)
{
    return hn::Mul(a.v, b.v);
}
HWY_INLINE MaskN operator==(IntN a, IntN b)
{
    return {hn::RebindMask(FloatTag(), hn::Eq(a.v, b.v))};
}

/// Rounds towards zero.
HWY_INLINE IntN toInt(FloatN a)
{
    return hn::ConvertTo(IntTag(), a.v);
}
HWY_INLINE FloatN toFloat(IntN a)
{
    return hn::ConvertTo(FloatTag(), a.v);
}
/// The bits of a float as an integer: positive floats and their bits are in the same order.
HWY_INLINE IntN bitsOf(FloatN a)
{
    return hn::BitCast(IntTag(), a.v);
}
/// By the same number of bits in all lanes; the sign is kept.
HWY_INLINE IntN shiftRight(IntN a, int bits)
{
    return hn::ShiftRightSame(a.v, bits);
}

HWY_INLINE IntN shiftLeft(IntN a, int bits)
{
    return hn::ShiftLeftSame(a.v, bits);
}

/// base[i] per lane; the base has 64 bits, the indices 32.
HWY_INLINE FloatN gather(const float* base, IntN i)
{
    return hn::GatherIndex(FloatTag(), base, i.v);
}

/// Four floats per lane.
struct QuadN
{
    FloatN a, b, c, d;
};

/// Where a lane's four floats are: in one piece, or in two pairs. Much faster than four gathers, which x86 breaks up
/// into single loads anyway.
struct QuadAt
{
    const float* base;
    HWY_INLINE const float* first(std::int32_t i) const { return base + i; }
    HWY_INLINE const float* second(std::int32_t i) const { return base + i + 2; }
};
struct PairsAt
{
    const float* lower;
    const float* upper;
    HWY_INLINE const float* first(std::int32_t i) const { return lower + i; }
    HWY_INLINE const float* second(std::int32_t i) const { return upper + i; }
};

#if HWY_TARGET == HWY_SCALAR

template <class At>
HWY_INLINE QuadN gatherQuads(const At& at, IntN index)
{
    const std::int32_t i = hn::GetLane(index.v);
    return {at.first(i)[0], at.first(i)[1], at.second(i)[0], at.second(i)[1]};
}

#else

HWY_INLINE hn::Vec<hn::Full128<float>> loadQuad(const QuadAt& at, std::int32_t i)
{
    return hn::LoadU(hn::Full128<float>(), at.base + i);
}

HWY_INLINE hn::Vec<hn::Full128<float>> loadQuad(const PairsAt& at, std::int32_t i)
{
    const hn::Full64<float> pair;
    return hn::Combine(hn::Full128<float>(), hn::LoadU(pair, at.upper + i), hn::LoadU(pair, at.lower + i));
}

/// The quads of lanes j, j + 4, j + 8 and j + 12, as far as there are such.
template <class At>
HWY_INLINE hn::Vec<FloatTag> everyFourthQuad(const At& at, const std::int32_t* i)
{
#if HWY_CAP_GE512
    const hn::Full256<float> half;
    return hn::Combine(FloatTag(), hn::Combine(half, loadQuad(at, i[12]), loadQuad(at, i[8])),
                       hn::Combine(half, loadQuad(at, i[4]), loadQuad(at, i[0])));
#elif HWY_CAP_GE256
    return hn::Combine(FloatTag(), loadQuad(at, i[4]), loadQuad(at, i[0]));
#else
    return loadQuad(at, i[0]);
#endif
}

template <class At>
HWY_INLINE QuadN gatherQuads(const At& at, IntN index)
{
    const FloatTag f;
    const hn::Repartition<double, FloatTag> pairs;
    alignas(64) std::int32_t i[laneCount];
    hn::Store(index.v, IntTag(), i);
    const auto r0 = everyFourthQuad(at, i), r1 = everyFourthQuad(at, i + 1);
    const auto r2 = everyFourthQuad(at, i + 2), r3 = everyFourthQuad(at, i + 3);
    const auto ab01 = hn::BitCast(pairs, hn::InterleaveLower(f, r0, r1));
    const auto ab23 = hn::BitCast(pairs, hn::InterleaveLower(f, r2, r3));
    const auto cd01 = hn::BitCast(pairs, hn::InterleaveUpper(f, r0, r1));
    const auto cd23 = hn::BitCast(pairs, hn::InterleaveUpper(f, r2, r3));
    return {
        hn::BitCast(f, hn::InterleaveLower(pairs, ab01, ab23)), hn::BitCast(f, hn::InterleaveUpper(pairs, ab01, ab23)),
        hn::BitCast(f, hn::InterleaveLower(pairs, cd01, cd23)), hn::BitCast(f, hn::InterleaveUpper(pairs, cd01, cd23))};
}

#endif

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
