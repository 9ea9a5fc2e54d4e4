// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Box.h"

#include <functional>
#include <string>
#include <vector>

namespace brickwall::oracles {

/// A Chombo file to be written; levels go from coarse to fine as in the format, boxes are in their level's own indices
/// with the upper corner exclusive.
struct Chombo3
{
    std::vector<std::string> components{"density"};
    std::vector<std::vector<Box3i>> boxes{{{{0, 0, 0}, {8, 8, 8}}}};
    std::vector<int> ratios; ///< one per level but the finest
    double cellSize = 1.0;   ///< of level 0
    /// A cell's value; ghost cells are written as NaN.
    std::function<double(int level, int component, const vec3i& cell)> value = [](int, int, const vec3i&) {
        return 0.0;
    };

    vec3i ghosts{0};
    bool outputGhost = true;   ///< whether the attribute of that name is written
    bool offsets = true;       ///< whether the list of offsets is written
    bool vectorRatios = false; ///< vec_ref_ratio in place of ref_ratio
    bool floats = false;
    /// Written if not empty: PLUTO's attributes domBeg1 to domBeg3, and how much wider cells are along y and z.
    std::vector<double> plutoOrigin, plutoStretch;
    int plutoGeometry = 1;
};

/// Throws Error if it cannot.
void writeChombo(const std::string& path, const Chombo3& chombo);

} // namespace brickwall::oracles
