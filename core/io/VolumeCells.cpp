// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/VolumeCells.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/FieldNames.h"
#include "brickwall/core/io/PresentCells.h"
#include "brickwall/core/model/BrickBuilder.h"
#include "brickwall/core/model/MergeBoxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace brickwall {
namespace {

/// What is known of the voxels in a coarse cell.
struct Summary
{
    float lo = std::numeric_limits<float>::max();
    float hi = std::numeric_limits<float>::lowest();
    float mean = 0.f;
    float variation = 0.f; ///< largest less smallest, with the layer around; NaN if one of these is not finite
};

/// The whole cells of a level from 1; those at odd ends, of which a part would be missing, do not exist.
struct CoarseLevel
{
    vec3i size{0};
    std::vector<Summary> cells;
    std::vector<std::uint8_t> merged; ///< the voxels here became one cell, of this level or of a coarser one

    std::size_t index(const vec3i& c) const { return (std::size_t(c.z) * size.y + c.y) * size.x + c.x; }
    bool has(const vec3i& c) const { return glm::all(glm::lessThan(c, size)); }
};

/// A few planes of the volume, moving up.
class Window
{
public:
    explicit Window(const VolumeFile& volume)
        : planes_(openPlanes(volume)), planeCells_(std::size_t(volume.size.x) * volume.size.y)
    {
    }

