// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Extinction and colour of values in lanes, from the table of a transfer function. Per instruction set, see
/// core/simd/Lanes.h.
#if defined(BRICKWALL_CORE_TRACE_TRANSFER_LOOKUP_H) == defined(HWY_TARGET_TOGGLE)
#ifdef BRICKWALL_CORE_TRACE_TRANSFER_LOOKUP_H
#undef BRICKWALL_CORE_TRACE_TRANSFER_LOOKUP_H
#else
#define BRICKWALL_CORE_TRACE_TRANSFER_LOOKUP_H
#endif

#include "brickwall/core/shade/TransferFunction.h"
#include "brickwall/core/simd/Lanes.h"

#include <cmath>

HWY_BEFORE_NAMESPACE();
namespace brickwall::HWY_NAMESPACE {

class TransferLookup
{
public:
    explicit TransferLookup(const TransferTable& table)
        : entries_(&table.entries.front().x),
          lo_(table.range.lo),
          hi_(table.range.hi),
          logarithmic_(table.scale == Scale::logarithmic),
          last_(static_cast<float>(table.entries.size() - 1))
    {
        const double lo = logarithmic_ ? std::log(double(lo_)) : double(lo_);
        const double hi = logarithmic_ ? std::log(double(hi_)) : double(hi_);
        origin_ = static_cast<float>(lo);
        entriesPerUnit_ = hi > lo ? static_cast<float>(last_ / (hi - lo)) : 0.0f;
    }

    /// Colour and extinction per finest cell, which is 0 outside the range and in lanes that are not active.
    HWY_INLINE QuadN operator()(FloatN value, MaskN active) const
    {
        const MaskN inside = active & (value >= FloatN(lo_)) & (value <= FloatN(hi_));
        const FloatN v = select(inside, value, lo_);
        const FloatN x = ((logarithmic_ ? log(v) : v) - FloatN(origin_)) * FloatN(entriesPerUnit_);
        const FloatN below = clamp(floor(x), 0.0f, last_ - 1.0f);
        const FloatN f = clamp(x - below, 0.0f, 1.0f);
        const IntN first = toInt(below) * IntN(4);
        const QuadN p = gatherQuads(QuadAt{entries_}, first), q = gatherQuads(QuadAt{entries_ + 4}, first);
        return {lerp(p.a, q.a, f), lerp(p.b, q.b, f), lerp(p.c, q.c, f), valueOrZero(inside, lerp(p.d, q.d, f))};
    }

private:
    const float* entries_;
    float lo_, hi_;
    bool logarithmic_;
    float last_;
    float origin_ = 0.0f;
    float entriesPerUnit_ = 0.0f;
};

} // namespace brickwall::HWY_NAMESPACE
HWY_AFTER_NAMESPACE();

#endif
