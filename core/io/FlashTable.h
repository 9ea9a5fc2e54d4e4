// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"
#include "brickwall/core/io/Hdf5File.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace brickwall {

/// The blocks of a FLASH file, leaves or not, and where they lie.
///
/// `bounding box` has a number per face in the file's units, often in float only: the faces are put on the grid of
/// their level, in the domain that all blocks together have. Where float is too coarse for that, deep down and far from
/// the origin, a block's place follows from its parent's, as `gid` lists the children of each block.
class FlashTable
{
public:
    /// Throws Error for tables of other shapes than `count` blocks have, and for numbers that cannot be.
    FlashTable(const Hdf5File& file, std::uint64_t count);

    std::size_t count() const { return refine_.size(); }
    bool isLeaf(std::size_t block) const { return leaf_[block] != 0; }
    int refineLevel(std::size_t block) const { return refine_[block]; }
    const vec3d& lower() const { return lower_; }
    /// Of a block of that level.
    vec3d extent(int refineLevel) const;

    /// Calls body(block, place) for all leaves in their order. The place is counted in blocks of its level, from the
    /// domain's lower corner. Throws Error for blocks that are not where an octree has them.
    void forEachLeaf(const std::function<void(std::size_t block, const vec3d& place)>& body) const;

private:
    struct Faces
    {
        double at[6]; ///< lower and upper along x, along y, along z
        double lower(int axis) const { return at[2 * axis]; }
        double upper(int axis) const { return at[2 * axis + 1]; }
    };
    /// Which child of which block a block is.
    struct Tree
    {
        std::vector<std::uint32_t> parent; ///< none: the block itself
        std::vector<std::uint8_t> child;   ///< 0 to 7, x fastest
        std::vector<vec3d> place;          ///< of the blocks of the coarsest level
    };

    void readLevels(const Hdf5File& file);
    void measure();
    void checkFaces(std::size_t block, const Faces& faces) const;
    /// A piece of the table at a time: a million blocks that mean harm should not need much memory.
    void forEachBlock(const std::function<void(std::size_t block, const Faces& faces)>& body) const;
    /// How many blocks of its level a block's faces are away from the place, at most.
    double distance(std::size_t block, const Faces& faces, const vec3d& place) const;
    vec3d nearestPlace(std::size_t block, const Faces& faces) const;
    /// How far faces in float may be away from where they should be, in blocks of that level.
    double floatError(int refineLevel) const;
    Tree readTree() const;
    /// None if the tree does not lead to the coarsest level.
    std::optional<vec3d> placeInTree(std::size_t block, const Tree& tree) const;
    [[noreturn]] void failPlace(std::size_t block, const Faces& faces) const;

    Hdf5Data bounds_;
    std::optional<Hdf5Data> children_; ///< `gid`
    std::vector<std::uint8_t> refine_, leaf_;
    vec3d lower_{0.0}, upper_{0.0};
    int coarsest_ = 1;
    vec3d coarsestExtent_{1.0};
};

} // namespace brickwall
