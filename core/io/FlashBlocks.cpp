// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/FlashBlocks.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/FlashTable.h"

#include <fmt/format.h>

#include <map>

namespace brickwall {
namespace {

void checkGeometry(const Hdf5File& file)
{
    for (const char* list : {"string scalars", "string runtime parameters"}) {
        if (!file.has(list))
            continue;
        const std::vector<std::string> names = file.data(list).texts("name"), values = file.data(list).texts("value");
        for (std::size_t i = 0; i < names.size(); ++i)
            if (names[i] == "geometry" && values[i] != "cartesian")
                throw Error(fmt::format("{}: /{}", file.path(), list),
                            fmt::format("expected the geometry 'cartesian', found '{}'", values[i]));
    }
}

/// The cells of one block along each axis.
vec3i blockSize(const std::vector<std::uint64_t>& shape, const std::string& place)
{
    if (shape.size() != 4)
        throw Error(place,
                    fmt::format("expected an array of blocks, z, y and x, found the shape {}", shapeText(shape)));
    vec3i size{0};
    for (int axis = 0; axis < 3; ++axis) {
        const std::uint64_t n = shape[static_cast<std::size_t>(3 - axis)];
        if (n < 1 || n > coordinateLimit)
            throw Error(place, fmt::format("expected blocks of 1 to {} cells along {}, found {}", coordinateLimit,
                                           "xyz"[axis], n));
        size[axis] = static_cast<int>(n);
    }
    if (size.y == 1 || size.z == 1)
        throw Error(place, fmt::format("expected data of three dimensions, found blocks of {} x {} x {} cells", size.x,
                                       size.y, size.z));
    return size;
}

Box3i cellsOf(const vec3d& place, const vec3i& size, const Hdf5File& file, std::size_t block)
{
    const vec3d lower = place * vec3d(size);
    if (glm::any(glm::greaterThan(lower + vec3d(size), vec3d(coordinateLimit))))
        throw Error(file.path() + ": /bounding box",
                    fmt::format("block {}: expected at most {} cells along each axis, found one that ends beyond",
                                block, coordinateLimit));
    return {vec3i(lower), vec3i(lower) + size};
}

} // namespace

FlashBlocks readFlashBlocks(const Hdf5File& file, const std::string& anyField)
{
    checkGeometry(file);
    const Hdf5Data field = file.data(anyField);
    FlashBlocks out;
    out.shape = field.shape();
    const vec3i size = blockSize(out.shape, field.place());
    const FlashTable table(file, out.shape[0]);

    std::map<int, std::size_t> leaves; // how many, by refine level
    for (std::size_t b = 0; b < table.count(); ++b)
        if (table.isLeaf(b))
            ++leaves[table.refineLevel(b)];
    if (leaves.empty())
        throw Error(file.path() + ": /node type", "expected leaf blocks, which have a 1, found none");
    const int finest = leaves.rbegin()->first, coarsest = leaves.begin()->first;
    if (finest - coarsest > maxLevel)
        throw Error(file.path() + ": /refine level",
                    fmt::format("expected at most {} levels, found {} to {}", maxLevel + 1, coarsest, finest));
    std::map<int, std::size_t> indices; // of levels, by refine level
    for (const auto& [refine, count] : leaves) {
        indices[refine] = out.levels.size();
        out.levels.push_back(
            {fmt::format("{}: leaf blocks of refine level {}", file.path(), refine), finest - refine, {}});
        out.levels.back().boxes.reserve(count);
        out.blocks.emplace_back().reserve(count);
    }
    table.forEachLeaf([&](std::size_t b, const vec3d& place) {
        const std::size_t index = indices.at(table.refineLevel(b));
        out.levels[index].boxes.push_back(cellsOf(place, size, file, b));
        out.blocks[index].push_back(static_cast<std::uint32_t>(b));
    });
    out.worldFromVoxel = worldFromIndices(table.lower(), vec3i(0), table.extent(finest) / vec3d(size));
    return out;
}

} // namespace brickwall
