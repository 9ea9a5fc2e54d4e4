// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/shade/TransferIntegral.h"

#include <vector>

namespace brickwall {

/// Fills what the queries of a TransferIntegral need, from its range, scale, knots and segments; `steps` says which
/// segments begin with a step.
void tabulateQueries(TransferIntegral& integral, const std::vector<bool>& steps);

} // namespace brickwall
