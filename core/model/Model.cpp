// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/Model.h"

#include "brickwall/core/base/BoxCorners.h"
#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace brickwall {

Box3i voxelBounds(std::span<const Brick> bricks)
{
    Box3i bounds;
    for (const Brick& b : bricks)
        bounds.extend(b.box());
    return bounds;
}

Box3d worldBounds(const Model& model)
{
    const Box3i voxels = voxelBounds(model.bricks);
    if (voxels.empty())
        return {};
    return boundsOfTransformed(model.worldFromVoxel, {vec3d(voxels.lower), vec3d(voxels.upper)});
}

std::vector<std::uint64_t> cellsPerLevel(std::span<const Brick> bricks)
{
    std::vector<std::uint64_t> cells;
    for (const Brick& b : bricks) {
        if (std::size_t(b.level) >= cells.size())
            cells.resize(std::size_t(b.level) + 1);
        cells[std::size_t(b.level)] += b.cellCount();
    }
    return cells;
}

const Field& fieldNamed(const Model& model, std::string_view name)
{
    const auto it =
        std::find_if(model.fields.begin(), model.fields.end(), [&](const Field& f) { return f.name == name; });
    if (it != model.fields.end())
        return *it;
    std::string names;
    for (const Field& f : model.fields)
        names += (names.empty() ? "" : ", ") + f.name;
    throw Error(model.name, fmt::format("has no field '{}'; {}", name,
                                        names.empty() ? "it has no fields at all" : "it has " + names));
}

Range rangeOf(std::span<const float> values)
{
    Range range;
    for (const float v : values) {
        if (std::isnan(v))
            return {v, v};
        range.extend(v);
    }
    return range;
}

} // namespace brickwall
