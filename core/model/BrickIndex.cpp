// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/BrickIndex.h"

#include "brickwall/core/base/Error.h"

#include <algorithm>
#include <limits>
#include <numeric>

namespace brickwall {
namespace {

constexpr std::uint32_t bricksPerLeaf = 4;

} // namespace

BrickIndex::BrickIndex(std::span<const Brick> bricks)
{
    if (bricks.size() > std::numeric_limits<std::uint32_t>::max() / 2)
        throw Error("bricks", "expected less than 2^31 bricks, found " + std::to_string(bricks.size()));
    if (bricks.empty())
        return;
    order_.resize(bricks.size());
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.emplace_back();
    build(0, 0, std::uint32_t(bricks.size()), bricks);
    boxes_.reserve(bricks.size());
    for (const std::uint32_t b : order_)
        boxes_.push_back(bricks[b].box());
}

void BrickIndex::build(std::size_t node, std::uint32_t begin, std::uint32_t end, std::span<const Brick> bricks)
{
    const auto centre2 = [&](std::uint32_t b, int axis) {
        const Box3i box = bricks[b].box();
        return box.lower[axis] + box.upper[axis];
    };
    Box3i box, centres;
    for (std::uint32_t i = begin; i < end; ++i) {
        const Box3i b = bricks[order_[i]].box();
        box.extend(b);
        centres.extend(b.lower + b.upper);
    }
    nodes_[node].box = box;
    if (end - begin <= bricksPerLeaf) {
        nodes_[node].first = begin;
        nodes_[node].count = end - begin;
        return;
    }
    const vec3i e = centres.extent();
    const int axis = e.x >= e.y && e.x >= e.z ? 0 : e.y >= e.z ? 1 : 2;
    const std::uint32_t middle = begin + (end - begin) / 2;
    std::nth_element(order_.begin() + begin, order_.begin() + middle, order_.begin() + end,
                     [&](std::uint32_t a, std::uint32_t b) {
                         const int ca = centre2(a, axis), cb = centre2(b, axis);
                         return ca != cb ? ca < cb : a < b;
                     });
    const auto child = std::uint32_t(nodes_.size());
    nodes_.resize(nodes_.size() + 2);
    nodes_[node].first = child;
    build(child, begin, middle, bricks);
    build(child + 1, middle, end, bricks);
}

std::optional<std::pair<std::size_t, std::size_t>> findOverlap(std::span<const Brick> bricks)
{
    const BrickIndex index(bricks);
    for (std::size_t i = 0; i < bricks.size(); ++i) {
        std::size_t other = bricks.size();
        index.overlapping(bricks[i].box(), [&](std::uint32_t j, const Box3i&) {
            if (j > i)
                other = std::min<std::size_t>(other, j);
        });
        if (other < bricks.size())
            return std::pair(i, other);
    }
    return std::nullopt;
}

} // namespace brickwall
