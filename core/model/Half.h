// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Model.h"

/// Geometry in half voxels, where all that the regions are cut by is an integer: a cell of level L is 2 << L wide, its
/// centre 1 << L above its lower face. Used by the region builder alone.
namespace brickwall::half {

/// Where a brick's tents are not zero: its box grown by half of its own cell width. Half voxels.
struct Support
{
    Box3i box;
    int level = 0;

    int halfCell() const { return 1 << level; }
};

inline Support supportOf(const Brick& brick)
{
    const Box3i b = brick.box();
    const int h = 1 << brick.level;
    return {{b.lower * 2 - h, b.upper * 2 + h}, brick.level};
}

inline int floorCell(int halfVoxel, int level)
{
    return halfVoxel >> (level + 1);
}

inline int ceilCell(int halfVoxel, int level)
{
    return (halfVoxel + (2 << level) - 1) >> (level + 1);
}

/// The cells of a level, counted from the origin, whose tents are positive somewhere inside the box; upper exclusive.
inline Box3i cellsReaching(const Box3i& box, int level)
{
    Box3i cells;
    for (int a = 0; a < 3; ++a) {
        cells.lower[a] = floorCell(box.lower[a] - (1 << level), level);
        cells.upper[a] = ceilCell(box.upper[a] - (1 << level), level) + 1;
    }
    return cells;
}

/// The brick's own cells, counted from the origin at its level; upper exclusive.
inline Box3i cellsOf(const Support& s)
{
    const int h = s.halfCell();
    Box3i cells;
    for (int a = 0; a < 3; ++a) {
        cells.lower[a] = floorCell(s.box.lower[a] + h, s.level);
        cells.upper[a] = floorCell(s.box.upper[a] - h, s.level);
    }
    return cells;
}

} // namespace brickwall::half
