// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <array>

namespace brickwall {

/// A cubic on [0, 1], by its Bernstein coefficients.
using Cubic = std::array<double, 4>;

/// B = n / d along one piece of a ray. n and d are sums over the same cells with weights >= 0, of values less a
/// reference and of 1; d > 0 inside the piece, or zero all over where no tent reaches.
struct PieceQuotient
{
    Cubic n{};
    Cubic d{1.0, 1.0, 1.0, 1.0};
    double largest = 0.0; ///< |value less reference| of the cells

    /// Where all tents end, n and d both vanish: divides both by their common factors there, so that they say what B
    /// tends to.
    void reduce();
    /// After that: no tent reaches the piece.
    bool hole() const { return !(d[0] > 0.0 && d[3] > 0.0); }
};

/// On which side of a surface a ray is: carried from the end of a piece to the start of the next, so that a root that
/// rounding puts between them is found once.
struct SurfaceSide
{
    bool known = false; ///< false at a ray's start and behind a hole
    int sign = 0;       ///< of B - c; 0: on the surface, which has been counted
};

/// Where in [0, 1] a piece meets B = c, ascending; every connected part of { B = c } counts once, at its first point,
/// and not again if `side` says that it has been counted.
struct PieceRoots
{
    int count = 0;
    std::array<double, 4> at{};
};

/// `piece` is reduced and no hole, `value` is c less the reference. |B - c| <= tolerance counts as zero at ends and at
/// extrema of n - c d: what rounding cannot tell from a touch. `side` is moved from the start to the end of the piece.
PieceRoots findRoots(const PieceQuotient& piece, double value, double tolerance, SurfaceSide& side);

double evaluate(const Cubic& cubic, double x);

} // namespace brickwall
