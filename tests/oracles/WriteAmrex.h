// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Box.h"

#include <functional>
#include <string>
#include <vector>

namespace brickwall::oracles {

/// A plotfile to be written; levels go from coarse to fine as in the format, boxes are in their level's own indices
/// with the upper corner exclusive.
struct Plotfile3
{
    std::vector<std::string> components{"density"};
    Box3i domain{{0, 0, 0}, {8, 8, 8}}; ///< of level 0
    std::vector<int> ratios;            ///< one per level but the finest
    std::vector<std::vector<Box3i>> boxes{{domain}};
    vec3d lower{0.0};
    vec3d cellSize{1.0}; ///< of level 0
    /// A cell's value; ghost cells are written as NaN.
    std::function<double(int level, int component, const vec3i& cell)> value = [](int, int, const vec3i&) {
        return 0.0;
    };

    bool floats = false;
    bool bigEndian = false;
    int ghosts = 0;
    int boxesPerFile = 1 << 30;
    bool oneRatioForAll = false;
    std::string version = "HyperCLaw-V1.1";
};

/// Makes `folder`, with Header, Level_N/Cell_H and Level_N/Cell_D_00000 and so on. Throws Error if it cannot.
void writePlotfile(const std::string& folder, const Plotfile3& plotfile);

} // namespace brickwall::oracles
