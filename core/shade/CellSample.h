// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Model.h"
#include "brickwall/core/model/Regions.h"

#include <vector>

namespace brickwall {

/// The value of a cell, and the volume (in finest cells) that it stands for.
struct SampledCell
{
    float value;
    double volume;
};

/// About `count` cells of a field, or all if there are no more: one out of every so many in the order of the bricks, at
/// a place that a hash chooses, so that no pattern of the bricks' layout comes through. Deterministic.
std::vector<SampledCell> sampleCells(const Model& model, const Field& field, std::uint64_t count);

/// The same cells from padded values of the model's bricks.
std::vector<SampledCell> sampleCells(const Model& model, const RegionTree& tree, const PaddedField& padded,
                                     std::uint64_t count);

} // namespace brickwall
