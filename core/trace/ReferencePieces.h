// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/trace/ReferencePolynomial.h"
#include "brickwall/core/trace/ReferenceSupports.h"

#include <array>
#include <span>
#include <vector>

namespace brickwall::reference {

/// The cells of one brick around a piece. Along each axis there are two, of which one may not be the brick's own.
struct CellBlock
{
    double width;
    std::array<double, 8> values;           ///< x fastest, less the piece's reference value
    std::array<std::array<bool, 2>, 3> own; ///< per axis: the lower, the upper cell
    vec3d f0, f1;                           ///< position between the two cells' centres, in [0, 1], at s = 0 and s = 1
};

/// A stretch of a ray over which B = N / D is a quotient of two cubics in s = (t - t0) / (t1 - t0): no plane through
/// cell centres and no face of a support lies inside.
///
/// The coefficients of D are never negative, and where one is 0, so is that of N: B is a rational Bezier curve with
/// non-negative weights and stays between the quotients of its coefficients.
class Piece
{
public:
    double t0 = 0.0, t1 = 0.0;
    Cubic n, d;             ///< of the values less `reference`
    double reference = 0.0; ///< one of the values
    double lo = 0.0, hi = 0.0;
    double positionNoise = 0.0; ///< of a rounded coordinate, in cell widths
    double spread = 0.0;        ///< the largest |value - reference|
    std::vector<CellBlock> blocks;

    double length() const { return t1 - t0; }
    double t(double s) const { return t0 + s * (t1 - t0); }
    bool hole() const { return dMax_ == 0.0; }
    /// But for rounding.
    bool constant() const { return hi - lo <= rounding(); }
    double rounding() const;

    /// B less `reference`; its limit at an end where D vanishes.
    double relativeValue(double s) const;
    double value(double s) const { return reference + relativeValue(s); }
    /// Per voxel; the one-sided one at the piece's ends, 0 where D vanishes.
    vec3d gradient(double s) const;

    bool vanishesAtStart() const { return d.b[0] == 0.0; }
    bool vanishesAtEnd() const { return d.b[3] == 0.0; }

    /// Sets the coefficients from the blocks, whose values are still absolute.
    void finish();

private:
    void clearVanishingEnds();
    bool flatAlong(int axis) const;

    double dMax_ = 0.0;
};

/// Walks the pieces of a ray front to back, holes between supports included.
class PieceWalk
{
public:
    PieceWalk(const Supports& supports, std::span<const PaddedBrick> bricks, const float* values, const Line& line,
              double tNear, double tFar);

    /// False at the end of the ray.
    bool next(Piece& piece);

private:
    void addBreaks(const Crossing& crossing);
    CellBlock blockOf(const PaddedBrick& brick, const vec3d& p0, const vec3d& middle, const vec3d& p1) const;

    std::span<const PaddedBrick> bricks_;
    const float* values_;
    Line line_;
    std::vector<double> breaks_;
    std::vector<Crossing> crossings_; ///< by t0
    std::vector<Crossing> active_;
    std::size_t nextBreak_ = 1, nextCrossing_ = 0;
};

} // namespace brickwall::reference
