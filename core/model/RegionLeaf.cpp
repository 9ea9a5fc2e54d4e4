// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/RegionLeaf.h"

#include <bit>
#include <optional>

namespace brickwall {
namespace {

/// One brick whose padded values give B in all of the box, where all bricks have one level. The box has to lie inside
/// its support, so that no stencil leaves the pad layer; and the cells that are there have to form a box, so that
/// clamping at the missing layers is what N / D does.
std::optional<std::uint32_t> singleBrick(const Box3i& box, std::span<const std::uint32_t> bricks,
                                         std::span<const half::Support> supports, int level)
{
    const Box3i stencils = half::cellsReaching(box, level);
    std::optional<std::uint32_t> best;
    std::int64_t bestCells = 0, present = 0;
    Box3i bounds;
    for (const std::uint32_t b : bricks) {
        const Box3i cells = stencils.intersection(half::cellsOf(supports[b]));
        const std::int64_t count = volume(cells);
        if (count == 0)
            continue;
        present += count;
        bounds.extend(cells);
        if (count > bestCells && supports[b].box.contains(box)) {
            best = b;
            bestCells = count;
        }
    }
    return best && present == volume(bounds) ? best : std::nullopt;
}

} // namespace

RegionLeaf regionLeaf(const Box3i& box, std::span<const std::uint32_t> bricks, std::span<const half::Support> supports)
{
    RegionLeaf leaf;
    std::uint32_t levels = 0;
    bool everywhere = true, anywhere = false;
    int level = 0;
    for (const std::uint32_t b : bricks) {
        const half::Support& s = supports[b];
        if (!s.box.overlaps(box))
            continue;
        ++leaf.brickCount;
        level = s.level;
        levels |= 1u << s.level;
        const bool covers = s.box.contains(box);
        everywhere = everywhere && covers;
        anywhere = anywhere || covers;
    }
    leaf.levelCount = std::popcount(levels);
    if (leaf.brickCount == 0)
        return leaf;
    if (const auto single =
            leaf.levelCount == 1 && anywhere ? singleBrick(box, bricks, supports, level) : std::nullopt) {
        leaf.kind = RegionLeaf::Kind::singleBrick;
        leaf.brick = *single;
        return leaf;
    }
    leaf.kind = everywhere ? RegionLeaf::Kind::sameBricks : RegionLeaf::Kind::mixed;
    return leaf;
}

} // namespace brickwall
