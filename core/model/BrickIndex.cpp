// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/BrickIndex.h"

#include "brickwall/core/base/Error.h"

#include <bit>
#include <limits>
#include <numeric>
#include <string>

namespace brickwall {
namespace {

template <class BoxOf>
std::vector<Box3i> ordered(const BoxTree& tree, const BoxOf& boxOf)
{
    std::vector<Box3i> boxes;
    boxes.reserve(tree.order().size());
    for (const std::uint32_t i : tree.order())
        boxes.push_back(boxOf(i));
    return boxes;
}

auto boxesOf(std::span<const Brick> bricks)
{
    return [bricks](std::size_t i) { return bricks[i].box(); };
}

auto boxesOf(std::span<const Box3i> boxes)
{
    return [boxes](std::size_t i) { return boxes[i]; };
}

} // namespace

void BoxTree::reserve(std::size_t count)
{
    if (count > std::numeric_limits<std::uint32_t>::max() / 2)
        throw Error("bricks", "expected less than 2^31 bricks, found " + std::to_string(count));
    order_.resize(count);
    std::iota(order_.begin(), order_.end(), 0u);
    nodes_.reserve(2 * std::bit_ceil(count / boxesPerLeaf + 1));
    if (count > 0)
        nodes_.emplace_back();
}

BrickIndex::BrickIndex(std::span<const Brick> bricks)
    : tree_(bricks.size(), boxesOf(bricks)), boxes_(ordered(tree_, boxesOf(bricks)))
{
}

BrickIndex::BrickIndex(std::span<const Box3i> boxes)
    : tree_(boxes.size(), boxesOf(boxes)), boxes_(ordered(tree_, boxesOf(boxes)))
{
}

std::optional<std::pair<std::size_t, std::size_t>> findOverlap(std::span<const Brick> bricks)
{
    return findOverlap(bricks.size(), boxesOf(bricks));
}

} // namespace brickwall
