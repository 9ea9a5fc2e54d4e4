// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/model/Regions.h"
#include "brickwall/core/shade/TransferFunction.h"

#include <vector>

namespace brickwall {

/// The nodes of `tree` for a walk that skips what the transfer function leaves transparent: leaves of regions without
/// any extinction, and inner nodes over such leaves alone, have become empty leaves. Indices stay those of the tree.
std::vector<KdNode> visibleNodes(const RegionTree& tree, const PaddedField& field, const TransferTable& table,
                                 const Executor& executor);

} // namespace brickwall
