// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/VdbFile.h"

#include <openvdb/openvdb.h>

#include <array>
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace brickwall {

/// Grids of one quantity, one per level, from fine to coarse.
struct VdbArray
{
    std::string name;
    int components = 1;
    std::vector<VdbGridInfo> grids;
};

/// The quantities of a file: grids whose names differ in a number of a level alone (velocity_L0, velocity_L1, or
/// rho_level_0) are one, as are grids of the same name, as long as their voxels differ in size. In the file's order.
std::vector<VdbArray> arraysOf(const std::vector<VdbGridInfo>& grids);

/// A grid among levels: cell (i,j,k) has its lower corner at ((i,j,k) + shift) * 2^level, in voxel space.
struct VdbLevel
{
    int level = 0;
    openvdb::Coord shift;
};

/// Where the grids of several arrays lie towards each other.
struct VdbFrame
{
    std::vector<std::vector<VdbLevel>> levels; ///< per array and grid
    int coarsest = 0;
    vec3d voxelSize{1.0}; ///< of the finest
    vec3d lower{0.0};     ///< of voxel (0,0,0), in the world
};

/// Throws Error for voxel sizes that are no powers of two times the finest one, and for grids whose voxels do not have
/// their corners where those of the coarser ones are.
VdbFrame frameOf(const std::vector<const VdbArray*>& arrays, const std::string& place);

/// The values of one grid, of whatever type. Made by one thread for itself.
class VdbValues
{
public:
    virtual ~VdbValues() = default;

    /// All components; returns whether the voxel is active.
    virtual bool at(const openvdb::Coord& voxel, std::array<double, 3>& value) = 0;
};

std::unique_ptr<VdbValues> valuesOf(const openvdb::GridBase& grid);

/// Adds the grid's active voxels, tiles as tiles where the mask has nothing finer.
void addActive(const openvdb::GridBase& grid, openvdb::MaskTree& mask);

} // namespace brickwall
