// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/LevelBoxes.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/model/BrickBuilder.h"
#include "brickwall/core/model/BrickIndex.h"
#include "brickwall/core/model/LeafBoxes.h"
#include "brickwall/core/model/MergeBoxes.h"

#include <glm/gtc/matrix_transform.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <utility>

namespace brickwall {
namespace {

/// In double: a hostile box may have more cells than 64 bits can count.
double cellsIn(const Box3i& b)
{
    return (double(b.upper.x) - b.lower.x) * (double(b.upper.y) - b.lower.y) * (double(b.upper.z) - b.lower.z);
}

void checkIndices(const BoxLevel& level)
{
    const int width = 1 << level.level;
    for (std::size_t i = 0; i < level.boxes.size(); ++i) {
        const Box3i& b = level.boxes[i];
        if (b.empty())
            throw Error(level.place, fmt::format("box {} is empty", i));
        for (int axis = 0; axis < 3; ++axis)
            if (std::int64_t(b.lower[axis]) * width < -coordinateLimit ||
                std::int64_t(b.upper[axis]) * width > coordinateLimit)
                throw Error(level.place, fmt::format("box {}: expected indices within +-{}, found {} to {} along {}", i,
                                                     coordinateLimit / width, b.lower[axis],
                                                     std::int64_t(b.upper[axis]) - 1, "xyz"[axis]));
    }
}

/// Of boxes whose indices have been checked.
Box3i inVoxels(const Box3i& b, int level)
{
    return {b.lower * (1 << level), b.upper * (1 << level)};
}

OverlappingLevel inVoxels(const BoxLevel& level)
{
    OverlappingLevel out{level.place, level.level, {}};
    out.boxes.reserve(level.boxes.size());
    for (const Box3i& b : level.boxes)
        out.boxes.push_back(inVoxels(b, level.level));
    return out;
}

std::string text(const Box3i& b)
{
    return fmt::format("({},{},{}) to ({},{},{})", b.lower.x, b.lower.y, b.lower.z, b.upper.x - 1, b.upper.y - 1,
                       b.upper.z - 1);
}

void checkCount(double cells, const std::string& place)
{
    constexpr double limit = 4294967296.0;
    if (cells == 0.0)
        throw Error(place, "expected cells, found no boxes that have any");
    if (cells >= limit)
        throw Error(place, fmt::format("expected fewer than 2^32 cells that no finer level covers, found {}", cells));
}

double cellsIn(const BoxLevel& level)
{
    double cells = 0.0;
    for (const Box3i& b : level.boxes)
        cells += cellsIn(b);
    return cells;
}

/// Each cell is shown or has finer ones in it, so that there will be as many. Said before a look at how boxes lie,
/// which takes longer.
void checkCount(const BoxLevel& level, const std::string& place)
{
    if (const double cells = cellsIn(level); cells > 0.0)
        checkCount(cells, place);
}

void countCells(LeafPlan& plan, std::span<const BoxLevel> levels, const std::string& place)
{
    double cells = 0.0, all = 0.0;
    for (const LeafPiece& piece : plan.pieces)
        cells += cellsIn(piece.cells);
    checkCount(cells, place);
    for (const BoxLevel& level : levels)
        all += cellsIn(level);
    plan.cellCount = static_cast<std::uint64_t>(cells);
    plan.coveredCells = static_cast<std::uint64_t>(std::min(all - cells, 9e18));
}

/// Boxes of one level do not overlap.
void checkDisjoint(const BoxLevel& level)
{
    if (const auto pair = findOverlap(level.boxes))
        throw Error(level.place,
                    fmt::format("boxes {} and {} of one level overlap: {} and {}", pair->first, pair->second,
                                text(level.boxes[pair->first]), text(level.boxes[pair->second])));
}

/// The boxes of all levels in a row, without a copy of them.
class BoxList
{
public:
    explicit BoxList(std::span<const BoxLevel> levels) : levels_(levels)
    {
        for (const BoxLevel& level : levels)
            ends_.push_back((ends_.empty() ? 0 : ends_.back()) + level.boxes.size());
    }

