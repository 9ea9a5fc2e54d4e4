// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/VdbLeaves.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/PresentCells.h"
#include "brickwall/core/model/BrickBuilder.h"
#include "brickwall/core/model/MergeBoxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <memory>
#include <utility>

namespace brickwall {
namespace {

using openvdb::Coord;
using openvdb::CoordBBox;
using openvdb::MaskTree;

vec3i toVec(const Coord& c)
{
    return {c.x(), c.y(), c.z()};
}

void checkLimits(const VdbMask& mask, const std::string& place)
{
    CoordBBox box;
    if (!mask.active.evalActiveVoxelBoundingBox(box))
        return;
    const std::int64_t limit = coordinateLimit >> mask.level.level;
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t low = std::int64_t(box.min()[axis]) + mask.level.shift[axis];
        const std::int64_t high = std::int64_t(box.max()[axis]) + mask.level.shift[axis];
        if (low < -limit || high >= limit)
            throw Error(place,
                        fmt::format("expected voxels within +-{} from the origin of the coarsest grid, found {} to {} "
                                    "along {}",
                                    limit, low, high, "xyz"[axis]));
    }
}

/// Calls body(box) for each active voxel and tile.
template <class Body>
void forEachActive(const MaskTree& mask, const Body& body)
{
    CoordBBox box;
    for (auto it = mask.cbeginValueOn(); it; ++it) {
        it.getBoundingBox(box);
        body(box);
    }
}

/// The voxels of the next coarser level that a mask touches.
void addTouched(const MaskTree& fine, const VdbLevel& from, const VdbLevel& to, MaskTree& touched)
{
    openvdb::tree::ValueAccessor<MaskTree> accessor(touched);
    const auto coarse = [&](const Coord& c) {
        const Coord shifted = c + from.shift;
        return Coord(shifted.x() >> 1, shifted.y() >> 1, shifted.z() >> 1) - to.shift;
    };
    forEachActive(fine, [&](const CoordBBox& box) {
        const CoordBBox parents(coarse(box.min()), coarse(box.max()));
        if (parents.min() == parents.max())
            accessor.setValueOn(parents.min());
        else
            touched.sparseFill(parents, true, true);
    });
}

/// The eight voxels of the next finer level in each of a mask's.
MaskTree::Ptr childrenOf(const MaskTree& coarse, const VdbLevel& from, const VdbLevel& to)
{
    const auto children = std::make_shared<MaskTree>(false);
    const auto lower = [&](const Coord& c) {
        const Coord shifted = c + from.shift;
        return Coord(shifted.x() * 2, shifted.y() * 2, shifted.z() * 2) - to.shift;
    };
    forEachActive(coarse, [&](const CoordBBox& box) {
        children->sparseFill(CoordBBox(lower(box.min()), lower(box.max()).offsetBy(1)), true, true);
    });
    return children;
}

/// The leaf voxels of a level: those of its own, and those that are left of coarser ones which are covered in part.
/// There are no tiles in the latter, as each coarser voxel has lost a part.
struct Leaves
{
    MaskTree::Ptr own;
    MaskTree::Ptr filler;
};

std::vector<Leaves> leavesOf(const std::vector<VdbMask>& masks, Progress& progress)
{
    std::vector<MaskTree> touched(masks.size(), MaskTree(false));
    for (std::size_t l = 0; l + 1 < masks.size(); ++l) {
        progress.check();
        addTouched(masks[l].active, masks[l].level, masks[l + 1].level, touched[l + 1]);
        addTouched(touched[l], masks[l].level, masks[l + 1].level, touched[l + 1]);
    }
    std::vector<Leaves> leaves(masks.size());
    auto filler = std::make_shared<MaskTree>(false); // of the level at hand, before what is touched is left out
    for (std::size_t l = masks.size(); l-- > 0;) {
        progress.check();
        MaskTree split = masks[l].active;
        split.topologyUnion(*filler);
        split.topologyIntersection(touched[l]);
        leaves[l].own = std::make_shared<MaskTree>(masks[l].active);
        leaves[l].own->topologyDifference(touched[l]);
        filler->topologyDifference(masks[l].active);
        filler->topologyDifference(touched[l]);
        leaves[l].filler = filler;
        if (l > 0)
            filler = childrenOf(split, masks[l].level, masks[l - 1].level);
    }
    return leaves;
}

void appendVoxels(const MaskTree& mask, const VdbLevel& level, std::vector<Brick>& bricks)
{
    const vec3i shift = toVec(level.shift);
    for (auto leaf = mask.cbeginLeaf(); leaf; ++leaf) {
        if (leaf->isEmpty())
            continue; // may be farther away than coordinates reach
        const vec3i lower = toVec(leaf->origin()) + shift;
        appendPresent(
            {lower, lower + int(MaskTree::LeafNodeType::DIM)}, level.level,
            [&](const vec3i& c) { return leaf->isValueOn(Coord(c.x, c.y, c.z) - level.shift); }, bricks);
    }
}

/// Tiles as cells, where they may be; the others are made voxels in the mask.
void appendTiles(MaskTree& mask, const VdbLevel& level, const std::string& place, std::vector<Brick>& bricks)
{
    std::vector<CoordBBox> misaligned;
    double filled = 0.0;
    auto it = mask.cbeginValueOn();
    it.setMaxDepth(MaskTree::ValueOnCIter::LEAF_DEPTH - 1);
    for (; it; ++it) {
        if (it.isVoxelValue())
            continue;
        CoordBBox box;
        it.getBoundingBox(box);
        const int width = box.dim().x();
        const int tileLevel = level.level + std::countr_zero(static_cast<unsigned>(width));
        const vec3i cell = toVec(box.min() + level.shift);
        if (tileLevel <= maxLevel && cell % width == vec3i(0))
            bricks.push_back({cell * (1 << level.level), vec3i(1), tileLevel, 0});
        else {
            misaligned.push_back(box);
            filled += volumeOf(box);
        }
    }
    if (misaligned.empty())
        return;
    checkExpansion(filled, storedCount(mask), place);
    for (const CoordBBox& box : misaligned)
        mask.denseFill(box, true, true);
}

void checkCount(double cells, const std::string& place)
{
    if (cells >= 0x1p32)
        throw Error(place, fmt::format("expected fewer than 2^32 cells, found {}", cells));
}

} // namespace

