// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/BorderGradients.h"
#include "brickwall/core/model/BrickIndex.h"
#include "brickwall/core/model/Model.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <unordered_map>
#include <vector>

namespace brickwall {

/// A vector of three fields of a model between the centres of cells, in double precision: where one level alone
/// contributes and cells are all around, B; where levels meet and in the half cells at the rim of data, B of the
/// components plus their gradient times the distance of the point from where B's cells have their weighted centre. That
/// is continuous as B is, but exact for linear fields everywhere, where B is not (docs/decisions/0033): lines that
/// follow it do not drift at every crossing.
///
/// Keeps references to the model, whose values may not change. Any number of threads may sample, each with a Memo of
/// its own.
class VectorSampler
{
public:
    /// Gradients of cells that were needed, as neighbouring points need the same.
    using Memo = std::unordered_map<std::uint64_t, std::array<vec3d, 3>>;

    struct Sample
    {
        vec3d value;      ///< of the three fields, along the axes of the world
        double cellWidth; ///< of the leaf cell that has the point, per world unit along its shortest axis
    };

    /// The indices of the model's fields that are the components x, y and z.
    VectorSampler(const Model& model, const std::array<std::size_t, 3>& components);

    /// At a point in world space; nothing where there is no cell.
    std::optional<Sample> at(const vec3d& world, Memo& memo) const;

private:
    struct Sums;
    void addBrick(std::uint32_t brick, const vec3d& voxel, Sums& sums) const;
    vec3d correction(const vec3d& offset, const Sums& sums, Memo& memo) const;

    std::span<const Brick> bricks_;
    std::array<std::span<const float>, 3> values_;
    mat4d voxelFromWorld_;
    double worldPerVoxel_; ///< along the shortest axis
    BrickIndex index_;
    BrickIndex supports_; ///< in half voxels
    BorderGradients gradients_;
};

} // namespace brickwall
