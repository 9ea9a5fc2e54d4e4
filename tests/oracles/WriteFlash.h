// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Box.h"

#include <functional>
#include <string>
#include <vector>

namespace brickwall::oracles {

/// A FLASH file to be written: an octree of blocks of the same number of cells, over a grid of root blocks, which are
/// refine level 1.
struct Flash3
{
    std::vector<std::string> fields{"dens"};
    vec3i blockCells{4, 4, 4};
    vec3i rootBlocks{1, 1, 1};
    vec3d lower{0.0}, upper{1.0};
    /// Whether a block, given by its place in the grid of its refine level, has eight children.
    std::function<bool(int refineLevel, const vec3i& block)> refined = [](int, const vec3i&) { return false; };
    /// A cell's value, by its place in its refine level; those of blocks that are no leaves are written as NaN.
    std::function<double(int refineLevel, int field, const vec3i& cell)> value = [](int, int, const vec3i&) {
        return 0.0;
    };

    bool floats = true; ///< plot files have float numbers and faces, checkpoints double ones
    bool chunked = false;
    bool tree = false; ///< whether `gid` is written, which lists each block's children
    std::string geometry = "cartesian";
};

/// One block, in the order in which they are written: parents before children.
struct FlashBlock
{
    int refineLevel = 1;
    vec3i place{0}; ///< in the grid of its level
    bool leaf = true;
};

std::vector<FlashBlock> flashBlocks(const Flash3& flash);

/// Throws Error if it cannot.
void writeFlash(const std::string& path, const Flash3& flash);

} // namespace brickwall::oracles
