// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Regions.h"

namespace brickwall {

/// As padField of a field that stays (Regions.h), but takes the field: the memory of its values is given back piece by
/// piece while the padded ones are made, so that there are never two whole arrays.
PaddedField padField(Field&& field, std::span<const Brick> bricks, const RegionTree& tree, const Executor& executor,
                     Progress& progress);

} // namespace brickwall
