// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/RayTiles.h"
#include "brickwall/core/trace/TraceTile.h"

#include <cstddef>
#include <vector>

namespace brickwall {

/// A part of a tile's rays that is integrated in two neighbouring members of a pyramid, of which the results are mixed.
struct TileSection
{
    RayTile finer;                  ///< rays with a share below 1; the others have tNear = tFar
    RayTile coarser;                ///< rays with a share above 0
    RayTile::PerRay<float> share{}; ///< of the coarser member, in [0, 1]
    bool anyFiner = false, anyCoarser = false;
};

/// Which members of a pyramid the rays of a tile use at which distance. Member 0 is the data themselves.
///
/// Section m of a ray lies between the distances at which the cells of members m and m + 1 are `cellPixels` pixels
/// wide, and is integrated in these two: in m alone where it begins, in m + 1 alone where it ends, and changes from the
/// one to the other in the middle half of the octave of distance before its end. The share of a ray's section depends
/// on its middle, so that it changes continuously when the eye moves, also for data that are thin against their
/// distance. So cells are between 0.6 and 1.7 times as wide as wanted, as far as there are members.
class TileMembers
{
public:
    /// `levels`: of the members but the data, ascending; may be empty. Borrows what it is made from.
    TileMembers(const ViewRays& rays, const TilePixels& pixels, const std::vector<int>& levels, float cellPixels);

    std::size_t sections() const { return widths_.size() + 1; }
    TileSection section(std::size_t m, const RayTile& tile) const;

private:
    float shareOfCoarser(std::size_t m, int ray, float t0, float t1) const;

    const ViewRays& rays_;
    const TilePixels& pixels_;
    std::vector<double> widths_; ///< of a pixel, in voxels, where member m + 1 is wanted
};

/// Puts together what came of the two halves of a section, whose rays all started from the same: `finer` becomes the
/// mix.
void mix(const TileSection& section, const TileResult& coarser, TileResult& finer);

} // namespace brickwall
