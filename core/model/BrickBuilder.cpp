// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/BrickBuilder.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/model/BrickIndex.h"
#include "brickwall/core/model/MergeBoxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <numeric>

namespace brickwall {
namespace {

constexpr std::size_t maxCells = std::numeric_limits<std::uint32_t>::max();

/// A cell's level and its place in the grid of its level, packed so that comparing sorts by level, z, y, x (x fastest),
/// and equal cells by record. 16 bytes, because there may be 10^8 of them.
struct CellKey
{
    static constexpr int bits = 30;
    static_assert((std::int64_t(2) * coordinateLimit) < (std::int64_t(1) << bits) && maxLevel < 32);

    std::uint32_t high = 0; ///< level, upper 27 bits of z
    std::uint32_t record = 0;
    std::uint64_t low = 0; ///< lower 3 bits of z, y, x

    CellKey() = default;
    CellKey(const vec3i& lower, int level, std::uint32_t record) : record(record)
    {
        const auto u = [&](int a) { return std::uint64_t((std::int64_t(lower[a]) + coordinateLimit) >> level); };
        high = std::uint32_t(level) << 27 | std::uint32_t(u(2) >> 3);
        low = (u(2) & 7) << (2 * bits) | u(1) << bits | u(0);
    }

    int level() const { return int(high >> 27); }
    vec3i lower() const
    {
        constexpr std::uint64_t mask = (std::uint64_t(1) << bits) - 1;
        const std::uint64_t z = std::uint64_t(high & 0x7ffffffu) << 3 | low >> (2 * bits);
        const auto coordinate = [&](std::uint64_t u) { return int(std::int64_t(u << level()) - coordinateLimit); };
        return {coordinate(low & mask), coordinate(low >> bits & mask), coordinate(z)};
    }
    bool sameCell(const CellKey& k) const { return high == k.high && low == k.low; }
    bool operator<(const CellKey& k) const
    {
        return high != k.high ? high < k.high : low != k.low ? low < k.low : record < k.record;
    }
};
static_assert(sizeof(CellKey) == 16);

std::string described(const Cell& c, std::size_t record)
{
    return fmt::format("cell {} (lower {} {} {}, level {})", record, c.lower.x, c.lower.y, c.lower.z, c.level);
}

void checkConfig(const BrickBuilderConfig& config)
{
    if (config.maxBrickWidth < 1)
        throw Error("brick builder",
                    fmt::format("expected a maximal brick width of at least 1 cell, found {}", config.maxBrickWidth));
}

void checkCell(const Cell& c, std::size_t record, std::string_view place)
{
    const auto fail = [&](const std::string& what) { throw Error(place, described(c, record) + ": " + what); };
    if (c.level < 0 || c.level > maxLevel)
        fail(fmt::format("expected a level from 0 to {}", maxLevel));
    for (int a = 0; a < 3; ++a) {
        const std::int64_t upper = std::int64_t(c.lower[a]) + (1 << c.level);
        if (c.lower[a] < -coordinateLimit || upper > coordinateLimit)
            fail(fmt::format("expected coordinates from {} to {}, found {} to {} along {}", -coordinateLimit,
                             coordinateLimit, c.lower[a], upper, "xyz"[a]));
        if ((c.lower[a] & ((1 << c.level) - 1)) != 0)
            fail(fmt::format("expected a lower corner that is a multiple of the cell width {}, found {} along {}",
                             1 << c.level, c.lower[a], "xyz"[a]));
    }
}

/// Halves are sorted side by side, then merged. Keys are all different, so the result does not depend on who does it.
void sortKeys(std::span<CellKey> keys, const Executor& executor, const Progress& progress)
{
    progress.check();
    if (keys.size() <= std::size_t(1) << 17)
        return std::sort(keys.begin(), keys.end());
    const std::size_t half = keys.size() / 2;
    executor.both([&] { sortKeys(keys.first(half), executor, progress); },
                  [&] { sortKeys(keys.subspan(half), executor, progress); });
    std::inplace_merge(keys.begin(), keys.begin() + std::ptrdiff_t(half), keys.end());
}

std::vector<CellKey> sortedKeys(std::span<const Cell> cells, std::string_view place, const Executor& executor,
                                Progress& progress)
{
    std::vector<CellKey> keys(cells.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (i % 65536 == 0)
            progress.check();
        checkCell(cells[i], i, place);
        keys[i] = CellKey(cells[i].lower, cells[i].level, std::uint32_t(i));
    }
    sortKeys(keys, executor, progress);
    return keys;
}

/// Rows of neighbouring cells along x. They end at multiples of maxWidth cells from the origin, so that rows beside
/// each other end alike and can be merged.
std::vector<Brick> rowsOf(std::span<const CellKey> keys, int maxWidth)
{
    std::vector<Brick> rows;
    for (const CellKey& k : keys) {
        const Brick cell{k.lower(), vec3i(1), k.level(), 0};
        const bool next = !rows.empty() && rows.back().level == cell.level && rows.back().lower.y == cell.lower.y &&
                          rows.back().lower.z == cell.lower.z && rows.back().box().upper.x == cell.lower.x;
        if (next && (cell.lower.x >> cell.level) % maxWidth != 0)
            ++rows.back().size.x;
        else
            rows.push_back(cell);
    }
    return rows;
}

/// The position in the sorted keys of the cell of that level at that lower corner, which has to be there.
std::size_t positionOf(std::span<const CellKey> keys, const vec3i& lower, int level)
{
    return std::size_t(std::lower_bound(keys.begin(), keys.end(), CellKey(lower, level, 0)) - keys.begin());
}

void checkLevelsDisjoint(std::span<const Brick> bricks, std::span<const CellKey> keys, std::span<const Cell> cells,
                         std::string_view place)
{
    const auto overlap = findOverlap(bricks);
    if (!overlap)
        return;
    const Brick &first = bricks[overlap->first], &second = bricks[overlap->second];
    const vec3i p = glm::max(first.lower, second.lower);
    const auto recordAt = [&](const Brick& b) {
        const vec3i lower = p - ((p - b.lower) & (b.cellWidth() - 1));
        return keys[positionOf(keys, lower, b.level)].record;
    };
    const std::uint32_t a = recordAt(first), b = recordAt(second);
    throw Error(place, fmt::format("expected leaf cells only, found that {} and {} overlap at voxel {} {} {}; leave "
                                   "out the coarser of the two",
                                   described(cells[std::min(a, b)], std::min(a, b)),
                                   described(cells[std::max(a, b)], std::max(a, b)), p.x, p.y, p.z));
}

/// Calls body(brick, slot, lower corner) for every row along x of the bricks.
template <class Body>
void forEachRow(std::span<const Brick> bricks, const Executor& executor, Progress& progress, const Body& body)
{
    executor.forEach(bricks.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            progress.check();
            const Brick& b = bricks[i];
            std::uint64_t slot = b.begin;
            for (int z = 0; z < b.size.z; ++z)
                for (int y = 0; y < b.size.y; ++y, slot += std::uint64_t(b.size.x))
                    body(b, slot, b.lower + vec3i(0, y, z) * b.cellWidth());
        }
        progress.advance(end - begin);
    });
}

} // namespace

