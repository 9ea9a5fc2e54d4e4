// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Model.h"

#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace brickwall {

/// Finds the bricks that a box overlaps: a bounding volume hierarchy over the bricks' boxes, halved at the median
/// centre. O(n log n) to build; the order of the bricks found is fixed, but not ascending. Immutable once built.
class BrickIndex
{
public:
    explicit BrickIndex(std::span<const Brick> bricks);

    /// Calls visit(brick index, brick's box) for every brick whose box has a common interior point with `box`.
    template <class Visit>
    void overlapping(const Box3i& box, Visit&& visit) const
    {
        std::uint32_t stack[64];
        int top = 0;
        if (!nodes_.empty())
            stack[top++] = 0;
        while (top > 0) {
            const Node& node = nodes_[stack[--top]];
            if (!node.box.overlaps(box))
                continue;
            if (node.count == 0) {
                stack[top++] = node.first + 1;
                stack[top++] = node.first;
                continue;
            }
            for (std::uint32_t i = node.first; i < node.first + node.count; ++i)
                if (boxes_[i].overlaps(box))
                    visit(order_[i], boxes_[i]);
        }
    }

private:
    /// An inner node's children are nodes_[first] and nodes_[first + 1], a leaf's bricks order_[first .. first +
    /// count).
    struct Node
    {
        Box3i box;
        std::uint32_t first = 0;
        std::uint32_t count = 0; ///< 0: inner
    };

    void build(std::size_t node, std::uint32_t begin, std::uint32_t end, std::span<const Brick> bricks);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
    std::vector<Box3i> boxes_; ///< in the order of order_
};

/// The first two bricks, by index, that have a common interior point.
std::optional<std::pair<std::size_t, std::size_t>> findOverlap(std::span<const Brick> bricks);

} // namespace brickwall