std::uint64_t storedCount(const MaskTree& mask)
{
    return mask.activeLeafVoxelCount() + mask.activeTileCount();
}

double volumeOf(const CoordBBox& box)
{
    double volume = 1.0;
    for (int axis = 0; axis < 3; ++axis)
        volume *= double(box.max()[axis]) - box.min()[axis] + 1.0;
    return volume;
}

void checkExpansion(double cells, std::uint64_t stored, const std::string& place)
{
    checkCount(cells, place);
    const double most = std::max(0x1p24, 1000.0 * double(stored));
    if (cells > most)
        throw Error(place,
                    fmt::format("expected at most {} cells to be filled by {} active voxels and tiles (a thousand "
                                "by each, or 2^24), found {}",
                                most, stored, cells));
}

LeafPlan vdbLeaves(std::vector<VdbMask> masks, bool tiles, const std::string& place, Progress& progress)
{
    progress.begin("leaving out covered cells", 0);
    LeafPlan plan;
    std::uint64_t stored = 0;
    double cells = 0.0;
    for (const VdbMask& mask : masks) {
        checkLimits(mask, place);
        plan.coveredCells += mask.active.activeVoxelCount();
        stored += storedCount(mask.active);
        cells += double(tiles ? storedCount(mask.active) : mask.active.activeVoxelCount());
    }
    if (stored == 0)
        throw Error(place, "expected active voxels, found none");
    checkExpansion(cells, stored, place);
    std::vector<Leaves> leaves = leavesOf(masks, progress);
    for (std::size_t l = 0; l < masks.size(); ++l) {
        progress.check();
        plan.coveredCells -= leaves[l].own->activeVoxelCount();
        if (tiles)
            appendTiles(*leaves[l].own, masks[l].level, place, plan.bricks);
        else
            leaves[l].own->voxelizeActiveTiles();
        appendVoxels(*leaves[l].own, masks[l].level, plan.bricks);
        appendVoxels(*leaves[l].filler, masks[l].level, plan.bricks);
    }
    mergeBoxes(plan.bricks, BrickBuilderConfig{}.maxBrickWidth, progress);
    plan.cellCount = plan.bricks.back().begin + plan.bricks.back().cellCount();
    checkCount(double(plan.cellCount), place);
    progress.end();
    return plan;
}

} // namespace brickwall
