// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/LeafBoxes.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/model/BrickIndex.h"

#include <fmt/format.h>

#include <algorithm>

namespace brickwall {
namespace {

struct Cut
{
    int axis = 0;
    int plane = 0;
    std::size_t cost = 0;
};

/// The plane through a face of a hole that leaves the fewest holes on its fuller side, holes that it cuts counting
/// twice. There has to be a face strictly inside the box.
Cut bestCut(const Box3i& box, const std::vector<Box3i>& holes)
{
    Cut best{0, 0, std::size_t(-1)};
    std::vector<int> lows, highs;
    for (int axis = 0; axis < 3; ++axis) {
        lows.clear();
        highs.clear();
        for (const Box3i& h : holes) {
            lows.push_back(h.lower[axis]);
            highs.push_back(h.upper[axis]);
        }
        std::sort(lows.begin(), lows.end());
        std::sort(highs.begin(), highs.end());
        const auto consider = [&](int plane) {
            if (plane <= box.lower[axis] || plane >= box.upper[axis])
                return;
            const std::size_t left = std::lower_bound(lows.begin(), lows.end(), plane) - lows.begin();
            const std::size_t right = highs.end() - std::upper_bound(highs.begin(), highs.end(), plane);
            const std::size_t cost = std::max(left, right) + (left + right - holes.size());
            if (cost < best.cost)
                best = {axis, plane, cost};
        };
        for (const int p : lows)
            consider(p);
        for (const int p : highs)
            consider(p);
    }
    return best;
}

Box3i side(const Box3i& box, int axis, int plane, bool upper)
{
    Box3i half = box;
    (upper ? half.lower : half.upper)[axis] = plane;
    return half;
}

/// Of a box within coordinateLimit, which may have more voxels than 64 bits count.
double voxelsIn(const Box3i& b)
{
    return b.empty() ? 0.0 : double(b.extent().x) * b.extent().y * b.extent().z;
}

/// Cuts slabs without holes off the box, the largest first, until it is the bounds of its holes.
void peel(Box3i& box, const Box3i& bounds, std::vector<Box3i>& out)
{
    while (box != bounds) {
        Box3i largest;
        Box3i rest;
        for (int axis = 0; axis < 3; ++axis)
            for (const bool upper : {false, true}) {
                const int plane = (upper ? bounds.upper : bounds.lower)[axis];
                const Box3i slab = side(box, axis, plane, upper);
                if (voxelsIn(slab) > voxelsIn(largest)) {
                    largest = slab;
                    rest = side(box, axis, plane, !upper);
                }
            }
        out.push_back(largest);
        box = rest;
    }
}

/// Appends the parts of `box` outside the holes, which are clipped to it and not empty.
void carve(Box3i box, const std::vector<Box3i>& holes, std::vector<Box3i>& out)
{
    if (holes.empty()) {
        out.push_back(box);
        return;
    }
    Box3i bounds;
    for (const Box3i& h : holes)
        bounds.extend(h);
    peel(box, bounds, out);
    if (std::find(holes.begin(), holes.end(), box) != holes.end())
        return;
    const Cut cut = bestCut(box, holes);
    for (const bool upper : {false, true}) {
        const Box3i half = side(box, cut.axis, cut.plane, upper);
        std::vector<Box3i> inside;
        for (const Box3i& h : holes)
            if (const Box3i clipped = h.intersection(half); !clipped.empty())
                inside.push_back(clipped);
        carve(half, inside, out);
    }
}

std::string text(const Box3i& b)
{
    return fmt::format("[{},{},{} .. {},{},{})", b.lower.x, b.lower.y, b.lower.z, b.upper.x, b.upper.y, b.upper.z);
}

bool aligned(const Box3i& b, int width)
{
    const vec3i low = b.lower % width, high = b.upper % width;
    return low == vec3i(0) && high == vec3i(0);
}

void checkBoxes(const OverlappingLevel& level)
{
    for (std::size_t i = 0; i < level.boxes.size(); ++i) {
        const Box3i& b = level.boxes[i];
        const auto fail = [&](const std::string& what) {
            throw Error(level.place, fmt::format("box {}, {} in finest cells, {}", i, text(b), what));
        };
        if (b.empty())
            fail("is empty");
        if (glm::any(glm::lessThan(b.lower, vec3i(-coordinateLimit))) ||
            glm::any(glm::greaterThan(b.upper, vec3i(coordinateLimit))))
            fail(fmt::format("lies outside the coordinates that can be shown, +-{}", coordinateLimit));
        if (!aligned(b, 1 << level.level))
            fail(fmt::format("is not aligned to its own cells, which are {} wide", 1 << level.level));
    }
}

void checkDisjoint(const OverlappingLevel& level)
{
    if (const auto pair = findOverlap(level.boxes))
        throw Error(level.place,
                    fmt::format("boxes {} and {} of one level overlap: {} and {} in finest cells", pair->first,
                                pair->second, text(level.boxes[pair->first]), text(level.boxes[pair->second])));
}

Box3i outward(const Box3i& b, int width)
{
    return {b.lower & -width, (b.upper + (width - 1)) & -width};
}

[[noreturn]] void failMisaligned(const OverlappingLevel& level, std::size_t box, const Box3i& b, int width)
{
    if (box < level.boxes.size())
        throw Error(level.place, fmt::format("box {}, {} in finest cells, is misaligned: expected whole cells of the "
                                             "next coarser level, which are {} wide",
                                             box, text(b), width));
    throw Error(level.place, fmt::format("a finer level reaches beyond this one in {}, in finest cells, which is no "
                                         "whole number of cells of the next coarser level",
                                         text(b)));
}

/// What has to be cut out of the next coarser level: the boxes of `level`, and what of the finer levels sticks out of
/// these. Each for itself need not be whole cells of the coarser level, as long as they are together (VTK's blocks).
std::vector<Box3i> holesBelow(const OverlappingLevel& level, const std::vector<Box3i>& finer,
                              const OverlappingLevel& coarser, const Executor& executor, const Progress& progress)
{
    const int width = 1 << coarser.level;
    std::vector<Box3i> holes = level.boxes;
    for (const LeafBox& piece : subtractBoxes(finer, level.boxes, executor, progress))
        holes.push_back(piece.box);
    std::vector<Box3i> grown;
    std::vector<std::size_t> source;
    for (std::size_t i = 0; i < holes.size(); ++i)
        if (!aligned(holes[i], width)) {
            grown.push_back(outward(holes[i], width));
            source.push_back(i);
        }
    const auto missing = subtractBoxes(grown, holes, executor, progress);
    if (!missing.empty()) {
        const std::size_t first = source[missing[0].source];
        failMisaligned(level, first, holes[first], width);
    }
    for (std::size_t i = 0; i < grown.size(); ++i)
        holes[source[i]] = grown[i];
    return holes;
}

/// Whether no box covers another one, of whatever level: then all are leaves.
bool areDisjoint(std::span<const OverlappingLevel> levels)
{
    std::vector<Box3i> all;
    for (const OverlappingLevel& level : levels)
        all.insert(all.end(), level.boxes.begin(), level.boxes.end());
    return !findOverlap(all);
}

} // namespace

std::vector<LeafBox> subtractBoxes(std::span<const Box3i> boxes, std::span<const Box3i> holes, const Executor& executor,
                                   const Progress& progress)
{
    const BrickIndex index(holes);
    std::vector<std::vector<Box3i>> pieces(boxes.size());
    executor.forEach(boxes.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            progress.check();
            if (boxes[i].empty())
                continue;
            std::vector<std::uint32_t> hits;
            index.overlapping(boxes[i], [&](std::uint32_t h, const Box3i&) { hits.push_back(h); });
            std::sort(hits.begin(), hits.end());
            std::vector<Box3i> inside;
            for (const std::uint32_t h : hits)
                inside.push_back(holes[h].intersection(boxes[i]));
            carve(boxes[i], inside, pieces[i]);
        }
    });
    std::vector<LeafBox> out;
    for (std::size_t i = 0; i < boxes.size(); ++i)
        for (const Box3i& b : pieces[i])
            out.push_back({b, 0, static_cast<std::uint32_t>(i)});
    return out;
}

