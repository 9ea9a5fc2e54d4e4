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

OverlappingLevel inVoxels(const BoxLevel& level)
{
    const int width = 1 << level.level;
    OverlappingLevel out{level.place, level.level, {}};
    out.boxes.reserve(level.boxes.size());
    for (std::size_t i = 0; i < level.boxes.size(); ++i) {
        const Box3i& b = level.boxes[i];
        for (int axis = 0; axis < 3; ++axis)
            if (std::int64_t(b.lower[axis]) * width < -coordinateLimit ||
                std::int64_t(b.upper[axis]) * width > coordinateLimit)
                throw Error(level.place, fmt::format("box {}: expected indices within +-{}, found {} to {} along {}", i,
                                                     coordinateLimit / width, b.lower[axis],
                                                     std::int64_t(b.upper[axis]) - 1, "xyz"[axis]));
        out.boxes.push_back({b.lower * width, b.upper * width});
    }
    return out;
}

void countCells(LeafPlan& plan, std::span<const BoxLevel> levels, const std::string& place)
{
    constexpr double limit = 4294967296.0;
    double cells = 0.0, all = 0.0;
    for (const LeafPiece& piece : plan.pieces)
        cells += cellsIn(piece.cells);
    if (cells == 0.0)
        throw Error(place, "expected cells, found no boxes that have any");
    if (cells >= limit)
        throw Error(place, fmt::format("expected fewer than 2^32 cells that no finer level covers, found {}", cells));
    for (const BoxLevel& level : levels)
        for (const Box3i& b : level.boxes)
            all += cellsIn(b);
    plan.cellCount = static_cast<std::uint64_t>(cells);
    plan.coveredCells = static_cast<std::uint64_t>(std::min(all - cells, 9e18));
}

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

LeafPlan planLeaves(std::span<const BoxLevel> levels, const std::string& place, const Executor& executor,
                    Progress& progress)
{
    progress.begin("leaving out covered cells", 0);
    std::vector<OverlappingLevel> inFinest;
    for (const BoxLevel& level : levels)
        inFinest.push_back(inVoxels(level));
    const auto leaves = leafBoxes(inFinest, executor, progress);
    progress.end();
    return planOf(leaves, levels, place, progress);
}

LeafPlan planDisjoint(std::span<const BoxLevel> levels, const std::string& place, Progress& progress)
{
    std::vector<LeafBox> leaves;
    std::vector<Box3i> boxes;
    for (std::size_t l = 0; l < levels.size(); ++l) {
        const OverlappingLevel level = inVoxels(levels[l]);
        for (std::size_t i = 0; i < level.boxes.size(); ++i) {
            if (level.boxes[i].empty())
                throw Error(level.place, fmt::format("box {} is empty", i));
            leaves.push_back({level.boxes[i], static_cast<std::uint32_t>(l), static_cast<std::uint32_t>(i)});
            boxes.push_back(level.boxes[i]);
        }
    }
    if (const auto pair = findOverlap(boxes)) {
        const LeafBox &a = leaves[pair->first], &b = leaves[pair->second];
        throw Error(place, fmt::format("expected leaves that do not overlap, but box {} of {} and box {} of {} do",
                                       a.source, levels[a.levelIndex].place, b.source, levels[b.levelIndex].place));
    }
    return planOf(leaves, levels, place, progress);
}

mat4d worldFromIndices(const vec3d& corner, const vec3i& index, const vec3d& cellSize)
{
    const mat4d scaled = glm::scale(glm::translate(mat4d(1.0), corner), cellSize);
    return glm::translate(scaled, -vec3d(index));
}

} // namespace brickwall
