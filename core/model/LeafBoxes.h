// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Box.h"
#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <utility>
#include <vector>

namespace brickwall {

/// A piece of `boxes[source]` of the level at index `levelIndex`.
struct LeafBox
{
    Box3i box;
    std::uint32_t levelIndex = 0;
    std::uint32_t source = 0;

    bool operator==(const LeafBox&) const = default;
};

/// What is left of each of `boxes` when all `holes` are cut out of it, as disjoint boxes in the order of their sources.
/// Every face of a piece lies in a face of its source or of a hole, so that pieces are as aligned as those are. Holes
/// may overlap.
///
/// The holes of a box are found through an index; it is then halved by planes through faces of holes that leave few of
/// them on both sides: O(n log n) for the boxes of AMR codes. Deterministic, whatever the executor. Throws Cancelled.
std::vector<LeafBox> subtractBoxes(std::span<const Box3i> boxes, std::span<const Box3i> holes, const Executor& executor,
                                   const Progress& progress);

/// The indices of two boxes with a common interior (the pair with the smallest first index), if there are any.
/// O(n log n) for disjoint boxes.
std::optional<std::pair<std::size_t, std::size_t>> findOverlap(std::span<const Box3i> boxes);

/// A level of a code whose levels overlap (AMReX, Chombo, VTK): it keeps coarse data under fine ones.
struct OverlappingLevel
{
    std::string place; ///< of its boxes, for messages: the file that lists them
    int level = 0;
    std::vector<Box3i> boxes; ///< in voxel space
};

/// The parts of all boxes that no finer level covers, ordered by level and source. `levels` goes from coarse to fine; a
/// box need not lie inside boxes of the next coarser level.
///
/// Throws Error, naming the level's place and the box's index, for boxes that are empty, outside coordinateLimit, not
/// aligned to their own cells, that overlap within a level, or, where boxes of several levels overlap at all, that
/// together cover cells of the next coarser level in part.
std::vector<LeafBox> leafBoxes(std::span<const OverlappingLevel> levels, const Executor& executor,
                               const Progress& progress);

} // namespace brickwall
