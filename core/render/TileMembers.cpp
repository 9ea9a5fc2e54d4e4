// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/TileMembers.h"

#include <algorithm>
#include <cmath>

namespace brickwall {

TileMembers::TileMembers(const ViewRays& rays, const TilePixels& pixels, const std::vector<int>& levels,
                         float cellPixels)
    : rays_(rays), pixels_(pixels)
{
    for (const int level : levels)
        widths_.push_back(double(1 << level) / cellPixels);
}

float TileMembers::shareOfCoarser(std::size_t m, int ray, float t0, float t1) const
{
    if (m == widths_.size())
        return 0.0f;
    const double middle = rays_.pixelWidthAt(ray, 0.5 * (double(t0) + double(t1)), pixels_);
    const double octave = 1.0 + std::log2(middle / widths_[m]); // the last one before the section's end: 0 to 1
    return static_cast<float>(std::clamp(2.0 * octave - 0.5, 0.0, 1.0));
}

TileSection TileMembers::section(std::size_t m, const RayTile& tile) const
{
    TileSection s{tile, tile, {}, false, false};
    for (int i = 0; i < tile.count; ++i) {
        const auto at = [&](std::size_t member) {
            return std::clamp(rays_.whereWide(i, widths_[member], pixels_), tile.tNear[i], tile.tFar[i]);
        };
        const float t0 = m == 0 ? tile.tNear[i] : at(m - 1), t1 = m == widths_.size() ? tile.tFar[i] : at(m);
        const float share = t0 < t1 ? shareOfCoarser(m, i, t0, t1) : 0.0f;
        s.share[i] = share;
        s.finer.tNear[i] = t0;
        s.finer.tFar[i] = share < 1.0f ? t1 : t0;
        s.coarser.tNear[i] = t0;
        s.coarser.tFar[i] = share > 0.0f ? t1 : t0;
        s.anyFiner = s.anyFiner || s.finer.tFar[i] > t0;
        s.anyCoarser = s.anyCoarser || s.coarser.tFar[i] > t0;
    }
    return s;
}

void mix(const TileSection& section, const TileResult& coarser, TileResult& finer)
{
    const auto mixed = [&](const RayTile::PerRay<float>& b, RayTile::PerRay<float>& a) {
        for (int i = 0; i < section.finer.count; ++i)
            a[i] += section.share[i] * (b[i] - a[i]);
    };
    for (int c = 0; c < 3; ++c)
        mixed(coarser.color[c], finer.color[c]);
    mixed(coarser.transmittance, finer.transmittance);
    mixed(coarser.weightedDistance, finer.weightedDistance);
    mixed(coarser.error, finer.error);
}

} // namespace brickwall
