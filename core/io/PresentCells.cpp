// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/PresentCells.h"

#include "brickwall/core/model/MergeBoxes.h"

#include <algorithm>

namespace brickwall {

void appendPresent(const Box3i& cells, int level, const std::function<bool(const vec3i& cell)>& present,
                   std::vector<Brick>& bricks)
{
    const int width = 1 << level;
    std::vector<Brick> rows;
    for (int z = cells.lower.z; z < cells.upper.z; ++z)
        for (int y = cells.lower.y; y < cells.upper.y; ++y) {
            bool open = false;
            for (int x = cells.lower.x; x < cells.upper.x; ++x) {
                const bool here = present({x, y, z});
                if (here && open)
                    ++rows.back().size.x;
                else if (here)
                    rows.push_back({vec3i(x, y, z) * width, vec3i(1), level, 0});
                open = here;
            }
        }
    const vec3i size = cells.extent();
    const int widest = std::max({size.x, size.y, size.z});
    mergeAlong(rows, 1, widest);
    mergeAlong(rows, 2, widest);
    bricks.insert(bricks.end(), rows.begin(), rows.end());
}

} // namespace brickwall
