// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Half.h"

#include <cstdint>
#include <span>

namespace brickwall {

/// What a box of the region tree is to the bricks whose supports overlap it.
struct RegionLeaf
{
    enum class Kind {
        empty,       ///< no brick contributes
        singleBrick, ///< one brick's padded values give B everywhere
        sameBricks,  ///< several bricks, all of which contribute everywhere
        mixed        ///< none of these: to be split
    };

    Kind kind = Kind::empty;
    std::uint32_t brick = 0; ///< if singleBrick
    int brickCount = 0;      ///< bricks that contribute somewhere
    int levelCount = 0;      ///< of these bricks
};

/// `bricks` are indices into `supports`; those that do not overlap the box are ignored.
RegionLeaf regionLeaf(const Box3i& box, std::span<const std::uint32_t> bricks, std::span<const half::Support> supports);

} // namespace brickwall
