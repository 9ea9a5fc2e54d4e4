// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/SurfaceRay.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brickwall {
namespace {

/// What double leaves of |B - c| on a piece where B is c: of the order of the rounding of weights, which grows with the
/// distance from the origin.
double roundingOf(const PieceQuotient& quotient, const ExactPieces& piece, const Region& region, double value)
{
    const vec3d p = glm::max(glm::abs(piece.startPosition), glm::abs(piece.endPosition));
    const double cells = std::max({p.x, p.y, p.z}) / (2 << region.finestLevel);
    return std::numeric_limits<double>::epsilon() * (16.0 + 2.0 * cells) * (quotient.largest + std::abs(value));
}

} // namespace

SurfaceRay::SurfaceRay(const TraceScene& scene, std::span<const IsoSurface> surfaces, bool headlight)
    : scene_(scene), surfaces_(surfaces), headlight_(headlight), sides_(surfaces.size())
{
}

void SurfaceRay::begin(const RayTile& rays, int ray)
{
    ray_ = ExactRay(rays, ray, scene_.origin);
    worldStretch_ = rays.worldStretch[ray];
    doneUntil_ = -std::numeric_limits<double>::infinity();
    transmittance_ = 1.0;
    std::fill(sides_.begin(), sides_.end(), SurfaceSide{});
    hits.clear();
}

bool SurfaceRay::search(std::uint32_t index, double from, double to)
{
    const Region& region = scene_.regions->regions[index];
    for (ExactPieces piece(region, ray_, std::max(from, doneUntil_)); !piece.done() && piece.start <= to; piece.next())
        if (!visit(piece, region))
            return false;
    return true;
}

bool SurfaceRay::visit(const ExactPieces& piece, const Region& region)
{
    ++counts.samples;
    counts.fetches += region.brickCount;
    const double reference = surfaces_.front().value;
    const PieceQuotient quotient =
        quotientOf(*scene_.regions, region, scene_.field->values.data(), piece, ray_, reference);
    roots_.clear();
    if (quotient.hole())
        std::fill(sides_.begin(), sides_.end(), SurfaceSide{});
    for (std::size_t i = 0; i < surfaces_.size() && !quotient.hole(); ++i) {
        const double value = surfaces_[i].value - reference;
        const double rounding = roundingOf(quotient, piece, region, value);
        if (isTorn(piece, quotient, value, rounding, sides_[i]))
            sides_[i] = {};
        const PieceRoots found = findRoots(quotient, value, rounding, sides_[i]);
        for (int r = 0; r < found.count; ++r)
            roots_.push_back({found.at[r], static_cast<std::int32_t>(i)});
    }
    doneUntil_ = piece.end;
    lastValue_ = quotient.n[3] / quotient.d[3];
    return roots_.empty() || accept(piece, region);
}

/// Does B at the start of the piece have nothing to do with B where the ray was last? Where supports only touch, B
/// jumps; what was left out in between has none of the surfaces, but it may have been a hole, or have had such a jump.
bool SurfaceRay::isTorn(const ExactPieces& piece, const PieceQuotient& quotient, double value, double rounding,
                        const SurfaceSide& before) const
{
    if (!before.known)
        return false;
    const double first = quotient.n[0] / quotient.d[0];
    const double least = 1e-9 * (quotient.largest + std::abs(value)) + 1e3 * rounding;
    if (piece.start == doneUntil_)
        return std::abs(first - lastValue_) > least;
    const bool sameSide = before.sign * (first - value) > rounding;
    return !sameSide && ((std::abs(first - value) > least && std::abs(lastValue_ - value) > least) ||
                         hasHole(0, doneUntil_, piece.start));
}

bool SurfaceRay::accept(const ExactPieces& piece, const Region& region)
{
    std::stable_sort(roots_.begin(), roots_.end(), [](const Root& a, const Root& b) { return a.x < b.x; });
    for (const Root& root : roots_) {
        const IsoSurface& surface = surfaces_[root.surface];
        SurfaceHit hit{std::min(piece.start + root.x * (piece.end - piece.start), piece.end), root.surface};
        if (headlight_) {
            const vec3d position = glm::mix(piece.startPosition, piece.endPosition, root.x);
            light(hit, gradientAt(*scene_.regions, region, scene_.field->values.data(), piece, ray_, position,
                                  surface.value));
        }
        hits.push_back(hit);
        transmittance_ *= 1.0 - surface.opacity;
        if (transmittance_ <= 1e-6)
            return false;
    }
    return true;
}

/// Is there a stretch of [t0, t1] without any region?
bool SurfaceRay::hasHole(std::uint32_t index, double t0, double t1) const
{
    if (!(t0 < t1))
        return false;
    const KdNode& node = scene_.regions->nodes[index];
    if (node.axis == 3)
        return node.child == KdNode::emptyLeaf;
    const double t = ray_.time(node.axis, node.plane);
    const std::uint32_t first = ray_.backwards(node.axis) ? 1 : 0;
    return hasHole(node.child + first, t0, std::min(t1, t)) || hasHole(node.child + (1 - first), std::max(t0, t), t1);
}

/// As Headlight in Radiance.h.
void SurfaceRay::light(SurfaceHit& hit, const vec3d& gradient) const
{
    const float span = scene_.field->range.span();
    const vec3d g = gradient * (2.0 / (span > 0.0f ? span : 1.0f));
    const std::array<float, 6>& m = scene_.gradientMetric;
    const double squared = g.x * g.x * m[0] + g.y * g.y * m[1] + g.z * g.z * m[2] +
                           2.0 * (g.x * g.y * m[3] + g.x * g.z * m[4] + g.y * g.z * m[5]);
    if (!(squared > noGradientSquared))
        return;
    const double along = 0.5 * glm::dot(g, ray_.dir);
    hit.shade = static_cast<float>(std::min(std::abs(along) / (worldStretch_ * std::sqrt(squared)), 1.0));
    hit.gradient = vec3f(0.5 * g);
}

} // namespace brickwall
