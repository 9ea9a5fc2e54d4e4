// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/shade/TransferIntegral.h"

#include <vector>

namespace brickwall {

/// Fills what the queries of a TransferIntegral need, from its range, scale, knots and segments; `steps` says which
/// segments begin with a step.
void tabulateQueries(TransferIntegral& integral, const std::vector<bool>& steps);

/// What the queries of a TransferIntegral say of one range. All at once they cost half of one after the other, as the
/// ends of the range have to be found.
struct TransferLimits
{
    float extinction = 0.0f;   ///< largestExtinction
    float variation = 0.0f;    ///< largestVariation; 0 without extinction
    float logVariation = 0.0f; ///< largestLogVariation; 0 without extinction
};

TransferLimits limitsOver(const TransferIntegral& integral, const Range& range);

} // namespace brickwall
