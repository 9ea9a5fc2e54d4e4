// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/shade/IsoSurface.h"
#include "brickwall/core/trace/ReferencePieces.h"

#include <span>
#include <vector>

namespace brickwall::reference {

struct PieceHit
{
    double s;
    int surface;
};

/// Follows on which side of each surface a ray is, from piece to piece, so that a root at a piece's end is found once.
///
/// B - c is monotonic between the ends of pieces and the extrema of N - c D; at these nodes it counts as 0 if it is no
/// larger than its rounding error. A run of zeros is one hit, at its start: a crossing at a node, a tangent ray, or a
/// stretch in which B is c throughout.
class SurfaceTracker
{
public:
    explicit SurfaceTracker(std::span<const IsoSurface> surfaces);

    /// Appends the hits in the next piece, by s.
    void follow(const Piece& piece, std::vector<PieceHit>& hits);

private:
    enum class Side { unknown, below, on, above };

    void follow(const Piece& piece, int surface, std::vector<PieceHit>& hits);
    static Side sideOf(double difference, double noise);

    std::span<const IsoSurface> surfaces_;
    std::vector<Side> sides_;
};

} // namespace brickwall::reference
