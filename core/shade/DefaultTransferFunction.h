// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Model.h"
#include "brickwall/core/shade/CellSample.h"
#include "brickwall/core/shade/TransferFunction.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace brickwall {

/// The largest mean optical depth that a default gives a ray as long as the diagonal of the data's bounds.
inline constexpr double defaultOpticalDepth = 1.2;

struct DefaultChoice
{
    TransferFunction tf;
    std::string explanation; ///< one line for the user: the range, why it is logarithmic, what is transparent
};

/// A transfer function that shows something of data nobody has looked at yet.
///
/// Range: the field's preferredRange, otherwise all values; few outliers (0.1 % of the cells) that would take more than
/// two thirds of it are left out. Logarithmic if it is positive and spans more than 3 decades. Opacity: the rarer a
/// value is, by volume, the more opaque; the most common ones, the background, are nearly transparent, wherever in the
/// range they are. Scaled to defaultOpticalDepth, or less where what is shown fills so little of the data that it would
/// become a wall; size and resolution do not matter. Looks at about a million cells, always the same ones. Throws Error
/// for a field without values and for an unknown colour map.
DefaultChoice chooseTransferFunction(const Model& model, const Field& field,
                                     std::string_view colorMapName = "Cool Warm");

/// The same for cells that have been sampled already, sampledForDefault or all there are: the field's values are not
/// looked at, and its range is known.
DefaultChoice chooseTransferFunction(const Model& model, const Field& field, std::span<const SampledCell> sample,
                                     std::string_view colorMapName);

/// How many cells a default looks at.
inline constexpr std::uint64_t sampledForDefault = 1000000;

/// The optical depth of a ray through the whole data, on average: the mean extinction over the box of the bricks (holes
/// count as transparent) times the box's diagonal, in finest cells.
double meanOpticalDepth(const Model& model, const Field& field, const TransferFunction& tf);

} // namespace brickwall
