// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/model/Regions.h"
#include "brickwall/core/shade/IsoSurface.h"
#include "brickwall/core/trace/RegionBounds.h"

#include <span>
#include <vector>

namespace brickwall {

/// The nodes of `tree` for a walk that skips what the transfer function leaves transparent: leaves of regions without
/// any extinction, and inner nodes over such leaves alone, have become empty leaves. Indices stay those of the tree.
std::vector<KdNode> visibleNodes(const RegionTree& tree, std::span<const RegionBounds> bounds,
                                 const Executor& executor);

/// The nodes for a walk that looks for surfaces: leaves of regions whose range has none of their values are empty.
std::vector<KdNode> surfaceNodes(const RegionTree& tree, const PaddedField& field, std::span<const IsoSurface> surfaces,
                                 const Executor& executor);

} // namespace brickwall
