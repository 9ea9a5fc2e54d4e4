// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/model/Model.h"

#include <cstdint>
#include <span>
#include <vector>

namespace brickwall {

/// A brick with room for one layer of neighbour cells all around: its values lie at `begin` in PaddedField::values with
/// (size + 2) cells per axis, x fastest; index (0,0,0) there is cell (-1,-1,-1) of the brick.
struct PaddedBrick
{
    vec3i lower; ///< of the brick itself, voxel space
    vec3i size;  ///< of the brick itself, in cells
    int level = 0;
    std::uint64_t begin = 0;

    int cellWidth() const { return 1 << level; }
    vec3i paddedSize() const { return size + 2; }
};
static_assert(sizeof(PaddedBrick) == 40);

/// An active brick region (ABR; Wald et al., "Ray Tracing Structured AMR Data Using ExaBricks", 2021): a box in which
/// the same list of bricks contributes everywhere.
///
/// With one brick in its list, B is the trilinear interpolant of that brick's padded values (D = 1, or clamped where
/// there is nothing beyond the brick). With several, B = N / D over the tents of the bricks' own cells; padding is not
/// used.
struct Region
{
    vec3i lower; ///< in half voxels, so that the supports' faces are exact
    vec3i upper;
    std::uint32_t firstBrick; ///< in RegionTree::brickLists
    std::uint16_t brickCount;
    std::uint8_t finestLevel; ///< of the listed bricks
    std::uint8_t coarsestLevel;
};
static_assert(sizeof(Region) == 32);

/// A node of the kd-tree over the regions. An inner node splits its box at `plane` (half voxels) across `axis` 0, 1 or
/// 2; its children are nodes[child] (lower side) and nodes[child + 1]. A leaf (axis 3) is region `child`, or emptyLeaf.
/// Both sides of a node closer to the root lie before, the children after it in the array; the root is node 0.
struct KdNode
{
    static constexpr std::uint32_t emptyLeaf = 0x3fffffff;

    std::int32_t plane = 0;
    std::uint32_t axis : 2 = 3;
    std::uint32_t child : 30 = emptyLeaf;
};
static_assert(sizeof(KdNode) == 8);

/// Partitions the union of all bricks' supports into regions. Depends on the bricks alone; fields come with padField.
/// Immutable once built, so that any number of threads may read it.
struct RegionTree
{
    Box3i bounds; ///< of the union of supports, in half voxels
    std::vector<KdNode> nodes;
    std::vector<Region> regions;
    std::vector<std::uint32_t> brickLists; ///< indices of bricks
    std::vector<PaddedBrick> bricks;       ///< in the order of the model's bricks
    std::uint64_t paddedCellCount = 0;     ///< length of PaddedField::values
    int depth = 0;                         ///< of the deepest node, root = 0

    std::size_t bytes() const;
};

/// Deterministic, whatever the executor. Throws Cancelled.
RegionTree buildRegions(std::span<const Brick> bricks, const Executor& executor, Progress& progress);

/// A field ready to be sampled: padded values, and per region the range of exactly the cells whose tents reach it.
struct PaddedField
{
    std::vector<float> values;
    std::vector<Range> regionRanges; ///< one per region
    /// One per region: how fast B changes along any ray in it, at most, per voxel. For one brick a bound, from the
    /// largest difference of neighbours along each axis; for several an estimate, from the range and the finest width.
    std::vector<float> regionSlopes;
    /// The same of ln B, where all values of the region are positive; else 0. An estimate: between two neighbours ln B is
    /// taken to change evenly.
    std::vector<float> regionLogSlopes;
    Range range;

    std::size_t bytes() const;
};

PaddedField padField(const Field& field, std::span<const Brick> bricks, const RegionTree& tree,
                     const Executor& executor, Progress& progress);

/// The region that has the point (half-open boxes, half voxels as double), or -1.
std::int64_t findRegion(const RegionTree& tree, const vec3d& halfVoxel);

} // namespace brickwall
