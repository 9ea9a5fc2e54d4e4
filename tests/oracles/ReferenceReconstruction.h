// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Model.h"

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace brickwall::oracles {

/// The reconstruction as its definition reads, in double: B = N / D, N = sum H_C v_C, D = sum H_C over all leaf cells,
/// with H_C(p) = prod_i max(0, 1 - |p_i - c_i| / w). Knows cells, and neither bricks, regions nor padding. Slow;
/// thread-safe.
class ReferenceReconstruction
{
public:
    struct Sample
    {
        double value = 0.0;
        vec3d gradient{0.0}; ///< per world unit
        double weight = 0.0; ///< D
        double kinkDistance =
            0.0;            ///< to the nearest plane through centres or faces of supports, in finest widths nearby
        bool valid = false; ///< D > 0
    };

    ReferenceReconstruction(const Model& model, const Field& field);

    /// At a point in world space. Where a tent has a kink (in the plane through its centre, at its edge), the gradient
    /// is that on the side of larger coordinates.
    Sample at(const vec3d& world) const;

    /// The same in voxel space, where the gradient is per voxel.
    Sample atVoxel(const vec3d& voxel) const;

private:
    struct KeyHash
    {
        std::size_t operator()(const vec3i& c) const;
    };
    using Level = std::unordered_map<vec3i, float, KeyHash>; ///< index of the cell on its level -> value

    std::vector<Level> levels_;
    mat4d voxelFromWorld_;
};

} // namespace brickwall::oracles
