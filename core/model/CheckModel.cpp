// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/CheckModel.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/model/BrickIndex.h"

#include <fmt/format.h>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

std::string described(std::span<const Brick> bricks, std::size_t i)
{
    const Brick& b = bricks[i];
    return fmt::format("brick {} (lower {} {} {}, size {} {} {}, level {})", i, b.lower.x, b.lower.y, b.lower.z,
                       b.size.x, b.size.y, b.size.z, b.level);
}

/// What is wrong with one brick on its own, or nothing. Tests in an order in which no arithmetic overflows.
std::string faultOf(const Brick& b, std::uint64_t begin)
{
    if (b.level < 0 || b.level > maxLevel)
        return fmt::format("expected a level from 0 to {}", maxLevel);
    for (int a = 0; a < 3; ++a) {
        const char axis = "xyz"[a];
        if (b.size[a] < 1)
            return fmt::format("expected at least one cell along {}, found {}", axis, b.size[a]);
        const std::int64_t upper = b.lower[a] + (std::int64_t(b.size[a]) << b.level);
        if (b.lower[a] < -coordinateLimit || upper > coordinateLimit)
            return fmt::format("expected coordinates from {} to {}, found {} to {} along {}", -coordinateLimit,
                               coordinateLimit, b.lower[a], upper, axis);
        if ((b.lower[a] & (b.cellWidth() - 1)) != 0)
            return fmt::format("expected a lower corner that is a multiple of the cell width {}, found {} along {}",
                               b.cellWidth(), b.lower[a], axis);
    }
    if (b.begin != begin)
        return fmt::format("expected its values to begin at {}, found {}", begin, b.begin);
    return {};
}

void checkDisjoint(std::span<const Brick> bricks, std::string_view place)
{
    const auto overlap = findOverlap(bricks);
    if (!overlap)
        return;
    const auto [i, j] = *overlap;
    const vec3i p = glm::max(bricks[i].lower, bricks[j].lower);
    throw Error(place, fmt::format("expected disjoint bricks, found that {} and {} overlap at voxel {} {} {}",
                                   described(bricks, i), described(bricks, j), p.x, p.y, p.z));
}

void checkValues(const Field& field, std::span<const Brick> bricks, std::string_view place)
{
    const auto bad = std::find_if(field.values.begin(), field.values.end(), [](float v) { return !std::isfinite(v); });
    if (bad == field.values.end())
        return;
    const auto slot = std::uint64_t(bad - field.values.begin());
    const auto after = std::upper_bound(bricks.begin(), bricks.end(), slot,
                                        [](std::uint64_t s, const Brick& b) { return s < b.begin; });
    const auto brick = std::size_t(after - bricks.begin()) - 1;
    const Brick& b = bricks[brick];
    const std::uint64_t cell = slot - b.begin;
    throw Error(place, fmt::format("expected finite values in field '{}', found {} in cell {} {} {} of {}", field.name,
                                   *bad, cell % b.size.x, cell / b.size.x % b.size.y,
                                   cell / (std::uint64_t(b.size.x) * b.size.y), described(bricks, brick)));
}

void checkTransform(const mat4d& m, std::string_view place)
{
    for (int c = 0; c < 4; ++c)
        for (int r = 0; r < 4; ++r)
            if (!std::isfinite(m[c][r]))
                throw Error(place,
                            fmt::format("expected a finite transform from voxels to the world, found {} in row {}, "
                                        "column {}",
                                        m[c][r], r, c));
    if (m[0][3] != 0.0 || m[1][3] != 0.0 || m[2][3] != 0.0 || m[3][3] != 1.0)
        throw Error(place,
                    fmt::format("expected an affine transform from voxels to the world, found the last row {} {} {} {}",
                                m[0][3], m[1][3], m[2][3], m[3][3]));
    const double det = glm::determinant(m);
    if (!std::isfinite(det) || det == 0.0)
        throw Error(
            place, fmt::format("expected an invertible transform from voxels to the world, found determinant {}", det));
}

} // namespace

void checkBricks(std::span<const Brick> bricks, std::string_view place)
{
    std::uint64_t begin = 0;
    for (std::size_t i = 0; i < bricks.size(); ++i) {
        const std::string fault = faultOf(bricks[i], begin);
        if (!fault.empty())
            throw Error(place, described(bricks, i) + ": " + fault);
        begin += bricks[i].cellCount();
    }
    checkDisjoint(bricks, place);
}

void checkLayout(const Model& model, std::string_view place)
{
    checkBricks(model.bricks, place);
    const std::uint64_t cells = model.bricks.empty() ? 0 : model.bricks.back().begin + model.bricks.back().cellCount();
    if (model.cellCount != cells)
        throw Error(place,
                    fmt::format("expected a cell count of {} as the bricks have, found {}", cells, model.cellCount));
    for (const Field& field : model.fields)
        if (field.values.size() != cells)
            throw Error(place, fmt::format("expected {} values in field '{}', one per cell, found {}", cells,
                                           field.name, field.values.size()));
    checkTransform(model.worldFromVoxel, place);
}

void checkModel(const Model& model, std::string_view place)
{
    checkLayout(model, place);
    for (const Field& field : model.fields)
        checkValues(field, model.bricks, place);
}

} // namespace brickwall
