// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/AmrexPlan.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/model/BrickBuilder.h"
#include "brickwall/core/model/LeafBoxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <filesystem>

namespace brickwall {
namespace {

std::vector<AmrexPlotLevel> readLevels(const std::string& folder, const AmrexHeader& header, Progress& progress)
{
    progress.begin("reading boxes", header.levels.size());
    std::vector<AmrexPlotLevel> levels(header.levels.size());
    int level = 0;
    for (std::size_t i = levels.size(); i-- > 0;) {
        progress.check();
        const AmrexLevel& described = header.levels[i];
        level += i + 1 < levels.size() ? std::countr_zero(static_cast<unsigned>(described.ratio)) : 0;
        const std::filesystem::path path = std::filesystem::path(folder) / (described.path + "_H");
        levels[i] = {path.string(), path.parent_path().string(), readAmrexCells(path.string()), level};
        const AmrexCells& cells = levels[i].cells;
        if (static_cast<std::int64_t>(cells.boxes.size()) != described.gridCount)
            throw Error(levels[i].place, fmt::format("expected {} boxes, as Header says of level {}, found {}",
                                                     described.gridCount, i, cells.boxes.size()));
        if (cells.components != static_cast<std::int64_t>(header.components.size()))
            throw Error(levels[i].place, fmt::format("expected {} components, as Header says, found {}",
                                                     header.components.size(), cells.components));
        progress.advance(1);
    }
    progress.end();
    return levels;
}

std::vector<OverlappingLevel> inVoxels(const std::vector<AmrexPlotLevel>& levels)
{
    std::vector<OverlappingLevel> boxes;
    for (const AmrexPlotLevel& level : levels) {
        OverlappingLevel o{level.place, level.level, {}};
        for (std::size_t i = 0; i < level.cells.boxes.size(); ++i) {
            const Box3i& b = level.cells.boxes[i];
            const int width = 1 << level.level;
            for (int axis = 0; axis < 3; ++axis)
                if (std::int64_t(b.lower[axis]) * width < -coordinateLimit ||
                    std::int64_t(b.upper[axis]) * width > coordinateLimit)
                    throw Error(level.place,
                                fmt::format("box {}: expected indices within +-{}, found {} to {} along {}", i,
                                            coordinateLimit / width, b.lower[axis], b.upper[axis] - 1, "xyz"[axis]));
            o.boxes.push_back({b.lower * width, b.upper * width});
        }
        boxes.push_back(std::move(o));
    }
    return boxes;
}

/// Bricks as small as the pieces, in their order.
std::vector<Brick> unmergedBricks(const AmrexPlan& plan, const std::vector<LeafBox>& leaves)
{
    std::vector<Brick> bricks;
    std::uint64_t begin = 0;
    for (const LeafBox& leaf : leaves) {
        const int level = plan.levels[leaf.levelIndex].level;
        bricks.push_back({leaf.box.lower, leaf.box.extent() / (1 << level), level, begin});
        begin += bricks.back().cellCount();
    }
    return bricks;
}

/// Which merged brick each of the small ones went into. Along a row of a merged brick the small one seldom changes.
void placePieces(AmrexPlan& plan, const std::vector<Brick>& small, const BrickLayout& merged)
{
    const auto pieceOf = [&](std::uint64_t slot) {
        const auto after = std::upper_bound(small.begin(), small.end(), slot,
                                            [](std::uint64_t s, const Brick& b) { return s < b.begin; });
        return static_cast<std::size_t>(after - small.begin()) - 1;
    };
    for (std::uint32_t m = 0; m < merged.bricks.size(); ++m) {
        std::uint64_t begin = 1, end = 0; // of the values of the piece at hand
        for (std::uint64_t i = 0; i < merged.bricks[m].cellCount(); ++i) {
            const std::uint64_t source = merged.source[merged.bricks[m].begin + i];
            if (source >= begin && source < end)
                continue;
            const std::size_t piece = pieceOf(source);
            plan.pieces[piece].brick = m;
            begin = small[piece].begin;
            end = begin + small[piece].cellCount();
        }
    }
}

void addPieces(AmrexPlan& plan, const std::vector<LeafBox>& leaves)
{
    for (const LeafBox& leaf : leaves) {
        const int width = 1 << plan.levels[leaf.levelIndex].level;
        if (plan.jobs.empty() || plan.jobs.back().levelIndex != leaf.levelIndex || plan.jobs.back().fab != leaf.source)
            plan.jobs.push_back({leaf.levelIndex, leaf.source, plan.pieces.size(), plan.pieces.size()});
        plan.pieces.push_back({{leaf.box.lower / width, leaf.box.upper / width}});
        plan.jobs.back().endPiece = plan.pieces.size();
    }
}

} // namespace

AmrexPlan planPlotfile(const std::string& folder, const AmrexHeader& header, const Executor& executor,
                       Progress& progress)
{
    AmrexPlan plan;
    plan.levels = readLevels(folder, header, progress);
    progress.begin("leaving out covered cells", 0);
    const auto leaves = leafBoxes(inVoxels(plan.levels), executor, progress);
    const std::vector<Brick> small = unmergedBricks(plan, leaves);
    for (const Brick& b : small)
        plan.cellCount += b.cellCount();
    if (plan.cellCount == 0)
        throw Error(folder, "expected cells, found a plotfile without boxes");
    if (plan.cellCount >= (std::uint64_t(1) << 32))
        throw Error(folder,
                    fmt::format("expected fewer than 2^32 cells that no finer level covers, found {}", plan.cellCount));
    for (const AmrexPlotLevel& level : plan.levels)
        for (const Box3i& b : level.cells.boxes)
            plan.coveredCells += static_cast<std::uint64_t>(volume(b));
    plan.coveredCells -= plan.cellCount;
    progress.end();

    addPieces(plan, leaves);
    BrickLayout merged = mergeBricks(small, {}, executor, progress);
    placePieces(plan, small, merged);
    plan.bricks = std::move(merged.bricks);
    return plan;
}

} // namespace brickwall
