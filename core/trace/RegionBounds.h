// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/model/Regions.h"
#include "brickwall/core/shade/TransferIntegral.h"

#include <vector>

namespace brickwall {

/// How much a region can do to a ray, from its values and the transfer function alone: what the bounded method knows
/// before it has fetched a single cell.
struct RegionBounds
{
    float extinction = 0.0f; ///< the largest, per voxel
    /// How fast (c - C) sigma changes with the value, at most, per voxel, for the worst colour C behind; may be
    /// infinite.
    float variation = 0.0f;
    /// The same per share of the value: what rounding of values multiplies.
    float relativeVariation = 0.0f;
    /// The same along any ray, per voxel and voxel: a sample in the middle of a segment of length h errs by at most
    /// T variationAlong h^2 / 4.
    float variationAlong = 0.0f;
    /// How fast a component of the colour changes with the colour field's value, at most, if there is one; may be
    /// infinite.
    float colorSlope = 0.0f;
};

/// One per region.
std::vector<RegionBounds> regionBounds(const PaddedField& field, const TransferIntegral& integral,
                                       const Executor& executor);

/// Adds to the bounds of extinction in white what colours of another field of the same regions change; `colors` is the
/// integral of its colorFunction.
void addColors(std::vector<RegionBounds>& bounds, const PaddedField& colorField, const TransferIntegral& colors,
               const Executor& executor);

} // namespace brickwall
