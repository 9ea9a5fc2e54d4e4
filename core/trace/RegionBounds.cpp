// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/RegionBounds.h"

#include "brickwall/core/shade/TransferIntegralTables.h"

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

float variationAlong(const PaddedField& field, std::size_t region, const TransferLimits& limits)
{
    if (!(field.regionSlopes[region] > 0.0f)) // a step times nothing is nothing
        return 0.0f;
    const float byValue = limits.variation * field.regionSlopes[region];
    // Over several decades the largest slope and the steepest values of the function are seldom the same ones.
    if (field.regionLogSlopes[region] > 0.0f)
        return std::min(byValue, limits.logVariation * field.regionLogSlopes[region]);
    return byValue;
}

} // namespace

std::vector<RegionBounds> regionBounds(const PaddedField& field, const TransferIntegral& integral,
                                       const Executor& executor)
{
    std::vector<RegionBounds> bounds(field.regionRanges.size());
    executor.forEach(bounds.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const Range& range = field.regionRanges[i];
            const TransferLimits limits = limitsOver(integral, range);
            bounds[i].extinction = limits.extinction;
            if (!(bounds[i].extinction > 0.0f))
                continue;
            bounds[i].variation = limits.variation;
            const float magnitude = std::max(std::abs(range.lo), std::abs(range.hi));
            bounds[i].relativeVariation = std::min(limits.variation * magnitude, limits.logVariation);
            bounds[i].variationAlong = variationAlong(field, i, limits);
        }
    });
    return bounds;
}

void addColors(std::vector<RegionBounds>& bounds, const PaddedField& colorField, const TransferIntegral& colors,
               const Executor& executor)
{
    executor.forEach(bounds.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            RegionBounds& b = bounds[i];
            const Range& all = colorField.regionRanges[i];
            const Range range{std::clamp(all.lo, colors.range.lo, colors.range.hi),
                              std::clamp(all.hi, colors.range.lo, colors.range.hi)};
            if (!(b.extinction > 0.0f) || range.lo == range.hi) // beyond the ends they do not change
                continue;
            const TransferLimits limits{1.0f, colors.largestVariation(range), colors.largestLogVariation(range)};
            b.colorSlope = limits.variation;
            b.variationAlong += b.extinction * variationAlong(colorField, i, limits);
        }
    });
}

} // namespace brickwall
