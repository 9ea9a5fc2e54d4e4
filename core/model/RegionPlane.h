// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/RegionLeaf.h"

#include <cstdint>
#include <span>
#include <vector>

namespace brickwall {

/// Where to split a node; axis -1 if no candidate lies strictly inside.
struct SplitPlane
{
    int axis = -1;
    int position = 0; ///< half voxels
};

/// Chooses the planes of the region tree. Candidates are the faces of the supports: they cut off the zone around a
/// change of level exactly. Where only one level is left, the bricks' faces and the planes through the outermost cell
/// centres join them, which part bricks from each other and from holes.
///
/// A plane costs what its sides do, weighted by their areas (the surface-area heuristic: how often rays cross them).
/// With many bricks a side's cost is bricks x levels, where a brick counts if one of its cell centres lies on that
/// side: a plane between the last centres of two neighbours parts them for nothing, because padding bridges that gap.
/// With few bricks each side is looked at: is it a leaf already, and of which kind.
///
/// Holds scratch memory: one chooser per thread.
class RegionPlaneChooser
{
public:
    explicit RegionPlaneChooser(std::span<const half::Support> supports) : supports_(supports) {}

    /// `oneLevel`: all listed bricks have the same level. `balance`: halve the list, whatever the cost (bounds the
    /// depth).
    SplitPlane choose(const Box3i& box, std::span<const std::uint32_t> bricks, bool oneLevel, bool balance);

private:
    struct LevelSpan
    {
        int level;
        Box3i box;
    };

    void collectLevels(std::span<const std::uint32_t> bricks);
    void collectAxis(const Box3i& box, std::span<const std::uint32_t> bricks, int axis, bool oneLevel);
    double costOfMany(const Box3i& lower, const Box3i& upper, int axis, std::size_t countLower,
                      std::size_t countUpper) const;
    double costOfFew(const Box3i& side, std::span<const std::uint32_t> bricks) const;
    int levelsBelow(int axis, int plane) const;
    int levelsAbove(int axis, int plane) const;

    std::span<const half::Support> supports_;
    std::vector<LevelSpan> levels_;
    std::vector<int> candidates_;
    std::vector<int> starts_; ///< of the bricks' first cell centres, sorted
    std::vector<int> ends_;   ///< of the bricks' last cell centres, sorted
};

} // namespace brickwall
