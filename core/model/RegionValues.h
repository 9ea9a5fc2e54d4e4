// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Regions.h"

namespace brickwall {

/// Finds the ranges and slopes of all regions from the padded values, which are there. Progress counts regions; the
/// stage is begun by the caller. Throws Cancelled.
void findRegionValues(const RegionTree& tree, const Executor& executor, Progress& progress, PaddedField& padded);

} // namespace brickwall
