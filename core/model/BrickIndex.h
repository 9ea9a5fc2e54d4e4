// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Model.h"

#include <algorithm>
#include <cstdint>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace brickwall {

/// Finds which of the boxes boxOf(0) to boxOf(count - 1) are near a box: a bounding volume hierarchy, halved at the
/// median centre. O(n log n) to build, 12 bytes a box, as the boxes themselves stay where they are. Sums of their
/// corners have to be ints.
class BoxTree
{
public:
    template <class BoxOf>
    BoxTree(std::size_t count, const BoxOf& boxOf)
    {
        reserve(count);
        if (count > 0)
            build(0, 0, std::uint32_t(count), boxOf);
    }

    /// The boxes in the order in which they are found.
    const std::vector<std::uint32_t>& order() const { return order_; }

    /// Calls visit(place in the order) for every leaf's boxes whose bounds overlap `box`.
    template <class Visit>
    void nearby(const Box3i& box, Visit&& visit) const
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
                visit(i);
        }
    }

private:
    static constexpr std::uint32_t boxesPerLeaf = 8;

    /// An inner node's children are nodes_[first] and nodes_[first + 1], a leaf's boxes order_[first .. first + count).
    struct Node
    {
        Box3i box;
        std::uint32_t first = 0;
        std::uint32_t count = 0; ///< 0: inner
    };

    void reserve(std::size_t count); ///< and the order 0, 1, 2 ...
    template <class BoxOf>
    void build(std::size_t node, std::uint32_t begin, std::uint32_t end, const BoxOf& boxOf);

    std::vector<Node> nodes_;
    std::vector<std::uint32_t> order_;
};

template <class BoxOf>
void BoxTree::build(std::size_t node, std::uint32_t begin, std::uint32_t end, const BoxOf& boxOf)
{
    Box3i box, centres;
    for (std::uint32_t i = begin; i < end; ++i) {
        const Box3i b = boxOf(order_[i]);
        box.extend(b);
        centres.extend(b.lower + b.upper);
    }
    nodes_[node].box = box;
    const vec3i e = centres.extent();
    if (end - begin <= boxesPerLeaf || e == vec3i(0)) { // boxes of one centre are found all or hardly any
        nodes_[node].first = begin;
        nodes_[node].count = end - begin;
        return;
    }
    const int axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         const Box3i p = boxOf(a), q = boxOf(b);
                         const int cp = p.lower[axis] + p.upper[axis], cq = q.lower[axis] + q.upper[axis];
                         return cp != cq ? cp < cq : a < b;
                     });
    const auto child = std::uint32_t(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[node].first = child;
    build(child, begin, middle, boxOf);
    build(child + 1, middle, end, boxOf);
}

/// Finds the bricks, or other boxes, that a box overlaps. The order of the bricks found is fixed, but not ascending.
/// Immutable once built; it keeps their boxes.
class BrickIndex
{
public:
    explicit BrickIndex(std::span<const Brick> bricks);
    explicit BrickIndex(std::span<const Box3i> boxes);

    /// Calls visit(brick index, brick's box) for every brick whose box has a common interior point with `box`.
    template <class Visit>
    void overlapping(const Box3i& box, Visit&& visit) const
    {
        tree_.nearby(box, [&](std::uint32_t i) {
            if (boxes_[i].overlaps(box))
                visit(tree_.order()[i], boxes_[i]);
        });
    }

private:
    BoxTree tree_;
    std::vector<Box3i> boxes_; ///< in the tree's order
};

/// The first two of the boxes boxOf(0) to boxOf(count - 1), by index, that have a common interior point.
template <class BoxOf>
std::optional<std::pair<std::size_t, std::size_t>> findOverlap(std::size_t count, const BoxOf& boxOf)
{
    const BoxTree tree(count, boxOf);
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t other = count;
        const Box3i box = boxOf(i);
        tree.nearby(box, [&](std::uint32_t at) {
            if (const std::size_t j = tree.order()[at]; j > i && boxOf(j).overlaps(box))
                other = std::min(other, j);
        });
        if (other < count)
            return std::pair(i, other);
    }
    return std::nullopt;
}

/// The first two bricks, by index, that have a common interior point.
std::optional<std::pair<std::size_t, std::size_t>> findOverlap(std::span<const Brick> bricks);

} // namespace brickwall