    /// Drops what is below `begin`, reads what is missing below `end`.
    void moveTo(int begin, int end)
    {
        const std::size_t drop = std::size_t(std::min(begin, end_) - begin_) * planeCells_;
        values_.erase(values_.begin(), values_.begin() + std::ptrdiff_t(drop));
        begin_ = begin;
        values_.resize(std::size_t(end - begin) * planeCells_);
        for (; end_ < end; ++end_)
            planes_->next({values_.data() + std::size_t(end_ - begin_) * planeCells_, planeCells_});
    }
    const float* plane(int z) const { return values_.data() + std::size_t(z - begin_) * planeCells_; }
    std::span<const float> planes(int begin, int end) const
    {
        return {plane(begin), std::size_t(end - begin) * planeCells_};
    }

private:
    std::unique_ptr<VolumePlanes> planes_;
    std::size_t planeCells_;
    int begin_ = 0;
    int end_ = 0;
    std::vector<float> values_;
};

/// How many planes are worked on at a time: an even number.
int planesAtATime(const vec3i& size)
{
    constexpr std::int64_t cells = 1 << 21;
    return 2 * int(std::clamp<std::int64_t>(cells / (std::int64_t(size.x) * size.y) / 2, 1, 64));
}

Summary summaryOf(const Window& window, const vec3i& size, const vec3i& c)
{
    Summary s;
    float lo = s.lo, hi = s.hi;
    double sum = 0.0;
    bool finite = true;
    const vec3i first = glm::max(c * 2 - 1, vec3i(0)), end = glm::min(c * 2 + 3, size);
    for (int z = first.z; z < end.z; ++z)
        for (int y = first.y; y < end.y; ++y)
            for (int x = first.x; x < end.x; ++x) {
                const float v = window.plane(z)[std::size_t(y) * size.x + x];
                finite &= std::isfinite(v);
                lo = std::min(lo, v);
                hi = std::max(hi, v);
                if (vec3i(x, y, z) / 2 == c) {
                    s.lo = std::min(s.lo, v);
                    s.hi = std::max(s.hi, v);
                    sum += v;
                }
            }
    s.mean = static_cast<float>(sum / 8.0);
    s.variation = finite ? hi - lo : std::numeric_limits<float>::quiet_NaN();
    return s;
}

Range finiteRange(const VolumeFile& volume, std::span<const float> values, int z, NonFinite nonFinite)
{
    Range range;
    for (std::size_t i = 0; i < values.size(); ++i) {
        if (std::isfinite(values[i])) {
            range.extend(values[i]);
        } else if (nonFinite == NonFinite::error) {
            const std::size_t x = i % volume.size.x, row = i / volume.size.x;
            failNotFinite(values[i], volume.data, volume.field,
                          fmt::format("cell ({},{},{})", x, row % volume.size.y, std::size_t(z) + row / volume.size.y));
        }
    }
    return range;
}

/// Summaries of level 1, and the range of all voxels.
std::pair<CoarseLevel, Range> firstLevel(const VolumeFile& volume, NonFinite nonFinite, const Executor& executor,
                                         Progress& progress)
{
    CoarseLevel level;
    level.size = volume.size / 2;
    level.cells.resize(std::size_t(level.size.x) * level.size.y * level.size.z);
    Range range;
    Window window(volume);
    const int step = planesAtATime(volume.size);
    progress.begin("reading the volume", std::uint64_t(volume.size.z));
    for (int z = 0; z < volume.size.z; z += step) {
        progress.check();
        const int end = std::min(z + step, volume.size.z);
        window.moveTo(std::max(z - 1, 0), std::min(end + 1, volume.size.z));
        range.extend(finiteRange(volume, window.planes(z, end), z, nonFinite));
        const std::size_t rows = std::size_t(end / 2 - z / 2) * level.size.y;
        executor.forEach(rows, 16, [&](std::size_t from, std::size_t to) {
            for (std::size_t row = from; row < to; ++row)
                for (int x = 0; x < level.size.x; ++x) {
                    const vec3i c(x, int(row % level.size.y), z / 2 + int(row / level.size.y));
                    level.cells[level.index(c)] = summaryOf(window, volume.size, c);
                }
        });
        progress.advance(std::uint64_t(end - z));
    }
    progress.end();
    return {std::move(level), range};
}

/// The cell of the next coarser level at `c`; its variation is NaN unless all finer cells in it and around it are
/// merged. `width` is that of the finer cells.
Summary summaryOf(const CoarseLevel& finer, const vec3i& voxels, int width, const vec3i& c)
{
    Summary s;
    float lo = s.lo, hi = s.hi;
    double sum = 0.0;
    const vec3i first = glm::max(c * 2 - 1, vec3i(0));
    const vec3i end = glm::min(c * 2 + 3, (voxels + (width - 1)) / width);
    for (int z = first.z; z < end.z; ++z)
        for (int y = first.y; y < end.y; ++y)
            for (int x = first.x; x < end.x; ++x) {
                const vec3i p(x, y, z);
                if (!finer.has(p) || !finer.merged[finer.index(p)]) {
                    s.variation = std::numeric_limits<float>::quiet_NaN();
                    return s;
                }
                const Summary& f = finer.cells[finer.index(p)];
                lo = std::min(lo, f.lo);
                hi = std::max(hi, f.hi);
                if (p / 2 == c) {
                    s.lo = std::min(s.lo, f.lo);
                    s.hi = std::max(s.hi, f.hi);
                    sum += f.mean;
                }
            }
    s.mean = static_cast<float>(sum / 8.0);
    s.variation = hi - lo;
    return s;
}

/// Returns whether any cell of the level is merged.
bool decide(CoarseLevel& level, float allowed)
{
    level.merged.resize(level.cells.size());
    bool any = false;
    for (std::size_t i = 0; i < level.cells.size(); ++i) {
        level.merged[i] = level.cells[i].variation <= allowed; // not for NaN
        any |= level.merged[i] != 0;
    }
    return any;
}

/// Levels from 1, up to the last that has cells.
std::vector<CoarseLevel> coarserLevels(CoarseLevel first, const vec3i& voxels, float allowed, const Executor& executor,
                                       const Progress& progress)
{
    std::vector<CoarseLevel> levels;
    for (bool any = decide(first, allowed); any; any = decide(first, allowed)) {
        levels.push_back(std::move(first));
        const CoarseLevel& finer = levels.back();
        const int width = 1 << levels.size();
        first = {};
        first.size = finer.size / 2;
        first.cells.resize(std::size_t(first.size.x) * first.size.y * first.size.z);
        executor.forEach(std::size_t(first.size.y) * first.size.z, 16, [&](std::size_t from, std::size_t to) {
            progress.check();
            for (std::size_t row = from; row < to; ++row)
                for (int x = 0; x < first.size.x; ++x) {
                    const vec3i c(x, int(row % first.size.y), int(row / first.size.y));
                    first.cells[first.index(c)] = summaryOf(finer, voxels, width, c);
                }
        });
    }
    return levels;
}

std::vector<Brick> bricksOf(const std::vector<CoarseLevel>& levels, const vec3i& voxels, const Executor& executor,
                            Progress& progress)
{
    const int tile = BrickBuilderConfig{}.maxBrickWidth;
    std::vector<Brick> bricks;
    for (int level = 0; level <= int(levels.size()); ++level) {
        const CoarseLevel* own = level > 0 ? &levels[std::size_t(level) - 1] : nullptr;
        const CoarseLevel* coarser = level < int(levels.size()) ? &levels[std::size_t(level)] : nullptr;
        const vec3i size = own ? own->size : voxels;
        const auto leaf = [&](const vec3i& c) {
            const vec3i parent = c / 2;
            return (!own || own->merged[own->index(c)]) &&
                   !(coarser && coarser->has(parent) && coarser->merged[coarser->index(parent)]);
        };
        const vec3i tiles = (size + (tile - 1)) / tile;
        std::vector<std::vector<Brick>> perTile(std::size_t(tiles.x) * tiles.y * tiles.z);
        executor.forEach(perTile.size(), 1, [&](std::size_t from, std::size_t to) {
            for (std::size_t i = from; i < to; ++i) {
                progress.check();
                const vec3i lower = tile * vec3i(i % tiles.x, i / tiles.x % tiles.y, i / tiles.x / tiles.y);
                appendPresent({lower, glm::min(lower + tile, size)}, level, leaf, perTile[i]);
            }
        });
        for (const auto& some : perTile)
            bricks.insert(bricks.end(), some.begin(), some.end());
    }
    mergeBoxes(bricks, tile, progress);
    return bricks;
}

/// The means of the cells that have been merged.
void fillCoarse(const std::vector<CoarseLevel>& levels, VolumeCells& cells)
{
    for (const Brick& b : cells.bricks) {
        if (b.level == 0)
            continue;
        const CoarseLevel& level = levels[std::size_t(b.level) - 1];
        const vec3i lower = b.lower / b.cellWidth();
        float* out = cells.values.data() + b.begin;
        for (int z = 0; z < b.size.z; ++z)
            for (int y = 0; y < b.size.y; ++y)
                for (int x = 0; x < b.size.x; ++x)
                    *out++ = level.cells[level.index(lower + vec3i(x, y, z))].mean;
    }
}

/// The voxels that are cells of their own, in a second reading.
void fillFinest(const VolumeFile& volume, VolumeCells& cells, Progress& progress)
{
    const auto fine =
        std::partition_point(cells.bricks.begin(), cells.bricks.end(), [](const Brick& b) { return b.level == 0; });
    if (fine == cells.bricks.begin())
        return;
    Window window(volume);
    progress.begin("reading voxels", std::uint64_t(volume.size.z));
    const int step = planesAtATime(volume.size);
    for (int begin = 0; begin < volume.size.z; begin += step) {
        progress.check();
        const int end = std::min(begin + step, volume.size.z);
        window.moveTo(begin, end);
        for (auto b = cells.bricks.begin(); b != fine; ++b)
            for (int z = std::max(b->lower.z, begin); z < std::min(b->lower.z + b->size.z, end); ++z)
                for (int y = 0; y < b->size.y; ++y) {
                    const float* row = window.plane(z) + std::size_t(b->lower.y + y) * volume.size.x + b->lower.x;
                    const std::uint64_t first = std::uint64_t(z - b->lower.z) * b->size.y + y;
                    std::copy_n(row, b->size.x, cells.values.begin() + std::ptrdiff_t(b->begin + first * b->size.x));
                }
        progress.advance(std::uint64_t(end - begin));
    }
    progress.end();
}

} // namespace

VolumeCells mergeVolume(const VolumeFile& volume, NonFinite nonFinite, const Executor& executor, Progress& progress)
{
    VolumeCells cells;
    {
        auto [first, range] = firstLevel(volume, nonFinite, executor, progress);
        const double extent = range.empty() ? 0.0 : double(range.hi) - range.lo;
        progress.begin("merging cells", 0);
        const auto levels = coarserLevels(std::move(first), volume.size, static_cast<float>(volume.threshold * extent),
                                          executor, progress);
        cells.bricks = bricksOf(levels, volume.size, executor, progress);
        cells.cellCount = cells.bricks.back().begin + cells.bricks.back().cellCount();
        if (cells.cellCount >= (std::uint64_t(1) << 32))
            throw Error(volume.place, fmt::format("expected fewer than 2^32 cells, found {}; a larger threshold merges "
                                                  "more of them",
                                                  cells.cellCount));
        cells.values.resize(cells.cellCount);
        fillCoarse(levels, cells);
        progress.end();
    }
    fillFinest(volume, cells, progress);
    return cells;
}

} // namespace brickwall
