// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"

#include <openvdb/Grid.h>

#include <cstdint>
#include <string>
#include <vector>

namespace brickwall {

/// A grid of an OpenVDB file, without its values.
struct VdbGridInfo
{
    std::string name;       ///< "density", "density[1]" for a second one of that name
    std::string type;       ///< OpenVDB's, "Tree_float_5_4_3"
    std::int64_t begin = 0; ///< of its description in the file
    vec3d voxelSize{1.0};
    vec3d lower{0.0}; ///< of voxel (0,0,0), in the world
};

/// An OpenVDB file that is read grid by grid. Every error of the library is an Error that names the file. For one
/// thread.
class VdbFile
{
public:
    /// Reads what grids there are, those of other values than numbers left out. Throws Error for lists that do not fit
    /// the file, before the library is given them, and for transforms that are more than scale and translation.
    explicit VdbFile(const std::string& path);

    const std::string& path() const { return path_; }
    const std::vector<VdbGridInfo>& grids() const { return grids_; }
    /// A grid with its values.
    openvdb::GridBase::Ptr read(const VdbGridInfo& info) const;

private:
    std::string path_;
    std::vector<VdbGridInfo> grids_;
};

/// Whether the file begins as OpenVDB's do.
bool isVdb(const std::string& path);

} // namespace brickwall
