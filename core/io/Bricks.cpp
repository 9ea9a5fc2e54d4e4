// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/ExaGeometry.h"
#include "brickwall/core/model/BrickBuilder.h"
#include "brickwall/core/model/CheckModel.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <utility>

namespace brickwall {
namespace {

constexpr std::uint64_t headerBytes = 28;

[[noreturn]] void failRecord(const InputFile& file, std::uint64_t record, std::uint64_t offset,
                             const std::string& message)
{
    throw Error(file.path(), fmt::format("brick record {} at byte {}: {}", record, offset, message));
}

/// Reads headers one after the other; those of small bricks, which may be millions, many at a time.
class HeaderReader
{
public:
    explicit HeaderReader(const InputFile& file) : file_(file) {}

    std::array<std::int32_t, 7> at(std::uint64_t offset)
    {
        constexpr std::uint64_t window = 1 << 16, small = 1 << 12;
        if (offset < begin_ || offset + headerBytes > begin_ + bytes_.size()) {
            bytes_.resize(offset < last_ + small ? std::min(window, file_.size() - offset) : headerBytes);
            begin_ = offset;
            file_.readAt(offset, std::span(bytes_), "a brick's header");
        }
        std::array<std::int32_t, 7> header{};
        std::memcpy(header.data(), bytes_.data() + (offset - begin_), headerBytes);
        last_ = offset;
        return header;
    }

private:
    const InputFile& file_;
    std::vector<std::byte> bytes_;
    std::uint64_t begin_ = 0, last_ = 0;
};

/// The brick of the record at `offset`, which has been checked to end within the file.
Brick readRecord(const InputFile& file, HeaderReader& headers, std::uint64_t record, std::uint64_t offset)
{
    if (file.size() - offset < headerBytes)
        failRecord(file, record, offset,
                   fmt::format("truncated: expected {} bytes of size, lower and level, found {}", headerBytes,
                               file.size() - offset));
    const std::array<std::int32_t, 7> h = headers.at(offset);
    Brick brick{.lower = {h[3], h[4], h[5]}, .size = {h[0], h[1], h[2]}, .level = h[6]};

    const std::uint64_t room = (file.size() - offset - headerBytes) / sizeof(std::uint32_t);
    std::uint64_t cells = 1;
    for (int axis = 0; axis < 3; ++axis) {
        if (brick.size[axis] <= 0)
            failRecord(file, record, offset,
                       fmt::format("expected a positive size, found ({},{},{})", h[0], h[1], h[2]));
        const std::uint64_t n = static_cast<std::uint64_t>(brick.size[axis]);
        if (n > room / cells)
            failRecord(
                file, record, offset,
                fmt::format("truncated or not little-endian: its {} x {} x {} cell IDs do not fit the {} bytes up to "
                            "the end of the file",
                            h[0], h[1], h[2], file.size() - offset - headerBytes));
        cells *= n;
    }
    if (brick.level < 0 || brick.level > maxLevel)
        failRecord(file, record, offset, fmt::format("expected a level from 0 to {}, found {}", maxLevel, brick.level));
    for (int axis = 0; axis < 3; ++axis) {
        const std::int64_t low = brick.lower[axis];
        const std::int64_t high = low + std::int64_t(brick.size[axis]) * brick.cellWidth();
        if (low % brick.cellWidth() != 0)
            failRecord(file, record, offset,
                       fmt::format("misaligned: lower ({},{},{}) is no multiple of the cell width {} of level {}", h[3],
                                   h[4], h[5], brick.cellWidth(), brick.level));
        if (low < -coordinateLimit || high > coordinateLimit)
            failRecord(file, record, offset,
                       fmt::format("expected coordinates within +-{}, found {} to {}", coordinateLimit, low, high));
    }
    return brick;
}

/// Calls body(brick, offset of its IDs) for all records.
template <class Body>
void forEachRecord(const InputFile& file, const Body& body)
{
    HeaderReader headers(file);
    std::uint64_t record = 0;
    for (std::uint64_t offset = 0; offset < file.size(); ++record) {
        const Brick brick = readRecord(file, headers, record, offset);
        offset += headerBytes;
        body(brick, offset);
        offset += brick.cellCount() * sizeof(std::uint32_t);
    }
}

/// Twice, as it is quickly done: a file that is broken at its end should not take memory first. For the same reason
/// bricks at one place are looked for whenever there are twice as many.
void readRecords(ExaGeometry& geometry, Progress& progress)
{
    const InputFile& file = *geometry.idFile;
    progress.begin("reading bricks", file.size());
    std::size_t count = 0;
    forEachRecord(file, [&](const Brick&, std::uint64_t) { ++count; });
    geometry.bricks.reserve(count);
    geometry.records.reserve(count);
    geometry.fileOffsets.reserve(count);
    std::size_t nextCheck = 1 << 17;
    forEachRecord(file, [&](Brick brick, std::uint64_t idOffset) {
        if (geometry.bricks.size() % 1024 == 0)
            progress.check();
        if (geometry.bricks.size() == nextCheck) {
            checkBricks(geometry.bricks, geometry.place);
            nextCheck *= 2;
        }
        brick.begin = geometry.cellCount;
        geometry.records.push_back(geometry.bricks.size());
        geometry.fileOffsets.push_back(idOffset);
        geometry.bricks.push_back(brick);
        geometry.cellCount += brick.cellCount();
        progress.advance(headerBytes + brick.cellCount() * sizeof(std::uint32_t));
    });
    progress.end();
}

std::size_t brickOfSlot(const ExaGeometry& geometry, std::uint64_t slot)
{
    const auto after = std::upper_bound(geometry.bricks.begin(), geometry.bricks.end(), slot,
                                        [](std::uint64_t s, const Brick& b) { return s < b.begin; });
    return static_cast<std::size_t>(after - geometry.bricks.begin()) - 1;
}

/// Which bricks have cells with ID -1. Other negative IDs are an Error.
std::vector<std::atomic<bool>> findEmptyCells(const ExaGeometry& geometry, const Executor& executor, Progress& progress)
{
    std::vector<std::atomic<bool>> hasEmpty(geometry.bricks.size());
    progress.begin("looking for empty cells", geometry.cellCount);
    geometry.forEachId(executor, progress, [&](std::uint64_t first, std::span<const std::uint32_t> ids) {
        for (std::size_t i = 0; i < ids.size(); ++i) {
            const auto id = static_cast<std::int32_t>(ids[i]);
            if (id == -1)
                hasEmpty[brickOfSlot(geometry, first + i)] = true;
            else if (id < -1)
                throw Error(geometry.place,
                            fmt::format("expected a cell ID from 0, or -1 for an empty cell, found {} in {}", id,
                                        geometry.describe(first + i)));
        }
    });
    progress.end();
    return hasEmpty;
}

struct LooseCells
{
    std::vector<Cell> cells;
    std::vector<std::uint32_t> ids;
};

void appendFullCells(const ExaGeometry& geometry, std::size_t b, LooseCells& loose)
{
    const Brick& brick = geometry.bricks[b];
    std::vector<std::uint32_t> ids(brick.cellCount());
    geometry.idFile->readAt(geometry.fileOffsets[b], std::span(ids), "cell IDs");
    std::size_t i = 0;
    for (int z = 0; z < brick.size.z; ++z)
        for (int y = 0; y < brick.size.y; ++y)
            for (int x = 0; x < brick.size.x; ++x, ++i)
                if (ids[i] != std::uint32_t(-1)) {
                    loose.cells.push_back({brick.lower + vec3i(x, y, z) * brick.cellWidth(), brick.level});
                    loose.ids.push_back(ids[i]);
                }
}

/// Replaces the bricks that have empty cells by smaller ones that have none, at the end of the list.
void carveEmptyCells(ExaGeometry& geometry, const Executor& executor, Progress& progress)
{
    const auto hasEmpty = findEmptyCells(geometry, executor, progress);
    if (std::none_of(hasEmpty.begin(), hasEmpty.end(), [](const auto& e) { return e.load(); }))
        return;
    ExaGeometry full;
    full.place = geometry.place;
    full.idFile = geometry.idFile;
    LooseCells loose;
    for (std::size_t b = 0; b < geometry.bricks.size(); ++b) {
        progress.check();
        if (hasEmpty[b]) {
            appendFullCells(geometry, b, loose);
            continue;
        }
        full.bricks.push_back(geometry.bricks[b]);
        full.bricks.back().begin = full.cellCount;
        full.cellCount += geometry.bricks[b].cellCount();
        full.records.push_back(geometry.records[b]);
        full.fileOffsets.push_back(geometry.fileOffsets[b]);
    }
    const std::size_t emptied = geometry.bricks.size() - full.bricks.size();
    const BrickLayout layout = buildBricks(loose.cells, geometry.place, {}, executor, progress);
    for (Brick brick : layout.bricks) {
        brick.begin += full.cellCount;
        full.bricks.push_back(brick);
    }
    for (const std::uint32_t cell : layout.source)
        full.storedIds.push_back(loose.ids[cell]);
    full.cellCount += full.storedIds.size();
    full.notes.push_back(fmt::format(
        "{}: {} empty cells (ID -1) in {} bricks left out; the other {} cells of these carved into {} bricks",
        geometry.place, geometry.cellCount - full.cellCount, emptied, layout.source.size(), layout.bricks.size()));
    if (full.cellCount == 0)
        throw Error(geometry.place, "expected cells, found nothing but empty ones (ID -1)");
    geometry = std::move(full);
}

} // namespace

void checkFirstBrick(const std::string& path)
{
    const InputFile file(path);
    if (file.size() == 0)
        throw Error(path, "the file is empty, expected bricks");
    HeaderReader headers(file);
    readRecord(file, headers, 0, 0);
}

ExaGeometry readBricks(const std::string& path, const Executor& executor, Progress& progress)
{
    checkFirstBrick(path);
    ExaGeometry geometry;
    geometry.place = path;
    geometry.idFile = std::make_shared<InputFile>(path);
    readRecords(geometry, progress);
    carveEmptyCells(geometry, executor, progress);
    return geometry;
}

} // namespace brickwall