BrickLayout buildBricks(std::span<const Cell> cells, std::string_view place, const BrickBuilderConfig& config,
                        const Executor& executor, Progress& progress)
{
    checkConfig(config);
    if (cells.size() > maxCells)
        throw Error(place, fmt::format("expected at most {} cells, found {}", maxCells, cells.size()));
    progress.begin("sorting cells", 0);
    std::vector<CellKey> keys = sortedKeys(cells, place, executor, progress);
    keys.erase(std::unique(keys.begin(), keys.end(), [](const CellKey& a, const CellKey& b) { return a.sameCell(b); }),
               keys.end());
    BrickLayout layout;
    layout.duplicates = cells.size() - keys.size();

    progress.begin("forming bricks", 0);
    layout.bricks = rowsOf(keys, config.maxBrickWidth);
    mergeBoxes(layout.bricks, config.maxBrickWidth, progress);
    checkLevelsDisjoint(layout.bricks, keys, cells, place);

    progress.begin("ordering cells", layout.bricks.size());
    layout.source.resize(keys.size());
    forEachRow(layout.bricks, executor, progress, [&](const Brick& b, std::uint64_t slot, const vec3i& lower) {
        const CellKey* key = &keys[positionOf(keys, lower, b.level)];
        for (int x = 0; x < b.size.x; ++x)
            layout.source[slot + std::uint64_t(x)] = key[x].record;
    });
    progress.end();
    return layout;
}

BrickLayout mergeBricks(std::span<const Brick> bricks, const BrickBuilderConfig& config, const Executor& executor,
                        Progress& progress)
{
    checkConfig(config);
    const std::uint64_t cells = std::accumulate(bricks.begin(), bricks.end(), std::uint64_t(0),
                                                [](std::uint64_t n, const Brick& b) { return n + b.cellCount(); });
    if (cells > maxCells)
        throw Error("merging bricks", fmt::format("expected at most {} cells, found {}", maxCells, cells));
    progress.begin("merging bricks", 0);
    BrickLayout layout;
    layout.bricks.assign(bricks.begin(), bricks.end());
    mergeBoxes(layout.bricks, config.maxBrickWidth, progress);

    layout.source.resize(cells);
    const BrickIndex merged(layout.bricks);
    forEachRow(bricks, executor, progress, [&](const Brick& b, std::uint64_t slot, const vec3i& lower) {
        merged.overlapping({lower, lower + b.cellWidth()}, [&](std::uint32_t m, const Box3i&) {
            const Brick& into = layout.bricks[m];
            const vec3i c = (lower - into.lower) / into.cellWidth();
            const std::uint64_t first = into.slotOf(c);
            for (int x = 0; x < b.size.x; ++x)
                layout.source[first + std::uint64_t(x)] = std::uint32_t(slot + std::uint64_t(x));
        });
    });
    progress.end();
    return layout;
}

std::vector<float> gather(std::span<const float> sourceValues, std::span<const std::uint32_t> source,
                          const Executor& executor)
{
    std::vector<float> values(source.size());
    executor.forEach(source.size(), 65536, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            values[i] = sourceValues[source[i]];
    });
    return values;
}

} // namespace brickwall
