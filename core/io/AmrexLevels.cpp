// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/AmrexLevels.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/InputFile.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace brickwall {
namespace {

/// At least a byte for each number.
void checkDataSize(const std::string& folder, const BoxLevel& level, const AmrexCells& cells)
{
    double numbers = 0; // boxes may be hostile, their sum beyond 2^64
    for (const Box3i& b : level.boxes)
        numbers += double(volume(b)) * double(cells.components);
    std::uint64_t bytes = 0;
    for (const std::string& file : cells.files)
        bytes += InputFile((std::filesystem::path(folder) / file).string()).size();
    if (numbers > double(bytes))
        throw Error(level.place, fmt::format("truncated: the boxes have {} numbers, but their {} data files only {} "
                                             "bytes",
                                             numbers, cells.files.size(), bytes));
}

void checkAgainstHeader(const AmrexHeader& header, std::size_t level, const AmrexCells& cells, const std::string& place)
{
    const std::int64_t grids = header.levels[level].gridCount;
    if (static_cast<std::int64_t>(cells.boxes.boxes.size()) != grids)
        throw Error(place, fmt::format("expected {} boxes, as Header says of level {}, found {}", grids, level,
                                       cells.boxes.boxes.size()));
    if (cells.components != static_cast<std::int64_t>(header.components.size()))
        throw Error(place, fmt::format("expected {} components, as Header says, found {}", header.components.size(),
                                       cells.components));
}

} // namespace

AmrexLevels readAmrexLevels(const std::string& folder, const AmrexHeader& header, Progress& progress)
{
    const std::size_t count = header.levels.size();
    progress.begin("reading boxes", count);
    std::vector<int> ratios;
    for (std::size_t i = 0; i + 1 < count; ++i)
        ratios.push_back(header.levels[i].ratio);
    const std::vector<int> numbers = levelNumbers(ratios, folder);
    AmrexLevels levels;
    for (std::size_t i = 0; i < count; ++i) {
        progress.check();
        const std::filesystem::path path = std::filesystem::path(folder) / (header.levels[i].path + "_H");
        AmrexCells cells = readAmrexCells(path.string(), numbers[i]);
        checkAgainstHeader(header, i, cells, path.string());
        levels.boxes.push_back(std::exchange(cells.boxes, {}));
        levels.folders.push_back(path.parent_path().string());
        levels.cells.push_back(std::move(cells));
        progress.advance(1);
    }
    progress.end();
    return levels;
}

void checkDataSizes(const AmrexLevels& levels)
{
    for (std::size_t i = 0; i < levels.boxes.size(); ++i)
        checkDataSize(levels.folders[i], levels.boxes[i], levels.cells[i]);
}

} // namespace brickwall
