// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/tests/io/IoTest.h"

#include <functional>

namespace brickwall {

/// Exact in float, different for every level, component and cell, but for levels so deep that indices are large.
inline double numbered(int level, int component, const vec3i& c)
{
    return level * 1e6 + component * 1e5 + c.x + 40.0 * c.y + 1600.0 * c.z;
}

/// What a model has to hold of levels of boxes, coarse to fine and in their own indices, when what finer levels cover
/// is left out. `ratios` has one number less than there are levels.
inline CellValues leafCells(const std::vector<std::vector<Box3i>>& boxes, const std::vector<int>& ratios,
                            const std::function<double(int level, const vec3i& cell)>& value)
{
    const auto covered = [&](std::size_t level, const vec3i& cell) {
        for (std::size_t fine = level + 1, ratio = 1; fine < boxes.size(); ++fine) {
            ratio *= static_cast<std::size_t>(ratios[fine - 1]);
            for (const Box3i& b : boxes[fine])
                if (b.contains(cell * static_cast<int>(ratio)))
                    return true;
        }
        return false;
    };
    CellValues cells;
    for (std::size_t l = 0; l < boxes.size(); ++l) {
        int width = 1, level = 0;
        for (std::size_t i = l; i + 1 < boxes.size(); ++i)
            width *= ratios[i];
        while (1 << level < width)
            ++level;
        for (const Box3i& b : boxes[l])
            for (int z = b.lower.z; z < b.upper.z; ++z)
                for (int y = b.lower.y; y < b.upper.y; ++y)
                    for (int x = b.lower.x; x < b.upper.x; ++x)
                        if (const vec3i c(x, y, z); !covered(l, c))
                            cells[{x * width, y * width, z * width, level}] =
                                static_cast<float>(value(static_cast<int>(l), c));
    }
    return cells;
}

} // namespace brickwall
