// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Box.h"
#include "brickwall/core/base/Range.h"
#include "brickwall/core/base/Vec.h"

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace brickwall {

/// The coarsest level that coordinates can carry: 2^level has to fit an int with room for a support.
inline constexpr int maxLevel = 24;

/// Voxel coordinates lie in [-coordinateLimit, coordinateLimit]: exact in half-voxel ints and, relative to a nearby
/// origin, in float.
inline constexpr int coordinateLimit = 1 << 28;

/// A cell: a cube of 2^level voxels with its lower corner at `lower` (voxel space, a multiple of 2^level). The layout
/// is that of a record of ExaBrick's `.cells`.
struct Cell
{
    vec3i lower;
    int level;
};
static_assert(sizeof(Cell) == 16);

/// A brick: size.x * size.y * size.z cells of one level, all of them present. `lower` is in voxel space and a multiple
/// of 2^level; `begin` is the index of its first value in Field::values, x fastest: begin + ix + size.x * (iy + size.y
/// * iz).
struct Brick
{
    vec3i lower;
    vec3i size;
    int level = 0;
    std::uint64_t begin = 0;

    std::uint64_t cellCount() const { return std::uint64_t(size.x) * size.y * size.z; }
    int cellWidth() const { return 1 << level; }
    /// The index of a cell's value in Field::values; `cell` counts from the brick's lower corner.
    std::uint64_t slotOf(const vec3i& cell) const
    {
        return begin + std::uint64_t(cell.x) + std::uint64_t(size.x) * (cell.y + std::uint64_t(size.y) * cell.z);
    }
    /// The brick's box in voxel space, upper exclusive.
    Box3i box() const { return {lower, lower + size * cellWidth()}; }
};
static_assert(sizeof(Brick) == 40);

/// One named scalar per cell, in the order of the bricks. All values are finite.
struct Field
{
    std::string name;
    std::string unit;          ///< as the file gives it; empty if it does not
    std::vector<float> values; ///< one per cell of the model
    Range range;               ///< of the values
    Range preferredRange;      ///< what the file says to show (ExaBrick's value_range); empty if it does not
};

/// Opaque triangles that belong to the data, in world space.
struct TriangleMesh
{
    std::vector<vec3f> vertices;
    std::vector<vec3i> triangles;
    vec3f color{0.8f}; ///< linear RGB, before shading
};

/// What a reader yields and everything else starts from: disjoint bricks of leaf cells with the values of the fields
/// that were asked for.
///
/// Invariants (`checkModel` in CheckModel.h asserts them, readers call it): bricks do not overlap; each is aligned to
/// its level and inside coordinateLimit; `begin` counts up without gaps in the order of the bricks, so that the last
/// brick ends at cellCount; every field has cellCount finite values; worldFromVoxel is affine and invertible. Holes
/// between bricks are legal.
struct Model
{
    std::string name; ///< for titles: the file's stem
    std::vector<Brick> bricks;
    std::vector<Field> fields;
    std::vector<TriangleMesh> meshes;
    mat4d worldFromVoxel{1.0};
    std::uint64_t cellCount = 0;
    std::vector<std::string> notes; ///< what was repaired or left out while reading, one line each
};

/// Of all bricks' boxes, in voxel space.
Box3i voxelBounds(std::span<const Brick> bricks);

/// The world-space box of the voxel bounds' eight transformed corners.
Box3d worldBounds(const Model& model);

/// Cells per level; index = level, length = coarsest level + 1.
std::vector<std::uint64_t> cellsPerLevel(std::span<const Brick> bricks);

/// The field of that name; an Error lists the names there are.
const Field& fieldNamed(const Model& model, std::string_view name);

/// The smallest range that has all values; ignores nothing, so a NaN would poison it.
Range rangeOf(std::span<const float> values);

} // namespace brickwall
