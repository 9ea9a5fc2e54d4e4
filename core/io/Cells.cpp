// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/ExaGeometry.h"
#include "brickwall/core/model/BrickBuilder.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace brickwall {
namespace {

/// Number of records; the size of the file has to be a multiple of theirs.
std::uint64_t cellRecords(const InputFile& file)
{
    const std::uint64_t count = file.size() / sizeof(Cell);
    if (file.size() == 0)
        throw Error(file.path(), "the file is empty, expected cells");
    if (file.size() % sizeof(Cell) != 0)
        throw Error(file.path(), fmt::format("truncated: cell record {} at byte {}: expected {} bytes, found {}", count,
                                             count * sizeof(Cell), sizeof(Cell), file.size() % sizeof(Cell)));
    if (count > (std::uint64_t(1) << 31))
        throw Error(file.path(), fmt::format("expected at most 2^31 cells, as IDs are int32, found {}", count));
    return count;
}

void checkCell(const InputFile& file, std::uint64_t record, const Cell& cell)
{
    const auto fail = [&](const std::string& message) {
        throw Error(file.path(), fmt::format("cell record {} at byte {}: {}", record, record * sizeof(Cell), message));
    };
    if (cell.level < 0 || cell.level > maxLevel)
        fail(fmt::format("expected a level from 0 to {}, found {}; the file has to be little-endian", maxLevel,
                         cell.level));
    const int width = 1 << cell.level;
    for (int axis = 0; axis < 3; ++axis) {
        if (cell.lower[axis] < -coordinateLimit || cell.lower[axis] > coordinateLimit - width)
            fail(fmt::format("expected coordinates within +-{}, found {}", coordinateLimit, cell.lower[axis]));
        if (cell.lower[axis] % width != 0)
            fail(fmt::format("misaligned: ({},{},{}) is no multiple of the cell width {} of level {}", cell.lower.x,
                             cell.lower.y, cell.lower.z, width, cell.level));
    }
}

} // namespace

void checkFirstCell(const std::string& path)
{
    const InputFile file(path);
    cellRecords(file);
    Cell first{};
    file.readAt(0, std::span(&first, 1), "the first cell");
    checkCell(file, 0, first);
}

ExaGeometry readCells(const std::string& path, const Executor& executor, Progress& progress)
{
    constexpr std::size_t chunk = 1 << 18;
    const InputFile file(path);
    std::vector<Cell> cells(cellRecords(file));
    progress.begin("reading cells", cells.size());
    executor.forEach(cells.size(), chunk, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; i += chunk) {
            progress.check();
            const std::size_t n = std::min(chunk, end - i);
            file.readAt(i * sizeof(Cell), std::span(cells).subspan(i, n), "cells");
            for (std::size_t k = i; k < i + n; ++k)
                checkCell(file, k, cells[k]);
            progress.advance(n);
        }
    });
    progress.end();

    BrickLayout layout = buildBricks(cells, path, {}, executor, progress);
    ExaGeometry geometry;
    geometry.place = path;
    geometry.bricks = std::move(layout.bricks);
    geometry.cellCount = layout.source.size();
    geometry.storedIds = std::move(layout.source);
    if (layout.duplicates > 0)
        geometry.notes.push_back(
            fmt::format("{}: {} duplicate cells dropped, the first of each kept", path, layout.duplicates));
    return geometry;
}

} // namespace brickwall
