// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/RegionPlane.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace brickwall {
namespace {

/// Up to this many bricks each side of each candidate is examined; more make no better trees, but take longer.
constexpr std::size_t fewBricks = 24;

double halfArea(const Box3i& box)
{
    const vec3d e(box.extent());
    return e.x * e.y + e.y * e.z + e.z * e.x;
}

/// The brick's cell centres, the upper end exclusive, so that a brick one cell wide is not empty.
Box3i centres(const half::Support& s)
{
    const int h = 2 * s.halfCell();
    const vec3i lower = s.box.lower + h;
    return {lower, glm::max(s.box.upper - h, lower + 1)};
}

} // namespace

void RegionPlaneChooser::collectLevels(std::span<const std::uint32_t> bricks)
{
    levels_.clear();
    for (const std::uint32_t b : bricks) {
        const half::Support& s = supports_[b];
        auto it = std::find_if(levels_.begin(), levels_.end(), [&](const LevelSpan& l) { return l.level == s.level; });
        if (it == levels_.end())
            it = levels_.insert(it, LevelSpan{s.level, Box3i()});
        it->box.extend(s.box);
    }
}

void RegionPlaneChooser::collectAxis(const Box3i& box, std::span<const std::uint32_t> bricks, int axis, bool oneLevel)
{
    candidates_.clear();
    starts_.clear();
    ends_.clear();
    const auto candidate = [&](int plane) {
        if (plane > box.lower[axis] && plane < box.upper[axis])
            candidates_.push_back(plane);
    };
    for (const std::uint32_t b : bricks) {
        const half::Support& s = supports_[b];
        const int steps = oneLevel ? 3 : 1;
        for (int i = 0; i < steps; ++i) {
            candidate(s.box.lower[axis] + i * s.halfCell());
            candidate(s.box.upper[axis] - i * s.halfCell());
        }
        const Box3i c = centres(s);
        if (c.overlaps(box)) {
            starts_.push_back(c.lower[axis]);
            ends_.push_back(c.upper[axis]);
        }
    }
    std::sort(candidates_.begin(), candidates_.end());
    candidates_.erase(std::unique(candidates_.begin(), candidates_.end()), candidates_.end());
    std::sort(starts_.begin(), starts_.end());
    std::sort(ends_.begin(), ends_.end());
}

int RegionPlaneChooser::levelsBelow(int axis, int plane) const
{
    return int(
        std::count_if(levels_.begin(), levels_.end(), [&](const LevelSpan& l) { return l.box.lower[axis] < plane; }));
}

int RegionPlaneChooser::levelsAbove(int axis, int plane) const
{
    return int(
        std::count_if(levels_.begin(), levels_.end(), [&](const LevelSpan& l) { return l.box.upper[axis] > plane; }));
}

double RegionPlaneChooser::costOfMany(const Box3i& lower, const Box3i& upper, int axis, std::size_t countLower,
                                      std::size_t countUpper) const
{
    const int plane = upper.lower[axis];
    const int levelsLower = levelsBelow(axis, plane), levelsUpper = levelsAbove(axis, plane);
    const double lowerBricks = std::max(double(countLower), levelsLower > 0 ? 1.0 : 0.0);
    const double upperBricks = std::max(double(countUpper), levelsUpper > 0 ? 1.0 : 0.0);
    return halfArea(lower) * lowerBricks * levelsLower + halfArea(upper) * upperBricks * levelsUpper;
}

/// In units of a single-brick region. The figures are those that gave the fewest visits per ray on octree blocks,
/// nested boxes and the sphere's bricks; they matter little.
double RegionPlaneChooser::costOfFew(const Box3i& side, std::span<const std::uint32_t> bricks) const
{
    const RegionLeaf leaf = regionLeaf(side, bricks, supports_);
    switch (leaf.kind) {
    case RegionLeaf::Kind::empty:
        return 0.0;
    case RegionLeaf::Kind::singleBrick:
        return halfArea(side);
    case RegionLeaf::Kind::sameBricks:
        return 1.5 * halfArea(side);
    case RegionLeaf::Kind::mixed:
        break;
    }
    return (3.0 + 1.5 * (leaf.brickCount - 1) * leaf.levelCount) * halfArea(side);
}

SplitPlane RegionPlaneChooser::choose(const Box3i& box, std::span<const std::uint32_t> bricks, bool oneLevel,
                                      bool balance)
{
    collectLevels(bricks);
    SplitPlane best;
    double bestCost = std::numeric_limits<double>::infinity();
    double bestOffset = bestCost;
    for (int axis = 0; axis < 3; ++axis) {
        collectAxis(box, bricks, axis, oneLevel);
        std::size_t start = 0, end = 0;
        for (const int plane : candidates_) {
            while (start < starts_.size() && starts_[start] < plane)
                ++start;
            while (end < ends_.size() && ends_[end] <= plane)
                ++end;
            const std::size_t above = ends_.size() - end;
            Box3i lower = box, upper = box;
            lower.upper[axis] = upper.lower[axis] = plane;
            const double cost = balance                      ? double(std::max(start, above))
                                : bricks.size() <= fewBricks ? costOfFew(lower, bricks) + costOfFew(upper, bricks)
                                                             : costOfMany(lower, upper, axis, start, above);
            const double offset = std::abs(double(plane) - box.lower[axis] - (double(box.upper[axis]) - plane));
            if (cost < bestCost || (cost == bestCost && offset < bestOffset)) {
                best = {axis, plane};
                bestCost = cost;
                bestOffset = offset;
            }
        }
    }
    return best;
}

} // namespace brickwall
