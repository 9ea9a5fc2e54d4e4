// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "brickwall/core/simd/NarrowRow.cpp"
#include "brickwall/core/simd/ForEachTarget.h"

#include "brickwall/core/simd/NarrowRow.h"

#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

namespace hn = hwy::HWY_NAMESPACE;

OrderedRange narrowLanes(const double* in, int count, float* out)
{
    OrderedRange range;
    int i = 0;
#if HWY_TARGET != HWY_SCALAR // whose narrowing has no infinity
    const hn::ScalableTag<double> doubles;
    const hn::Rebind<float, decltype(doubles)> floats;
    const hn::Rebind<std::int32_t, decltype(doubles)> places;
    const auto magnitude = hn::Set(places, INT32_MAX);
    auto lo = hn::Set(places, INT32_MAX), hi = hn::Set(places, INT32_MIN);
    for (const int n = static_cast<int>(hn::Lanes(doubles)); i + n <= count; i += n) {
        const auto narrow = hn::DemoteTo(floats, hn::LoadU(doubles, in + i));
        hn::StoreU(narrow, floats, out + i);
        const auto bits = hn::BitCast(places, narrow);
        const auto place = hn::Xor(bits, hn::And(hn::ShiftRight<31>(bits), magnitude)); // OrderedRange::ordered
        lo = hn::Min(lo, place);
        hi = hn::Max(hi, place);
    }
    range.lo = hn::GetLane(hn::MinOfLanes(places, lo));
    range.hi = hn::GetLane(hn::MaxOfLanes(places, hi));
#endif
    for (; i < count; ++i) {
        out[i] = static_cast<float>(in[i]);
        range.extend(out[i]);
    }
    return range;
}

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#if HWY_ONCE

namespace brickwall {

HWY_EXPORT(narrowLanes);

OrderedRange narrowRow(const double* in, int count, float* out)
{
    return HWY_DYNAMIC_DISPATCH(narrowLanes)(in, count, out);
}

} // namespace brickwall

#endif // HWY_ONCE
