// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/Hdf5File.h"
#include "brickwall/core/io/LevelBoxes.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace brickwall {

/// One field of a Chombo file: a component of a LevelData, which is a dataset "ARRAY:datatype=0" in each level's group.
struct ChomboField
{
    std::string name;
    std::string array;
    std::int64_t component = 0;
};

/// The boxes of all levels, coarse to fine as in the file, and where voxels are.
struct ChomboLevels
{
    std::vector<BoxLevel> boxes;     ///< `place` is the level's list of boxes
    std::vector<std::string> groups; ///< "level_0"
    mat4d worldFromVoxel{1.0};
};

/// Where the boxes of one LevelData lie in its dataset: `offsets[i]` numbers from its beginning, component after
/// component, each over the box and `ghosts` cells around it.
struct ChomboArray
{
    Hdf5Data values;
    std::int64_t components = 0;
    vec3i ghosts{0};
    std::vector<std::uint64_t> offsets;
};

/// Source: the Chombo design document, "Chombo HDF5 file format"; what codes write was looked up in their files. All
/// throw Error with file and object for what is missing or contradicts itself, two dimensions among it.
std::vector<ChomboField> readChomboFields(const Hdf5File& file);
/// Boxes, refinement ratios, and cell sizes, which have to fit the ratios. The corner of cell (0,0,0) is at (0,0,0), or
/// where PLUTO's `domBeg1` to `domBeg3` or `prob_lo` say.
ChomboLevels readChomboLevels(const Hdf5File& file);
ChomboArray openChomboArray(const Hdf5File& file, const ChomboLevels& levels, std::size_t level,
                            const std::string& array);

} // namespace brickwall