    std::size_t size() const { return ends_.empty() ? 0 : ends_.back(); }
    /// In voxels.
    LeafBox leaf(std::size_t i) const
    {
        const auto end = std::upper_bound(ends_.begin(), ends_.end(), i);
        const std::size_t l = static_cast<std::size_t>(end - ends_.begin());
        const std::size_t box = i - (l > 0 ? ends_[l - 1] : 0);
        return {inVoxels(levels_[l].boxes[box], levels_[l].level), static_cast<std::uint32_t>(l),
                static_cast<std::uint32_t>(box)};
    }

private:
    std::span<const BoxLevel> levels_;
    std::vector<std::size_t> ends_; ///< one behind each level's last box
};

/// Pieces, jobs and bricks for leaves in the order of level and source.
LeafPlan planOf(std::span<const LeafBox> leaves, std::span<const BoxLevel> levels, const std::string& place,
                Progress& progress)
{
    LeafPlan plan;
    for (const LeafBox& leaf : leaves) {
        const int level = levels[leaf.levelIndex].level;
        const Box3i cells{leaf.box.lower / (1 << level), leaf.box.upper / (1 << level)};
        if (plan.jobs.empty() || plan.jobs.back().levelIndex != leaf.levelIndex || plan.jobs.back().box != leaf.source)
            plan.jobs.push_back({leaf.levelIndex, leaf.source, plan.pieces.size(), plan.pieces.size()});
        plan.pieces.push_back({cells});
        plan.jobs.back().endPiece = plan.pieces.size();
        plan.bricks.push_back({leaf.box.lower, cells.extent(), level, 0});
    }
    countCells(plan, levels, place);
    progress.begin("merging bricks", 0);
    mergeBoxes(plan.bricks, BrickBuilderConfig{}.maxBrickWidth, progress);
    const BrickIndex index(plan.bricks);
    for (std::size_t i = 0; i < leaves.size(); ++i)
        index.overlapping(leaves[i].box, [&](std::uint32_t brick, const Box3i&) { plan.pieces[i].brick = brick; });
    progress.end();
    return plan;
}

} // namespace

std::vector<int> levelNumbers(std::span<const int> ratios, const std::string& place)
{
    std::vector<int> numbers(ratios.size() + 1, 0);
    for (std::size_t i = ratios.size(); i-- > 0;) {
        if (ratios[i] < 2 || !std::has_single_bit(static_cast<unsigned>(ratios[i])))
            throw Error(place, fmt::format("expected a refinement ratio that is a power of two, found {} between "
                                           "levels {} and {}",
                                           ratios[i], i, i + 1));
        numbers[i] = numbers[i + 1] + std::countr_zero(static_cast<unsigned>(ratios[i]));
        if (numbers[i] > maxLevel)
            throw Error(place, fmt::format("expected cells at most 2^{} times as wide as the finest, found 2^{} on "
                                           "level {}",
                                           maxLevel, numbers[i], i));
    }
    return numbers;
}

void checkLevel(const BoxLevel& level)
{
    checkIndices(level);
    checkCount(level, level.place);
    checkDisjoint(level);
}

LeafPlan planLeaves(std::span<const BoxLevel> levels, const std::string& place, const Executor& executor,
                    Progress& progress)
{
    progress.begin("leaving out covered cells", 0);
    for (const BoxLevel& level : levels) {
        checkIndices(level);
        checkCount(level, place);
    }
    for (const BoxLevel& level : levels)
        checkDisjoint(level);
    std::vector<OverlappingLevel> inFinest;
    for (const BoxLevel& level : levels)
        inFinest.push_back(inVoxels(level));
    const auto leaves = leafBoxes(inFinest, executor, progress);
    progress.end();
    return planOf(leaves, levels, place, progress);
}

LeafPlan planDisjoint(std::span<const BoxLevel> levels, const std::string& place, Progress& progress)
{
    for (const BoxLevel& level : levels)
        checkIndices(level);
    const BoxList all(levels);
    if (const auto pair = findOverlap(all.size(), [&](std::size_t i) { return all.leaf(i).box; })) {
        const LeafBox a = all.leaf(pair->first), b = all.leaf(pair->second);
        throw Error(place, fmt::format("expected leaves that do not overlap, but box {} of {} and box {} of {} do",
                                       a.source, levels[a.levelIndex].place, b.source, levels[b.levelIndex].place));
    }
    double cells = 0.0;
    for (const BoxLevel& level : levels)
        cells += cellsIn(level);
    checkCount(cells, place);
    std::vector<LeafBox> leaves;
    for (std::size_t i = 0; i < all.size(); ++i)
        leaves.push_back(all.leaf(i));
    return planOf(leaves, levels, place, progress);
}

mat4d worldFromIndices(const vec3d& corner, const vec3i& index, const vec3d& cellSize)
{
    const mat4d scaled = glm::scale(glm::translate(mat4d(1.0), corner), cellSize);
    return glm::translate(scaled, -vec3d(index));
}

} // namespace brickwall
