// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/LevelBoxes.h"
#include "brickwall/core/io/TextCursor.h"

#include <cstdint>
#include <string>
#include <vector>

namespace brickwall {

/// One level of a plotfile, 0 being the coarsest as in the file. Boxes are in this level's own indices, upper
/// exclusive.
struct AmrexLevel
{
    Box3i domain;
    vec3d cellSize{0.0};
    int ratio = 1;              ///< to the next finer level
    std::int64_t gridCount = 0; ///< as the plotfile's Header says; the boxes themselves are in Cell_H
    std::string path;           ///< of the level's MultiFab without "_H", relative to the folder
};

/// The file Header of a plotfile (AMReX: WriteGenericPlotfileHeader; BoxLib wrote the same).
struct AmrexHeader
{
    std::string version;
    std::vector<std::string> components;
    vec3d lower{0.0}; ///< of the domain, physical
    vec3d upper{0.0};
    std::vector<AmrexLevel> levels;
};

/// A piece of a level's data on disk: component after component over its box and ghost cells, behind a header of its
/// own.
struct AmrexFab
{
    std::uint32_t file = 0; ///< of AmrexCells::files
    std::uint64_t offset = 0;
};

/// The file Cell_H of a level (VisMF header versions 0 and 1).
struct AmrexCells
{
    std::int64_t components = 0;
    vec3i ghosts{0};
    BoxLevel boxes;
    std::vector<std::string> files; ///< in the folder of Cell_H, each once
    std::vector<AmrexFab> fabs;     ///< one per box
};

/// "HyperCLaw-V1.1" and the like.
bool isPlotfileVersion(const std::string& firstLine);

/// Both throw Error with file and line for all that is not as expected, a plotfile of two dimensions among it.
AmrexHeader readAmrexHeader(const std::string& file);
/// `level` is our number of the level whose Cell_H this is. Boxes that overlap are refused before the rest is read.
AmrexCells readAmrexCells(const std::string& file, int level);

/// "((0,0,0) (31,31,31) (0,0,0))": lowest and highest index, and the centring, which has to be that of cells.
Box3i readAmrexBox(TextCursor& text);

} // namespace brickwall
