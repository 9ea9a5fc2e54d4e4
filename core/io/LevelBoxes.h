// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/model/Model.h"

#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

/// One level of a format whose levels are lists of boxes (AMReX, Chombo, FLASH, VTK), in this level's own indices, the
/// upper corner exclusive. Index 0 of all levels is at the same place.
struct BoxLevel
{
    std::string place; ///< of its boxes, for messages: a file, or a file and a group in it
    int level = 0;     ///< ours, 0 being the finest
    std::vector<Box3i> boxes;
};

/// A part of a box that no finer level covers, and the brick that its values go to.
struct LeafPiece
{
    Box3i cells; ///< in its level's indices
    std::uint32_t brick = 0;
};

/// One box with something to read: all its pieces.
struct LeafJob
{
    std::uint32_t levelIndex = 0; ///< into the levels that were planned
    std::uint32_t box = 0;        ///< into that level's boxes
    std::size_t firstPiece = 0;
    std::size_t endPiece = 0;
};

/// Which cells to read from which box, and where to put them.
struct LeafPlan
{
    std::vector<Brick> bricks;
    std::vector<LeafPiece> pieces;
    std::vector<LeafJob> jobs; ///< by level and box, at most one for each box
    std::uint64_t cellCount = 0;
    std::uint64_t coveredCells = 0; ///< left out
};

/// Our numbers of levels that are listed from coarse to fine, the one at i + 1 being ratios[i] times as fine as the one
/// at i: one number more than ratios. Throws Error at `place` for a ratio that is no power of two from 2 on, and for
/// more than maxLevel levels of ours.
std::vector<int> levelNumbers(std::span<const int> ratios, const std::string& place);

/// Throws Error, naming the level's place and the box's index, for a box that is empty or outside coordinateLimit and
/// for two that overlap, and for 2^32 cells. What readers ask first, as a list of boxes that means harm may be long.
void checkLevel(const BoxLevel& level);

/// The plan for levels that keep coarse data under fine ones, listed from coarse to fine: what finer levels cover is
/// left out, what is left is merged into bricks. A level may have no boxes. Throws Error as leafBoxes does, for indices
/// outside coordinateLimit, and, at `place`, for no cells or 2^32 of them. Memory: the boxes and bricks, nothing per
/// cell, and for boxes that are refused less than 50 bytes each.
LeafPlan planLeaves(std::span<const BoxLevel> levels, const std::string& place, const Executor& executor,
                    Progress& progress);

/// The plan for boxes that are all leaves, in any order of levels. Throws Error as planLeaves does; boxes that overlap,
/// of whatever levels, are named.
LeafPlan planDisjoint(std::span<const BoxLevel> levels, const std::string& place, Progress& progress);

/// The transform for a file that says where its finest level's cell `index` has its lower corner, and how large the
/// cells of that level are. They may be wider along one axis than along another.
mat4d worldFromIndices(const vec3d& corner, const vec3i& index, const vec3d& cellSize);

} // namespace brickwall
