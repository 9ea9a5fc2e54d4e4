// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Model.h"

#include <functional>
#include <vector>

namespace brickwall {

/// Appends bricks of those cells of a box, in indices of its level, that are present: one if all are, else few, none if
/// none is. For blocks of up to 64 cells per axis; bricks of several blocks are joined by mergeBoxes.
void appendPresent(const Box3i& cells, int level, const std::function<bool(const vec3i& cell)>& present,
                   std::vector<Brick>& bricks);

} // namespace brickwall
