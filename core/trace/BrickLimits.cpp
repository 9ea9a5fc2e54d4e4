// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/BrickLimits.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <limits>

namespace brickwall {

void checkBrickSizes(const RegionTree& tree)
{
    constexpr std::int64_t most = std::numeric_limits<std::int32_t>::max();
    for (const PaddedBrick& brick : tree.bricks) {
        const glm::vec<3, std::int64_t> size(brick.paddedSize());
        if (size.x * size.y > most || size.x * size.y * size.z > most)
            throw Error("regions", fmt::format("a brick of {} x {} x {} cells is too large: expected at most 2^31 - 1 "
                                               "with one cell of padding all around; split it",
                                               brick.size.x, brick.size.y, brick.size.z));
    }
}

} // namespace brickwall
