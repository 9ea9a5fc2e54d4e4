// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/oracles/Fields.h"

#include <glm/common.hpp>

#include <utility>

namespace brickwall::oracles {

Model modelOf(std::vector<Brick> bricks, const std::function<double(const vec3d&)>& value, const mat4d& worldFromVoxel)
{
    Model model;
    model.name = "oracle";
    model.worldFromVoxel = worldFromVoxel;
    Field field{"f", "", {}, {}, {}};
    for (Brick& brick : bricks) {
        brick.begin = field.values.size();
        for (int k = 0; k < brick.size.z; ++k)
            for (int j = 0; j < brick.size.y; ++j)
                for (int i = 0; i < brick.size.x; ++i)
                    field.values.push_back(
                        float(value(vec3d(brick.lower) + (vec3d(i, j, k) + 0.5) * double(brick.cellWidth()))));
    }
    field.range = rangeOf(field.values);
    model.cellCount = field.values.size();
    model.bricks = std::move(bricks);
    model.fields.push_back(std::move(field));
    return model;
}

std::vector<Brick> oneLevelBricks(const vec3i& lower, const vec3i& size, const vec3i& brickCells, int level)
{
    std::vector<Brick> bricks;
    for (int k = 0; k < size.z; k += brickCells.z)
        for (int j = 0; j < size.y; j += brickCells.y)
            for (int i = 0; i < size.x; i += brickCells.x) {
                const vec3i at(i, j, k);
                bricks.push_back({(lower + at) * (1 << level), glm::min(brickCells, size - at), level, 0});
            }
    return bricks;
}

} // namespace brickwall::oracles