std::optional<std::pair<std::size_t, std::size_t>> findOverlap(std::span<const Box3i> boxes)
{
    return findOverlap(boxes.size(), [&](std::size_t i) { return boxes[i]; });
}

std::vector<LeafBox> leafBoxes(std::span<const OverlappingLevel> levels, const Executor& executor,
                               const Progress& progress)
{
    for (const OverlappingLevel& level : levels)
        checkBoxes(level);
    const bool disjoint = areDisjoint(levels);
    if (!disjoint)
        for (const OverlappingLevel& level : levels)
            checkDisjoint(level);
    std::vector<std::vector<LeafBox>> perLevel(levels.size());
    std::vector<Box3i> finer; // all that is finer than the level at hand, and not covered by the one between
    for (std::size_t k = levels.size(); k-- > 0;) {
        const OverlappingLevel& level = levels[k];
        const OverlappingLevel* coarser = k > 0 ? &levels[k - 1] : nullptr;
        if (coarser && coarser->level <= level.level)
            throw Error(level.place,
                        fmt::format("expected a level finer than {}, found {}", coarser->level, level.level));
        perLevel[k] = subtractBoxes(level.boxes, finer, executor, progress);
        for (LeafBox& leaf : perLevel[k])
            leaf.levelIndex = static_cast<std::uint32_t>(k);
        if (coarser && !disjoint)
            finer = holesBelow(level, finer, *coarser, executor, progress);
    }
    std::vector<LeafBox> out;
    for (const auto& leaves : perLevel)
        out.insert(out.end(), leaves.begin(), leaves.end());
    return out;
}

} // namespace brickwall
