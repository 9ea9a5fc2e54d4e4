// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/ArrayFields.h"
#include "brickwall/core/io/LevelBoxes.h"

#include <string>
#include <vector>

namespace brickwall {

/// What a `.vthb` or `.vth` file lists: levels from coarse to fine, each with boxes and the files of their values.
struct VtkLevels
{
    std::string place;
    std::vector<BoxLevel> boxes;
    std::vector<std::vector<std::string>> files; ///< one per box
    mat4d worldFromVoxel{1.0};
    std::vector<ArrayField> fields; ///< of the first piece
};

/// Reads the list of either version (1.0 says ratios, 1.1 origin and spacings) and the head of the first piece, whose
/// origin and spacing have more digits. Boxes without a file have no data and are left out. Throws Error for two
/// dimensions, levels that are missing or of other ratios than powers of two, files outside the data set's folder, and
/// a first piece that does not lie where the list says.
VtkLevels readVtkLevels(const std::string& path);

} // namespace brickwall
