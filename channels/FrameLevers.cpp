// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/FrameLevers.h"

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

constexpr double coarsestTolerance = 0.4; ///< seen less than 6/8 of the pixels, and as fast (docs/decisions/0043)
constexpr double coarsestDt = 2.0;        ///< 5 is darker by 4 % where waves are 8 cells long
constexpr double smallestEighths = 2.0;

/// Samples per ray grow with the tolerance's inverse to this power; coarser ones save more (docs/speed-accuracy.md).
constexpr double fineExponent = 0.5, coarseExponent = 0.8, coarseFrom = 0.02;

double samplesAt(double tolerance)
{
    const double exponent = tolerance < coarseFrom ? fineExponent : coarseExponent;
    return std::pow(tolerance / coarseFrom, -exponent);
}

double toleranceWith(double samples)
{
    const double exponent = samples > 1.0 ? fineExponent : coarseExponent;
    return coarseFrom * std::pow(samples, -1.0 / exponent);
}

constexpr LeverRange imageScale{Lever::imageScale, 8.0, smallestEighths};

} // namespace

LeverTable leversForTolerance(double wanted)
{
    return {{Lever::tolerance, wanted, std::max(wanted, coarsestTolerance)}, imageScale};
}

LeverTable leversForDt(double wanted)
{
    return {{Lever::dt, wanted, std::max(wanted, coarsestDt)}, imageScale};
}

double valueOf(const FrameLevers& levers, Lever lever)
{
    switch (lever) {
    case Lever::tolerance:
        return levers.tolerance;
    case Lever::dt:
        return levers.dt;
    case Lever::imageScale:
        break;
    }
    return levers.imageEighths;
}

void setValue(FrameLevers& levers, Lever lever, double value)
{
    switch (lever) {
    case Lever::tolerance:
        levers.tolerance = value;
        return;
    case Lever::dt:
        levers.dt = value;
        return;
    case Lever::imageScale:
        levers.imageEighths = static_cast<int>(std::lround(value));
    }
}

double workAt(const LeverRange& range, double value)
{
    switch (range.lever) {
    case Lever::tolerance:
        return samplesAt(value) / samplesAt(range.finest);
    case Lever::dt:
        return range.finest / value;
    case Lever::imageScale:
        break;
    }
    return (value / range.finest) * (value / range.finest);
}

double valueWithWork(const LeverRange& range, double work)
{
    const double w = std::clamp(work, workAt(range, range.coarsest), 1.0);
    switch (range.lever) {
    case Lever::tolerance:
        return std::clamp(toleranceWith(w * samplesAt(range.finest)), range.finest, range.coarsest);
    case Lever::dt:
        return std::clamp(range.finest / w, range.finest, range.coarsest);
    case Lever::imageScale:
        break;
    }
    // What is a whole eighth but for rounding stays that.
    return std::clamp(std::floor(range.finest * std::sqrt(w) + 1e-9), range.coarsest, range.finest);
}

} // namespace brickwall
