// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/io/AmrexHeader.h"
#include "brickwall/core/model/Model.h"

#include <cstdint>
#include <string>
#include <vector>

namespace brickwall {

/// A level's boxes, and where its data lie.
struct AmrexPlotLevel
{
    std::string place; ///< its Cell_H
    std::string folder;
    AmrexCells cells;
    int level = 0; ///< ours, 0 being the finest
};

/// A part of a FAB that is not covered by finer levels, and the brick that its values go to.
struct AmrexPiece
{
    Box3i cells; ///< in its level's indices
    std::uint32_t brick = 0;
};

/// One FAB with something to read: all its pieces.
struct AmrexJob
{
    std::uint32_t levelIndex = 0;
    std::uint32_t fab = 0;
    std::size_t firstPiece = 0;
    std::size_t endPiece = 0;
};

/// What to read and where to put it.
struct AmrexPlan
{
    std::vector<AmrexPlotLevel> levels; ///< coarse to fine, as in the file
    std::vector<Brick> bricks;
    std::vector<AmrexPiece> pieces;
    std::vector<AmrexJob> jobs;
    std::uint64_t cellCount = 0;
    std::uint64_t coveredCells = 0;
};

/// Reads the boxes of all levels, leaves out what finer levels cover, and merges what is left into bricks. Throws Error
/// as leafBoxes does, and where Cell_H and Header disagree.
AmrexPlan planPlotfile(const std::string& folder, const AmrexHeader& header, const Executor& executor,
                       Progress& progress);

} // namespace brickwall
