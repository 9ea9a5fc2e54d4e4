// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/MergeBoxes.h"

#include <algorithm>
#include <tuple>

namespace brickwall {
namespace {

/// Orders bricks so that those which may be joined along the axis follow each other.
auto lineKey(const Brick& b, int axis)
{
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    return std::tuple(b.level, b.size[u], b.size[v], b.lower[u], b.lower[v], b.lower[axis]);
}

bool continues(const Brick& a, const Brick& b, int axis)
{
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    return a.level == b.level && a.size[u] == b.size[u] && a.size[v] == b.size[v] && a.lower[u] == b.lower[u] &&
           a.lower[v] == b.lower[v] && a.lower[axis] + a.size[axis] * a.cellWidth() == b.lower[axis];
}

} // namespace

bool mergeAlong(std::vector<Brick>& bricks, int axis, int maxWidth)
{
    if (bricks.empty())
        return false;
    std::sort(bricks.begin(), bricks.end(),
              [axis](const Brick& a, const Brick& b) { return lineKey(a, axis) < lineKey(b, axis); });
    std::size_t last = 0;
    for (std::size_t i = 1; i < bricks.size(); ++i) {
        Brick& a = bricks[last];
        const Brick b = bricks[i];
        if (continues(a, b, axis) && b.size[axis] <= maxWidth - a.size[axis])
            a.size[axis] += b.size[axis];
        else
            bricks[++last] = b;
    }
    const bool joined = last + 1 < bricks.size();
    bricks.resize(last + 1);
    return joined;
}

void mergeBoxes(std::vector<Brick>& bricks, int maxWidth, Progress& progress)
{
    for (bool joined = true; joined;) {
        joined = false;
        for (const int axis : {1, 2, 0}) { // rows of loose cells are as long as they can be already
            progress.check();
            joined = mergeAlong(bricks, axis, maxWidth) || joined;
        }
    }
    const auto key = [](const Brick& b) { return std::tuple(b.level, b.lower.z, b.lower.y, b.lower.x); };
    std::sort(bricks.begin(), bricks.end(), [&](const Brick& a, const Brick& b) { return key(a) < key(b); });
    std::uint64_t cells = 0;
    for (Brick& b : bricks) {
        b.begin = cells;
        cells += b.cellCount();
    }
}

} // namespace brickwall
