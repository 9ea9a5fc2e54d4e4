// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"

#include <glm/common.hpp>

#include <cstdint>
#include <limits>

namespace brickwall {

/// An axis-aligned box. For integer boxes in voxel space `upper` is exclusive: the box of one cell of level L at lower
/// corner c is [c, c + 2^L). A default-constructed box is empty and may be extended.
template <class T>
struct Box
{
    using Vec = glm::vec<3, T>;

    Vec lower{std::numeric_limits<T>::max()};
    Vec upper{std::numeric_limits<T>::lowest()};

    bool operator==(const Box&) const = default;

    bool empty() const { return lower.x >= upper.x || lower.y >= upper.y || lower.z >= upper.z; }
    Vec extent() const { return upper - lower; }

    void extend(const Vec& p)
    {
        lower = glm::min(lower, p);
        upper = glm::max(upper, p);
    }
    void extend(const Box& b)
    {
        lower = glm::min(lower, b.lower);
        upper = glm::max(upper, b.upper);
    }
    /// Half-open: the lower faces belong to the box, the upper ones do not.
    bool contains(const Vec& p) const
    {
        return p.x >= lower.x && p.y >= lower.y && p.z >= lower.z && p.x < upper.x && p.y < upper.y && p.z < upper.z;
    }
    bool contains(const Box& b) const
    {
        return b.lower.x >= lower.x && b.lower.y >= lower.y && b.lower.z >= lower.z && b.upper.x <= upper.x &&
               b.upper.y <= upper.y && b.upper.z <= upper.z;
    }
    /// True if the interiors have a common point; boxes that only touch do not overlap.
    bool overlaps(const Box& b) const { return !intersection(b).empty(); }
    Box intersection(const Box& b) const { return {glm::max(lower, b.lower), glm::min(upper, b.upper)}; }
};

using Box3i = Box<int>;
using Box3d = Box<double>;

/// The number of unit cells in a box, 0 if it is empty.
inline std::int64_t volume(const Box3i& b)
{
    if (b.empty())
        return 0;
    return (std::int64_t(b.upper.x) - b.lower.x) * (std::int64_t(b.upper.y) - b.lower.y) *
           (std::int64_t(b.upper.z) - b.lower.z);
}

} // namespace brickwall
