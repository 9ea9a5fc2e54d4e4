// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/tests/oracles/RandomLayout.h"

#include <string>

namespace brickwall {

struct NamedLayout
{
    std::string name;
    std::vector<Brick> bricks;
};

inline void PrintTo(const NamedLayout& layout, std::ostream* out)
{
    *out << layout.name;
}

/// The layouts that every property of the model is checked on.
inline std::vector<NamedLayout> layouts()
{
    using namespace oracles;
    RandomLayoutConfig plain{.seed = 3, .cut = 0.0};
    RandomLayoutConfig holes{.seed = 4, .refined = 0.5, .hole = 0.3};
    RandomLayoutConfig jumps{.seed = 5, .refined = 0.6, .jump = 1.0, .hole = 0.05};
    RandomLayoutConfig cells{.seed = 6, .coarsestLevel = 2, .blockWidth = 1, .lower = {-4, -8, 4}, .refined = 0.7};
    RandomLayoutConfig negative{.seed = 7, .blockWidth = 3, .lower = {-12, -24, -36}, .hole = 0.2};
    std::vector<Brick> one{{{0, 0, 0}, {1, 1, 1}, 0, 0}};
    std::vector<Brick> edge{{vec3i(-coordinateLimit), {2, 3, 2}, 3, 0},
                            {vec3i(coordinateLimit - 4), {4, 4, 4}, 0, 0},
                            {vec3i(coordinateLimit - 8, coordinateLimit - 4, coordinateLimit - 4), {2, 2, 2}, 1, 0}};
    std::vector<Brick> coarse{{vec3i(-(1 << maxLevel)), {2, 2, 1}, maxLevel, 0},
                              {vec3i(0), {4, 4, 4}, maxLevel - 2, 0}};
    numberCells(one);
    numberCells(edge);
    numberCells(coarse);
    return {{"one cell", one},
            {"uniform blocks", uniformBlocks({3, 2, 2}, 4, 1)},
            {"nested levels", nestedLevels(3, 4, 2)},
            {"octree", randomLayout(plain)},
            {"octree with holes", randomLayout(holes)},
            {"jumps of 4 to 1", randomLayout(jumps)},
            {"one-cell bricks", randomLayout(cells)},
            {"negative coordinates", randomLayout(negative)},
            {"coordinate limit", edge},
            {"coarsest levels", coarse}};
}

} // namespace brickwall
