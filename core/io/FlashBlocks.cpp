// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/FlashBlocks.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
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

/// The blocks of the file, leaves or not.
class BlockTable
{
public:
    BlockTable(const Hdf5File& file, std::uint64_t count) : place_(file.path() + ": /bounding box")
    {
        const std::uint64_t one[]{count}, faces[]{count, 3, 2};
        const Hdf5Data refine = file.data("refine level"), node = file.data("node type"),
                       bounds = file.data("bounding box");
        refine.expectShape(one);
        node.expectShape(one);
        bounds.expectShape(faces);
        refine_ = refine.integers();
        node_ = node.integers();
        bounds_ = bounds.numbers();
        for (const std::int64_t level : refine_)
            if (level < 1 || level > 64)
                throw Error(refine.place(), fmt::format("expected levels from 1 to 64, found {}", level));
        for (std::size_t b = 0; b < refine_.size(); ++b)
            checkBounds(b);
        measure();
    }

    std::size_t count() const { return refine_.size(); }
    bool isLeaf(std::size_t block) const { return node_[block] == 1; }
    int refineLevel(std::size_t block) const { return static_cast<int>(refine_[block]); }
    const vec3d& lower() const { return lower_; }
    /// Of a block of that level.
    vec3d extent(int refineLevel) const { return coarsestExtent_ / std::exp2(refineLevel - coarsest_); }

    /// Which block of its level it is, counted from the domain's lower corner.
    vec3d gridPlace(std::size_t block) const
    {
        constexpr double tolerance = 0.05; // of a block: numbers are floats, in which a place is coarser than a cell
        vec3d place{0.0};
        for (int axis = 0; axis < 3; ++axis) {
            const double width = extent(refineLevel(block))[axis];
            const double lower = (face(block, axis, 0) - lower_[axis]) / width;
            const double upper = (face(block, axis, 1) - lower_[axis]) / width;
            place[axis] = std::round(lower);
            if (!(std::abs(lower - place[axis]) < tolerance && std::abs(upper - place[axis] - 1.0) < tolerance))
                throw Error(place_, fmt::format("block {}: expected a block of refine level {}, {} wide along {}, at a "
                                                "whole number of them from {}, found {} to {}",
                                                block, refineLevel(block), width, "xyz"[axis], lower_[axis],
                                                face(block, axis, 0), face(block, axis, 1)));
        }
        return place;
    }

private:
    double face(std::size_t block, int axis, int side) const
    {
        return bounds_[(block * 3 + static_cast<std::size_t>(axis)) * 2 + static_cast<std::size_t>(side)];
    }

    void checkBounds(std::size_t block) const
    {
        for (int axis = 0; axis < 3; ++axis)
            if (!(face(block, axis, 0) < face(block, axis, 1)) || !std::isfinite(face(block, axis, 0)) ||
                !std::isfinite(face(block, axis, 1)))
                throw Error(place_, fmt::format("block {}: expected a lower and a higher number along {}, found {} and "
                                                "{}",
                                                block, "xyz"[axis], face(block, axis, 0), face(block, axis, 1)));
    }

    /// The domain is a whole number of the coarsest blocks wide: that makes their extent as exact as the domain's.
    void measure()
    {
        if (refine_.empty())
            throw Error(place_, "expected blocks, found none");
        Box3d domain;
        for (std::size_t b = 0; b < count(); ++b)
            domain.extend(
                Box3d{{face(b, 0, 0), face(b, 1, 0), face(b, 2, 0)}, {face(b, 0, 1), face(b, 1, 1), face(b, 2, 1)}});
        lower_ = domain.lower;
        const auto first = std::min_element(refine_.begin(), refine_.end());
        const std::size_t block = static_cast<std::size_t>(first - refine_.begin());
        coarsest_ = refineLevel(block);
        for (int axis = 0; axis < 3; ++axis) {
            const double extent = face(block, axis, 1) - face(block, axis, 0);
            const double blocks = std::max(1.0, std::round(domain.extent()[axis] / extent));
            coarsestExtent_[axis] = domain.extent()[axis] / blocks;
        }
    }

    std::string place_;
    std::vector<std::int64_t> refine_, node_;
    std::vector<double> bounds_;
    vec3d lower_{0.0};
    int coarsest_ = 1;
    vec3d coarsestExtent_{1.0};
};

Box3i cellsOf(const vec3d& place, const vec3i& size, const std::string& where, std::size_t block)
{
    const vec3d lower = place * vec3d(size);
    if (glm::any(glm::greaterThan(lower + vec3d(size), vec3d(coordinateLimit))))
        throw Error(where, fmt::format("block {}: expected at most {} cells along each axis, found one that ends "
                                       "beyond",
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
    const BlockTable table(file, out.shape[0]);

    std::map<int, std::size_t> indices; // of levels, by refine level
    for (std::size_t b = 0; b < table.count(); ++b)
        if (table.isLeaf(b))
            indices[table.refineLevel(b)] = 0;
    if (indices.empty())
        throw Error(file.path() + ": /node type", "expected leaf blocks, which have a 1, found none");
    const int finest = indices.rbegin()->first, coarsest = indices.begin()->first;
    if (finest - coarsest > maxLevel)
        throw Error(file.path() + ": /refine level",
                    fmt::format("expected at most {} levels, found {} to {}", maxLevel + 1, coarsest, finest));
    for (auto& [refine, index] : indices) {
        index = out.levels.size();
        out.levels.push_back(
            {fmt::format("{}: leaf blocks of refine level {}", file.path(), refine), finest - refine, {}});
    }
    out.blocks.resize(out.levels.size());
    for (std::size_t b = 0; b < table.count(); ++b)
        if (table.isLeaf(b)) {
            const std::size_t index = indices[table.refineLevel(b)];
            out.levels[index].boxes.push_back(cellsOf(table.gridPlace(b), size, file.path() + ": /bounding box", b));
            out.blocks[index].push_back(b);
        }
    out.worldFromVoxel = worldFromIndices(table.lower(), vec3i(0), table.extent(finest) / vec3d(size));
    return out;
}

} // namespace brickwall
