// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Regions.h"

namespace brickwall {

/// Lanes index the cells of one brick with 32 bits. Throws Error if a padded brick has more than 2^31 - 1 cells.
void checkBrickSizes(const RegionTree& tree);

} // namespace brickwall
