// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/ArrayFields.h"
#include "brickwall/core/io/Hdf5File.h"
#include "brickwall/core/io/LevelBoxes.h"

#include <cstdint>
#include <string>
#include <vector>

namespace brickwall {

/// The boxes of one step, coarse to fine as in the file, and where voxels are.
struct VtkHdfLevels
{
    std::vector<BoxLevel> boxes;     ///< `place` is the level's AMRBox
    std::vector<std::string> groups; ///< "VTKHDF/Level0"
    mat4d worldFromVoxel{1.0};
};

/// The cell data of a level: box after box, in the file's order.
struct VtkHdfArray
{
    Hdf5Data values;
    std::vector<std::uint64_t> offsets; ///< of the first cell of each box
};

/// Source: "VTKHDF File Format", versions 1.0 to 2.x, for the type OverlappingAMR. All throw Error with file and object
/// for what is missing or contradicts itself, two dimensions among it. `step` counts from 0.
std::vector<ArrayField> readVtkHdfFields(const Hdf5File& file);
/// 1 for a file without steps.
std::int64_t vtkHdfStepCount(const Hdf5File& file);
/// The time of a step; 0 if the file does not say.
double vtkHdfTime(const Hdf5File& file, std::int64_t step);
VtkHdfLevels readVtkHdfLevels(const Hdf5File& file, std::int64_t step);
VtkHdfArray openVtkHdfArray(const Hdf5File& file, const VtkHdfLevels& levels, std::size_t level,
                            const ArrayField& field, std::int64_t step);

} // namespace brickwall
