// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/shade/TransferFunction.h"

#include <span>
#include <vector>

namespace brickwall {

// Ready-made parts of transfer functions.

/// A colour map that is flat around each of its points: it has the point's colour within half of `width` (in t) to
/// either side, runs linearly from there to the next point, and is flat beyond the first and the last one. Neighbours
/// that are closer than `width` share what is between them: the colour steps half way, and with a large width the map
/// becomes one of steps. `points` have ascending t in [0, 1], as have the result's.
std::vector<ColorPoint> flatAround(std::span<const ColorPoint> points, float width);

/// An opacity window around an isovalue.
struct OpacityWindow
{
    double center = 0.0;  ///< c, a value
    double width = 1.0;   ///< s > 0, in values
    float opacity = 1.0f; ///< in [0, 1], of its plateau
};

/// The values that a window shows: c - 2 s to c + 2 s.
Range rangeOf(const OpacityWindow& window);

/// The points over a range of a transfer function for opacity * min(1, 1.6 exp(-(v - c)^2 / (2 s^2))) inside of c - 2 s
/// to c + 2 s, nothing outside: a plateau from c - 0.97 s to c + 0.97 s, flanks that the points meet within 2e-4, and
/// steps at the window's ends. What lies outside of the range is left out.
std::vector<OpacityPoint> opacityPoints(const OpacityWindow& window, const Range& range, Scale scale);

} // namespace brickwall
