// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/ReferenceSurfaces.h"

#include <algorithm>
#include <limits>

namespace brickwall::reference {
namespace {

/// How far B - c may be off by rounding.
double noiseOf(const Piece& piece, double c)
{
    const double epsilon = std::numeric_limits<double>::epsilon();
    return 4.0 * (4.0 * epsilon + piece.positionNoise) * (piece.spread + std::abs(piece.reference - c));
}

} // namespace

SurfaceTracker::SurfaceTracker(std::span<const IsoSurface> surfaces)
    : surfaces_(surfaces), sides_(surfaces.size(), Side::unknown)
{
}

SurfaceTracker::Side SurfaceTracker::sideOf(double difference, double noise)
{
    if (std::abs(difference) <= noise)
        return Side::on;
    return difference < 0.0 ? Side::below : Side::above;
}

void SurfaceTracker::follow(const Piece& piece, std::vector<PieceHit>& hits)
{
    if (piece.hole() || piece.vanishesAtStart())
        std::fill(sides_.begin(), sides_.end(), Side::unknown);
    if (piece.hole())
        return;
    const auto first = std::ptrdiff_t(hits.size());
    for (int surface = 0; surface < int(surfaces_.size()); ++surface)
        follow(piece, surface, hits);
    std::stable_sort(hits.begin() + first, hits.end(), [](const PieceHit& a, const PieceHit& b) { return a.s < b.s; });
    if (piece.vanishesAtEnd())
        std::fill(sides_.begin(), sides_.end(), Side::unknown);
}

void SurfaceTracker::follow(const Piece& piece, int surface, std::vector<PieceHit>& hits)
{
    const double relative = double(surfaces_[surface].value) - piece.reference;
    const double noise = noiseOf(piece, surfaces_[surface].value);
    Cubic g = piece.n;
    for (int i = 0; i < 4; ++i)
        g.b[i] -= relative * piece.d.b[i];

    constexpr double tiny = std::numeric_limits<double>::min();
    Side& side = sides_[surface];
    double last = 0.0;
    const auto visit = [&](double s) {
        const Side here = sideOf(piece.relativeValue(s) - relative, noise);
        if (here == Side::on && side != Side::on)
            hits.push_back({s, surface});
        else if (here != side && side != Side::on && side != Side::unknown) {
            const double sign = here == Side::above ? 1.0 : -1.0;
            const double before = -sign * (std::abs(g(last)) + tiny), after = sign * (std::abs(g(s)) + tiny);
            hits.push_back({bracketedRoot(g, last, s, before, after), surface});
        }
        side = here;
        last = s;
    };
    if (side == Side::unknown)
        visit(0.0);
    if (piece.lo - noise <= surfaces_[surface].value && surfaces_[surface].value <= piece.hi + noise) {
        std::vector<double> extrema;
        appendSignChanges(derivative(g), extrema);
        for (double s : extrema)
            visit(s);
    }
    visit(1.0);
}

} // namespace brickwall::reference
