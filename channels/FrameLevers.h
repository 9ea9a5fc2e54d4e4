// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <vector>

namespace brickwall {

/// How accurately all views of one moment are rendered: what the frame-time controller decides and a renderer takes. A
/// plain record without pointers: a master sends it to other nodes, and every eye and every screen renders with the
/// same one.
struct FrameLevers
{
    double tolerance = 1.0 / 255.0; ///< of the bounded method
    double dt = 0.5;                ///< of the methods that take steps
    int imageEighths = 8;           ///< the image's width and height, in eighths of the channel's; 1 to 8

    bool operator==(const FrameLevers&) const = default;
};

enum class Lever { tolerance, dt, imageScale };

/// A lever, and how far it may be moved: from what the user wants to the coarsest setting that is still worth showing.
struct LeverRange
{
    Lever lever = Lever::tolerance;
    double finest = 0.0; ///< value in a FrameLevers; for imageScale in eighths
    double coarsest = 0.0;

    bool operator==(const LeverRange&) const = default;
};

/// The levers that there are, in the order of their use: the first one is moved first, and the last is the first to be
/// given back. One that a renderer does not have is not in the table.
using LeverTable = std::vector<LeverRange>;

/// Tolerance, or dt, then the image's scale.
LeverTable leversForTolerance(double wanted);
LeverTable leversForDt(double wanted);

double valueOf(const FrameLevers& levers, Lever lever);
void setValue(FrameLevers& levers, Lever lever, double value);

/// What a frame has to do at a value, as a part of what it has to do at the finest one; in (0, 1]. Samples per ray grow
/// as tolerance^-0.5, and as ^-0.8 where it is above 0.02 (docs/decisions/0043 has the measurements), and as 1 / dt;
/// rays as the square of the image's scale.
double workAt(const LeverRange& range, double value);
/// The finest value with no more than this work: the inverse, within the range, rounded to the cheaper eighth.
double valueWithWork(const LeverRange& range, double work);

} // namespace brickwall
