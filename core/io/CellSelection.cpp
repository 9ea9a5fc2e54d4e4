// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/CellSelection.h"

#include "brickwall/core/base/BoxCorners.h"
#include "brickwall/core/base/Error.h"

#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

constexpr double snap = 1e-6; // voxels: more than the rounding of a transform, less than anyone means

/// The voxels that have a common interior with a box of the world.
Box3i voxelsOf(const Box3d& world, const mat4d& worldFromVoxel)
{
    const Box3d box = boundsOfTransformed(glm::inverse(worldFromVoxel), world);
    constexpr double limit = coordinateLimit;
    Box3i voxels;
    for (int axis = 0; axis < 3; ++axis) {
        voxels.lower[axis] = static_cast<int>(std::floor(std::clamp(box.lower[axis] + snap, -limit, limit)));
        voxels.upper[axis] = static_cast<int>(std::ceil(std::clamp(box.upper[axis] - snap, -limit, limit)));
    }
    return voxels;
}

/// The cells of a brick that have a common interior with the box: the box of these cells, which may be empty.
Box3i cutOut(const Brick& brick, const Box3i& box)
{
    const Box3i common = brick.box().intersection(box);
    if (common.empty())
        return common;
    // Bricks are aligned to their cells; shifts round towards minus infinity.
    const int level = brick.level, width = brick.cellWidth();
    Box3i cells;
    for (int axis = 0; axis < 3; ++axis) {
        cells.lower[axis] = (common.lower[axis] >> level) * width;
        cells.upper[axis] = ((common.upper[axis] + width - 1) >> level) * width;
    }
    return cells;
}

} // namespace

CellSelection selectCells(const Model& model, const CellChoice& choice, std::string_view place)
{
    const Box3i all{vec3i(-coordinateLimit), vec3i(coordinateLimit)};
    const Box3i box = choice.box ? voxelsOf(*choice.box, model.worldFromVoxel) : all;
    CellSelection selection;
    for (std::size_t i = 0; i < model.bricks.size(); ++i) {
        const Brick& brick = model.bricks[i];
        const Box3i cells = cutOut(brick, box);
        if (cells.empty() || brick.level < choice.finestLevel || brick.level > choice.coarsestLevel)
            continue;
        selection.bricks.push_back({cells.lower, cells.extent() / brick.cellWidth(), brick.level, selection.cellCount});
        selection.sources.push_back(static_cast<std::uint32_t>(i));
        selection.cellCount += selection.bricks.back().cellCount();
    }
    if (selection.bricks.empty())
        throw Error(place, "there are no cells in this box and of these levels");
    return selection;
}

void SelectedValues::read(std::size_t brick, std::uint64_t first, std::span<float> out) const
{
    const Brick& part = cells_.bricks[brick];
    const Brick& whole = model_.bricks[cells_.sources[brick]];
    const vec3i offset = (part.lower - whole.lower) / part.cellWidth();
    for (std::size_t done = 0; done < out.size();) {
        const std::uint64_t cell = first + done;
        const auto x = static_cast<int>(cell % part.size.x);
        const std::uint64_t row = cell / part.size.x;
        const auto y = static_cast<int>(row % part.size.y), z = static_cast<int>(row / part.size.y);
        const std::size_t n = std::min<std::size_t>(part.size.x - x, out.size() - done);
        const std::uint64_t from = whole.slotOf(offset + vec3i(x, y, z));
        if (source_)
            source_(cells_.sources[brick], from - whole.begin, out.subspan(done, n));
        else
            std::copy_n(field_.values.data() + from, n, out.data() + done);
        done += n;
    }
}

} // namespace brickwall
