// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Box.h"

#include <functional>
#include <string>
#include <vector>

namespace brickwall::oracles {

/// How the numbers of VTK XML pieces are written.
enum class VtkFormat { ascii, binary, appendedRaw, appendedBase64 };

struct VtkArray
{
    std::string name = "density";
    std::string type = "Float64"; ///< any number of VTK
    int components = 1;
};

/// Overlapping AMR to be written; levels go from coarse to fine, boxes are in their level's own indices with the upper
/// corner exclusive.
struct VtkAmr3
{
    std::vector<VtkArray> arrays{{}};
    std::vector<std::vector<Box3i>> boxes{{{{0, 0, 0}, {8, 8, 8}}}};
    std::vector<int> ratios; ///< one per level but the finest
    vec3d origin{0.0};
    vec3d spacing{1.0}; ///< of level 0
    std::function<double(int level, int component, const vec3i& cell)> value = [](int, int, const vec3i&) {
        return 0.0;
    };

    std::string version = "1.1"; ///< 1.0 says ratios and no place
    VtkFormat format = VtkFormat::appendedRaw;
    bool compressed = false;
    bool header64 = false;
    bool bigEndian = false;
    int blockBytes = 512; ///< of a compressed block
};

/// Writes FOLDER/NAME.vthb, and its pieces as FOLDER/NAME/NAME_0.vti and so on. Returns the path of the list. Throws
/// Error if it cannot.
std::string writeVtkAmr(const std::string& folder, const std::string& name, const VtkAmr3& amr);

} // namespace brickwall::oracles
