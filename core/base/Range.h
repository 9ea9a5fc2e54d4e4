// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <limits>

namespace brickwall {

/// A closed interval of field values. A default-constructed range is empty and may be extended.
struct Range
{
    float lo = std::numeric_limits<float>::infinity();
    float hi = -std::numeric_limits<float>::infinity();

    bool operator==(const Range&) const = default;

    bool empty() const { return !(lo <= hi); }
    float span() const { return hi - lo; }
    bool contains(float v) const { return v >= lo && v <= hi; }
    bool overlaps(const Range& r) const { return lo <= r.hi && r.lo <= hi; }

    void extend(float v)
    {
        lo = std::min(lo, v);
        hi = std::max(hi, v);
    }
    void extend(const Range& r)
    {
        lo = std::min(lo, r.lo);
        hi = std::max(hi, r.hi);
    }
};

} // namespace brickwall
