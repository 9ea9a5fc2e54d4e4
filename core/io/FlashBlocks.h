// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/Hdf5File.h"
#include "brickwall/core/io/LevelBoxes.h"

#include <cstdint>
#include <string>
#include <vector>

namespace brickwall {

/// The leaf blocks of a FLASH file (FLASH 3 and 4, Flash-X: PARAMESH's octree, or a uniform grid), by refine level.
struct FlashBlocks
{
    std::vector<BoxLevel> levels;                   ///< coarse to fine
    std::vector<std::vector<std::uint32_t>> blocks; ///< the block in the file of each box
    std::vector<std::uint64_t> shape;               ///< of each field: blocks, nz, ny, nx
    mat4d worldFromVoxel{1.0};
};

/// `anyField` gives the shape; where blocks lie is FlashTable's. Source: the FLASH4 User's Guide, "Output Formats".
///
/// Throws Error for fewer than three dimensions, other geometries than Cartesian, and for blocks that are not where an
/// octree has them.
FlashBlocks readFlashBlocks(const Hdf5File& file, const std::string& anyField);

} // namespace brickwall
