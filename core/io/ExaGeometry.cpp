// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/ExaGeometry.h"

#include <fmt/format.h>

#include <algorithm>

namespace brickwall {
namespace {

constexpr std::size_t chunk = 1 << 16; // IDs that are read at a time

} // namespace

void ExaGeometry::forEachId(const Executor& executor, Progress& progress,
                            const std::function<void(std::uint64_t, std::span<const std::uint32_t>)>& body) const
{
    executor.forEach(fileOffsets.size(), 1, [&](std::size_t begin, std::size_t end) {
        std::vector<std::uint32_t> ids;
        for (std::size_t b = begin; b < end; ++b) {
            const std::uint64_t cells = bricks[b].cellCount();
            for (std::uint64_t first = 0; first < cells; first += chunk) {
                progress.check();
                ids.resize(std::min<std::uint64_t>(chunk, cells - first));
                idFile->readAt(fileOffsets[b] + first * sizeof(std::uint32_t), std::span(ids), "cell IDs");
                body(bricks[b].begin + first, ids);
                progress.advance(ids.size());
            }
        }
    });
    const std::uint64_t storedBegin = cellCount - storedIds.size();
    executor.forEach(storedIds.size(), chunk, [&](std::size_t begin, std::size_t end) {
        progress.check();
        body(storedBegin + begin, std::span(storedIds).subspan(begin, end - begin));
        progress.advance(end - begin);
    });
}

std::string ExaGeometry::describe(std::uint64_t slot) const
{
    const auto after = std::upper_bound(bricks.begin(), bricks.end(), slot,
                                        [](std::uint64_t s, const Brick& b) { return s < b.begin; });
    const std::size_t b = static_cast<std::size_t>(after - bricks.begin()) - 1;
    const Brick& brick = bricks[b];
    const auto local = static_cast<std::int64_t>(slot - brick.begin);
    const vec3i cell(local % brick.size.x, local / brick.size.x % brick.size.y,
                     local / (std::int64_t(brick.size.x) * brick.size.y));
    const vec3i lower = brick.lower + cell * brick.cellWidth();
    const std::string of =
        b < records.size() ? fmt::format("cell ({},{},{}) of brick {}", cell.x, cell.y, cell.z, records[b]) : "cell";
    return fmt::format("{} at voxel ({},{},{}) of level {}", of, lower.x, lower.y, lower.z, brick.level);
}

} // namespace brickwall
