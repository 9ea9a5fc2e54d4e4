// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Progress.h"
#include "brickwall/core/io/LevelBoxes.h"
#include "brickwall/core/io/VdbArray.h"

#include <openvdb/openvdb.h>

#include <cstdint>
#include <string>
#include <vector>

namespace brickwall {

/// The active voxels of all grids of one level; a level without grids has an empty mask.
struct VdbMask
{
    VdbLevel level;
    openvdb::MaskTree active{false};
};

/// Active voxels, and tiles as one each: what a file has stored.
std::uint64_t storedCount(const openvdb::MaskTree& mask);

/// Voxels in a box, which may be more than 2^64.
double volumeOf(const openvdb::CoordBBox& box);

/// Throws Error at `place` for 2^32 cells, and if `stored` voxels and tiles would become so many (more than 2^24, and
/// more than a thousand of each): a file of some kilobytes must not ask for gigabytes.
void checkExpansion(double cells, std::uint64_t stored, const std::string& place);

/// Bricks of the leaf cells of masks, which are listed by level from 0 on, each twice as coarse as the one before.
///
/// Coarse voxels under finer active ones are left out. One that is covered in part is split: what is left of it becomes
/// cells of the finer level. `tiles`: active tiles become one cell each, 8, 128 or 4096 voxels wide, unless finer
/// voxels cover a part of them or they are misaligned; otherwise they become voxels. Throws Error at `place` for
/// voxels outside coordinateLimit, no cells, and where checkExpansion does.
LeafPlan vdbLeaves(std::vector<VdbMask> masks, bool tiles, const std::string& place, Progress& progress);

} // namespace brickwall
