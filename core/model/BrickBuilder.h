// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/model/Model.h"

#include <span>
#include <vector>

namespace brickwall {

struct BrickBuilderConfig
{
    int maxBrickWidth = 64; ///< in cells, per axis
};

/// Bricks, and where the values of their cells come from: value slot i (brick order, x fastest) takes the value of
/// source cell or source slot `source[i]`.
struct BrickLayout
{
    std::vector<Brick> bricks;
    std::vector<std::uint32_t> source;
    std::uint64_t duplicates = 0; ///< equal cells dropped (the first of them is kept)
};

/// Bricks for loose cells in any order, at most 2^32 - 1 of them. Throws Error, naming `place` and the cell's record,
/// for cells that are misaligned, out of bounds, or overlap cells of another level. Deterministic, whatever the
/// executor.
BrickLayout buildBricks(std::span<const Cell> cells, std::string_view place, const BrickBuilderConfig& config,
                        const Executor& executor, Progress& progress);

/// The same cells in fewer, larger bricks: same-level neighbours whose common face is the whole face of both are
/// merged, repeatedly, while the result stays within maxBrickWidth. Cost per region, not per sample, is what made large
/// data slow in earlier systems. Deterministic.
BrickLayout mergeBricks(std::span<const Brick> bricks, const BrickBuilderConfig& config, const Executor& executor,
                        Progress& progress);

/// Values in the order of a layout.
std::vector<float> gather(std::span<const float> sourceValues, std::span<const std::uint32_t> source,
                          const Executor& executor);

} // namespace brickwall
