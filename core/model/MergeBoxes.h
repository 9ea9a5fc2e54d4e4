// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Progress.h"
#include "brickwall/core/model/Model.h"

#include <vector>

namespace brickwall {

/// Joins disjoint same-level bricks that lie behind one another along `axis` with equal cross-sections, as long as the
/// result is at most maxWidth cells long. Ignores `begin`. Returns whether anything was joined.
bool mergeAlong(std::vector<Brick>& bricks, int axis, int maxWidth);

/// mergeAlong over all axes until nothing changes, then the bricks in the order of level, z, y, x, with `begin` set.
void mergeBoxes(std::vector<Brick>& bricks, int maxWidth, Progress& progress);

} // namespace brickwall
