// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/ReferenceIntegrator.h"

#include "brickwall/core/trace/ReferencePieces.h"
#include "brickwall/core/trace/ReferenceQuadrature.h"
#include "brickwall/core/trace/ReferenceSurfaces.h"
#include "brickwall/core/trace/ReferenceTransfer.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <glm/geometric.hpp>

namespace brickwall {

using namespace reference;

struct ReferenceIntegrator::Data
{
    std::span<const PaddedBrick> bricks;
    const PaddedField& field;
    TransferFunction tf;
    std::vector<IsoSurface> surfaces;
    std::array<double, 6> gradientMetric;
    bool headlight;
    Supports supports;
    Knots knots;
    const PaddedField* colorField; ///< null: `field`
    Knots colorKnots;              ///< of that field
    EmissionAbsorption emissionAbsorption;

    PieceWalk walk(const PaddedField& of, const ReferenceRay& ray) const
    {
        return {supports, bricks, of.values.data(), {ray.org, ray.dir}, ray.tNear, ray.tFar};
    }
};

namespace {

/// |cos| between gradient and ray in world space, 1 where there is no gradient to speak of.
class HeadlightOf
{
public:
    HeadlightOf(const ReferenceRay& ray, const std::array<double, 6>& metric, const Range& range)
        : ray_(ray), metric_(metric), scale_(range.span() > 0.0f ? 1.0 / (double(range.hi) - range.lo) : 1.0)
    {
    }

    double operator()(const vec3d& gradient) const
    {
        const vec3d g = gradient * scale_;
        const auto& m = metric_;
        const double squared = m[0] * g.x * g.x + m[1] * g.y * g.y + m[2] * g.z * g.z +
                               2.0 * (m[3] * g.x * g.y + m[4] * g.x * g.z + m[5] * g.y * g.z);
        if (!(squared > noGradientSquared))
            return 1.0;
        return std::min(1.0, std::abs(glm::dot(g, ray_.dir)) / (ray_.worldStretch * std::sqrt(squared)));
    }

private:
    const ReferenceRay& ray_;
    const std::array<double, 6>& metric_;
    double scale_;
};

/// Volume and surfaces of one ray, piece by piece.
template <class Data>
class RayIntegral
{
public:
    RayIntegral(const Data& data, const ReferenceRay& ray)
        : data_(data), headlight_(ray, data.gradientMetric, data.field.range)
    {
    }

    /// `colorPiece` is that of the colour field on the same stretch, or the piece itself.
    void add(const Piece& piece, const Piece& colorPiece, std::span<const PieceHit> hits)
    {
        const bool clear = !piece.constant() && data_.knots.transparent(piece.lo, piece.hi);
        if (clear && hits.empty())
            return;
        cuts_.assign({0.0, 1.0});
        if (!clear && !piece.constant())
            cutWhereNotSmooth(piece, data_.knots);
        if (!clear && data_.colorField && !colorPiece.constant())
            cutWhereNotSmooth(colorPiece, data_.colorKnots);
        for (const PieceHit& hit : hits)
            cuts_.push_back(hit.s);
        std::sort(cuts_.begin(), cuts_.end());
        auto hit = hits.begin();
        for (std::size_t i = 0; i < cuts_.size() && !collected.opaque(); ++i) {
            if (i > 0 && cuts_[i - 1] < cuts_[i])
                addVolume(piece, colorPiece, cuts_[i - 1], cuts_[i]);
            for (; hit != hits.end() && hit->s <= cuts_[i]; ++hit)
                addSurface(piece, colorPiece, *hit);
        }
    }

    Collected collected;

private:
    /// At the extrema of B, then in each monotonic part at the knots that it passes.
    void cutWhereNotSmooth(const Piece& piece, const Knots& knots)
    {
        std::vector<double> ends{0.0};
        appendSignChanges(slopeNumerator(piece.n, piece.d), ends);
        ends.push_back(1.0);
        for (std::size_t i = 1; i < ends.size(); ++i) {
            cuts_.push_back(ends[i]);
            const double va = piece.value(ends[i - 1]), vb = piece.value(ends[i]);
            for (double knot : knots.within(std::min(va, vb), std::max(va, vb))) {
                const double relative = knot - piece.reference;
                const auto f = [&](double s) { return piece.n(s) - relative * piece.d(s); };
                cuts_.push_back(bracketedRoot(f, ends[i - 1], ends[i], va - knot, vb - knot));
            }
        }
    }

    /// The colours of a stretch without knots, by s.
    auto colorsOf(const Piece& piece, double a, double b) const
    {
        const bool constant = piece.constant();
        const double throughout = data_.colorKnots.snapped(piece.value(0.5 * (a + b)), piece.rounding());
        return [this, &piece, constant, throughout](double s) {
            return colorAt(data_.tf, constant ? throughout : piece.value(s));
        };
    }

