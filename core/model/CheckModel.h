// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Model.h"

#include <string_view>

namespace brickwall {

/// Throws Error unless the bricks are aligned, non-empty, inside coordinateLimit, contiguous in `begin`, and disjoint.
/// The message names `place` and the offending brick by its index, for an overlap both bricks. O(n log n).
void checkBricks(std::span<const Brick> bricks, std::string_view place);

/// checkBricks, and every value finite (the message names field, brick and cell), every field complete, the transform
/// invertible.
void checkModel(const Model& model, std::string_view place);

/// checkModel without a look at the values, for a reader that has seen that they are finite.
void checkLayout(const Model& model, std::string_view place);

} // namespace brickwall
