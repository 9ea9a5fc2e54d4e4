// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Range.h"

#include <algorithm>
#include <bit>
#include <cstdint>

namespace brickwall {

/// The range of floats, kept as integers in the same order, in which values that are not finite lie at the ends.
struct OrderedRange
{
    std::int32_t lo = INT32_MAX, hi = INT32_MIN;

    /// A float's bits as its place in the order, and back.
    static std::int32_t ordered(std::int32_t bits) { return bits ^ ((bits >> 31) & INT32_MAX); }

    void extend(float v)
    {
        const std::int32_t place = ordered(std::bit_cast<std::int32_t>(v));
        lo = std::min(lo, place);
        hi = std::max(hi, place);
    }
    void extend(const OrderedRange& r)
    {
        lo = std::min(lo, r.lo);
        hi = std::max(hi, r.hi);
    }
    /// Whether all values were; so is an empty range.
    bool finite() const
    {
        constexpr std::int32_t infinite = 0x7f800000;
        return hi < infinite && lo > ~infinite;
    }
    Range range() const { return {std::bit_cast<float>(ordered(lo)), std::bit_cast<float>(ordered(hi))}; }
};

/// Narrows `count` numbers to float, and says what range they have then.
OrderedRange narrowRow(const double* in, int count, float* out);

} // namespace brickwall
