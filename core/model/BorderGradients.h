// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/BrickIndex.h"
#include "brickwall/core/model/Model.h"

#include <array>
#include <cstddef>
#include <span>
#include <vector>

namespace brickwall {

/// Up to three fields of a model, by their values.
using FieldValues = std::span<const std::span<const float>>;

/// Gradients at the centres of cells beside another level, a hole or the end of the data, where central differences
/// lack a neighbour: of the quadratic polynomial that takes the cell's own value and fits the leaf cells around it
/// best, whatever their levels. Second order on all layouts; exact for quadratic fields. Where there are too few cells
/// for a quadratic (a layer of two cells) it is of first order, and 0 along an axis along which there is nothing else.
///
/// The cells around: in each of the 26 boxes of the cell's own size next to it, the finer cells as their mean, the cell
/// of the same level, or the coarser one that has it; and two widths away, opposite to where there is nothing. Weights
/// fall with the sixth power of the distance. Why the fit is to cells and not to B: docs/decisions/0032.
///
/// Reads the bricks and the index that it was made with; any number of threads may use it at the same time.
class BorderGradients
{
public:
    BorderGradients(std::span<const Brick> bricks, const BrickIndex& index) : bricks_(bricks), index_(index) {}

    /// The gradients per voxel of the fields, at most three, in the cell at this index of a brick.
    void at(std::size_t brick, const vec3i& cell, FieldValues fields, std::array<vec3d, 3>& gradients) const;

private:
    std::span<const Brick> bricks_;
    const BrickIndex& index_;
};

} // namespace brickwall
