// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/RegionBounds.h"

#include <algorithm>
#include <cmath>

namespace brickwall {

std::vector<RegionBounds> regionBounds(const PaddedField& field, const TransferIntegral& integral,
                                       const Executor& executor)
{
    std::vector<RegionBounds> bounds(field.regionRanges.size());
    executor.forEach(bounds.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Range& range = field.regionRanges[i];
            bounds[i].extinction = integral.largestExtinction(range);
            if (!(bounds[i].extinction > 0.0f))
                continue;
            const float perValue = integral.largestVariation(range), perLog = integral.largestLogVariation(range);
            bounds[i].variation = perValue;
            bounds[i].relativeVariation = std::min(perValue * std::max(std::abs(range.lo), std::abs(range.hi)), perLog);
            if (!(field.regionSlopes[i] > 0.0f)) // a step times nothing is nothing
                continue;
            bounds[i].variationAlong = perValue * field.regionSlopes[i];
            // Over several decades the largest slope and the steepest values of the function are seldom the same ones.
            if (field.regionLogSlopes[i] > 0.0f)
                bounds[i].variationAlong = std::min(bounds[i].variationAlong, perLog * field.regionLogSlopes[i]);
        }
    });
    return bounds;
}

} // namespace brickwall
