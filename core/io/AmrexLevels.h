// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Progress.h"
#include "brickwall/core/io/AmrexHeader.h"
#include "brickwall/core/io/LevelBoxes.h"

#include <string>
#include <vector>

namespace brickwall {

/// Where a plotfile's boxes lie and where their data are, coarse to fine as in the file.
struct AmrexLevels
{
    std::vector<BoxLevel> boxes; ///< `place` is the level's Cell_H
    std::vector<std::string> folders;
    std::vector<AmrexCells> cells; ///< their boxes have moved to `boxes`
};

/// Reads the boxes of all levels. Throws Error for what is broken in a Cell_H, and where it and Header disagree.
AmrexLevels readAmrexLevels(const std::string& folder, const AmrexHeader& header, Progress& progress);

/// Throws Error for data files that are missing or far too short for the boxes: to be asked before memory is. What else
/// is missing is found, with its place, when the FAB is read.
void checkDataSizes(const AmrexLevels& levels);

} // namespace brickwall
