// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/VdbArray.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/model/Model.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string_view>

namespace brickwall {
namespace {

/// "velocity" for "velocity_L2" and "velocity_level_2"; any other name as it is.
std::string withoutLevel(const std::string& name)
{
    const std::size_t end = name.find_last_not_of("0123456789");
    if (end == std::string::npos || end + 1 == name.size())
        return name;
    const std::string_view head = std::string_view(name).substr(0, end + 1);
    for (const std::string_view suffix : {"_L", "_level", "_level_", "_lev"})
        if (head.ends_with(suffix) && head.size() > suffix.size())
            return std::string(head.substr(0, head.size() - suffix.size()));
    return name;
}

bool hasSize(const VdbArray& array, const vec3d& voxelSize)
{
    return std::any_of(array.grids.begin(), array.grids.end(), [&](const VdbGridInfo& g) {
        return std::abs(g.voxelSize.x - voxelSize.x) <= 1e-3 * voxelSize.x;
    });
}

int componentsOf(const std::string& type)
{
    return type.starts_with("Tree_vec3") ? 3 : 1;
}

/// How many times coarser than the finest, as a power of two.
int levelOf(const VdbGridInfo& grid, const vec3d& finest, const std::string& place)
{
    const vec3d ratio = grid.voxelSize / finest;
    const int level = static_cast<int>(std::lround(std::log2(std::min(ratio.x, 1e9))));
    for (int axis = 0; axis < 3; ++axis)
        if (!(std::abs(ratio[axis] - std::ldexp(1.0, level)) <= 1e-3 * ratio[axis]) || level > maxLevel)
            throw Error(place,
                        fmt::format("expected voxel sizes that are powers of two times the finest, {} {} {}, found "
                                    "{} {} {} in grid '{}'",
                                    finest.x, finest.y, finest.z, grid.voxelSize.x, grid.voxelSize.y, grid.voxelSize.z,
                                    grid.name));
    return level;
}

/// In cells of the grid, from the lower corner of the frame.
openvdb::Coord shiftOf(const VdbGridInfo& grid, const vec3d& corner, const vec3d& cellSize, const std::string& place)
{
    const vec3d cells = (grid.lower - corner) / cellSize;
    const vec3d shift = glm::round(cells);
    for (int axis = 0; axis < 3; ++axis)
        if (!(std::abs(cells[axis] - shift[axis]) <= 1e-3) || !(std::abs(shift[axis]) <= coordinateLimit))
            throw Error(place,
                        fmt::format("expected the voxels of all levels to have corners in common, found grid '{}' "
                                    "shifted by {} voxels along {} against the coarsest grid",
                                    grid.name, cells[axis], "xyz"[axis]));
    return {int(shift.x), int(shift.y), int(shift.z)};
}

/// Calls work(grid) with the grid as what it is.
template <class Work>
void withType(const openvdb::GridBase& grid, const Work& work)
{
    using Types = openvdb::TypeList<openvdb::FloatGrid, openvdb::DoubleGrid, openvdb::Int32Grid, openvdb::Int64Grid,
                                    openvdb::Vec3SGrid, openvdb::Vec3DGrid, openvdb::Vec3IGrid>;
    if (!grid.apply<Types>(work))
        throw Error(grid.getName(), fmt::format("expected a grid of numbers, found {}", grid.type()));
}

template <class T>
void spread(const T& value, std::array<double, 3>& out)
{
    out[0] = static_cast<double>(value);
}

template <class T>
void spread(const openvdb::math::Vec3<T>& value, std::array<double, 3>& out)
{
    for (int c = 0; c < 3; ++c)
        out[static_cast<std::size_t>(c)] = static_cast<double>(value[c]);
}

template <class Grid>
class TypedValues : public VdbValues
{
public:
    explicit TypedValues(const Grid& grid) : accessor_(grid.getConstAccessor()) {}

    bool at(const openvdb::Coord& voxel, std::array<double, 3>& value) override
    {
        typename Grid::ValueType stored;
        const bool active = accessor_.probeValue(voxel, stored);
        spread(stored, value);
        return active;
    }

private:
    typename Grid::ConstAccessor accessor_;
};

/// Active tiles of `tiles` become voxels where `other` has voxels: a union of masks would keep the tile.
template <class Tree>
void splitTiles(openvdb::MaskTree& tiles, const Tree& other)
{
    for (auto leaf = other.cbeginLeaf(); leaf; ++leaf)
        if (tiles.isValueOn(leaf->origin()))
            tiles.touchLeaf(leaf->origin());
}

} // namespace

std::vector<VdbArray> arraysOf(const std::vector<VdbGridInfo>& grids)
{
    std::vector<VdbArray> arrays;
    for (const VdbGridInfo& grid : grids) {
        // "density[1]" is what a second grid "density" is called.
        std::string base = withoutLevel(grid.name.substr(0, grid.name.find('[')));
        auto array = std::find_if(arrays.begin(), arrays.end(), [&](const VdbArray& a) { return a.name == base; });
        if (array != arrays.end() &&
            (hasSize(*array, grid.voxelSize) || array->components != componentsOf(grid.type))) {
            base = grid.name;
            array = arrays.end();
        }
        if (array == arrays.end())
            array = arrays.insert(arrays.end(), VdbArray{base, componentsOf(grid.type), {}});
        array->grids.push_back(grid);
    }
    for (VdbArray& array : arrays)
        std::stable_sort(array.grids.begin(), array.grids.end(),
                         [](const VdbGridInfo& a, const VdbGridInfo& b) { return a.voxelSize.x < b.voxelSize.x; });
    return arrays;
}

VdbFrame frameOf(const std::vector<const VdbArray*>& arrays, const std::string& place)
{
    const VdbGridInfo* finest = &arrays[0]->grids.front();
    const VdbGridInfo* coarsest = &arrays[0]->grids.back();
    for (const VdbArray* array : arrays) {
        if (array->grids.front().voxelSize.x < finest->voxelSize.x)
            finest = &array->grids.front();
        if (array->grids.back().voxelSize.x > coarsest->voxelSize.x)
            coarsest = &array->grids.back();
    }
    VdbFrame frame;
    frame.voxelSize = finest->voxelSize;
    frame.lower = coarsest->lower;
    for (const VdbArray* array : arrays) {
        frame.levels.emplace_back();
        for (const VdbGridInfo& grid : array->grids) {
            const int level = levelOf(grid, frame.voxelSize, place);
            frame.levels.back().push_back(
                {level, shiftOf(grid, frame.lower, frame.voxelSize * std::ldexp(1.0, level), place)});
            frame.coarsest = std::max(frame.coarsest, level);
        }
    }
    return frame;
}

std::unique_ptr<VdbValues> valuesOf(const openvdb::GridBase& grid)
{
    std::unique_ptr<VdbValues> values;
    withType(grid,
             [&](const auto& typed) { values = std::make_unique<TypedValues<std::decay_t<decltype(typed)>>>(typed); });
    return values;
}

void addActive(const openvdb::GridBase& grid, openvdb::MaskTree& mask)
{
    withType(grid, [&](const auto& typed) {
        openvdb::MaskTree own(false);
        own.topologyUnion(typed.tree());
        splitTiles(mask, own);
        splitTiles(own, mask);
        mask.topologyUnion(own);
    });
}

} // namespace brickwall