    void addVolume(const Piece& piece, const Piece& colorPiece, double a, double b)
    {
        // B may be just a knot throughout, where rounding must not decide between the sides of a step.
        const bool constant = piece.constant();
        const double middle = piece.value(0.5 * (a + b)), throughout = data_.knots.snapped(middle, piece.rounding());
        const auto color = colorsOf(colorPiece, a, b);
        const auto medium = [&](double s) -> Medium {
            const double value = constant ? throughout : piece.value(s);
            const double extinction = extinctionAt(data_.tf, value);
            if (!(extinction > 0.0))
                return {0.0, vec3d(0.0)};
            const double shade = data_.headlight ? headlight_(piece.gradient(s)) : 1.0;
            return {extinction, color(s) * shade};
        };
        if (!constant && data_.knots.transparent(middle, middle))
            return;
        data_.emissionAbsorption.add(medium, piece.t0, piece.length(), a, b, collected);
    }

    void addSurface(const Piece& piece, const Piece& colorPiece, const PieceHit& hit)
    {
        const IsoSurface& surface = data_.surfaces[hit.surface];
        const double shade = data_.headlight ? headlight_(piece.gradient(hit.s)) : 1.0;
        const bool byField = surface.coloredByField && data_.colorField;
        const vec3d color = byField ? colorAt(data_.tf, colorPiece.value(hit.s)) : vec3d(surface.color);
        collected.addLayer(piece.t(hit.s), shade * color, surface.opacity);
    }

    const Data& data_;
    HeadlightOf headlight_;
    std::vector<double> cuts_;
};

} // namespace

ReferenceIntegrator::ReferenceIntegrator(const RegionTree& regions, const PaddedField& field,
                                         const TransferFunction& tf, std::span<const IsoSurface> surfaces,
                                         const std::array<double, 6>& gradientMetric, bool headlight,
                                         const PaddedField* colorField, double relativeTolerance)
    : data_(new Data{regions.bricks,
                     field,
                     tf,
                     {surfaces.begin(), surfaces.end()},
                     gradientMetric,
                     headlight,
                     Supports(regions.bricks),
                     Knots(tf.colorField ? extinctionFunction(tf) : tf),
                     tf.colorField ? colorField : nullptr,
                     Knots(tf.colorField ? colorFunction(tf) : tf),
                     EmissionAbsorption(relativeTolerance, Knots(tf).largestExtinction())})
{
}

ReferenceIntegrator::~ReferenceIntegrator() = default;
ReferenceIntegrator::ReferenceIntegrator(ReferenceIntegrator&&) noexcept = default;

ReferenceResult ReferenceIntegrator::integrate(const ReferenceRay& ray) const
{
    RayIntegral integral(*data_, ray);
    SurfaceTracker tracker(data_->surfaces);
    PieceWalk walk = data_->walk(data_->field, ray);
    std::optional<PieceWalk> colorWalk; // of the same bricks: it has the same stretches
    if (data_->colorField)
        colorWalk.emplace(data_->walk(*data_->colorField, ray));
    Piece piece, colorPiece;
    std::vector<PieceHit> hits;
    while (!integral.collected.opaque() && walk.next(piece)) {
        if (colorWalk)
            colorWalk->next(colorPiece);
        hits.clear();
        tracker.follow(piece, hits);
        if (!piece.hole())
            integral.add(piece, colorWalk ? colorPiece : piece, hits);
    }
    const Collected& c = integral.collected;
    return {c.color, c.transmittance, c.weightedDistance};
}

std::vector<ReferenceHit> ReferenceIntegrator::surfaceHits(const ReferenceRay& ray) const
{
    SurfaceTracker tracker(data_->surfaces);
    PieceWalk walk = data_->walk(data_->field, ray);
    Piece piece;
    std::vector<PieceHit> inPiece;
    std::vector<ReferenceHit> hits;
    while (walk.next(piece)) {
        inPiece.clear();
        tracker.follow(piece, inPiece);
        for (const PieceHit& hit : inPiece)
            hits.push_back({piece.t(hit.s), hit.surface, piece.gradient(hit.s)});
    }
    return hits;
}

void traceReference(const ReferenceIntegrator& integrator, const vec3i& origin, const RayTile& rays, TileResult& result)
{
    for (int i = 0; i < rays.count; ++i) {
        ReferenceRay ray{0.5 * vec3d(origin), vec3d(0.0), rays.tNear[i], rays.tFar[i], rays.worldStretch[i]};
        if (!(ray.tNear < ray.tFar))
            continue;
        for (int axis = 0; axis < 3; ++axis) {
            ray.org[axis] += double(rays.org[axis][i]);
            ray.dir[axis] = rays.dir[axis][i];
        }
        const ReferenceResult r = integrator.integrate(ray);
        const double before = result.transmittance[i];
        for (int c = 0; c < 3; ++c)
            result.color[c][i] += float(before * r.color[c]);
        result.weightedDistance[i] += float(before * r.weightedDistance);
        result.transmittance[i] = float(before * r.transmittance);
    }
}

} // namespace brickwall
