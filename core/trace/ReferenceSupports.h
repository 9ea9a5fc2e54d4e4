// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Box.h"
#include "brickwall/core/model/Regions.h"

#include <cstdint>
#include <span>
#include <vector>

namespace brickwall::reference {

/// A ray org + t dir in double, in voxels.
struct Line
{
    vec3d org, dir;

    vec3d at(double t) const { return org + t * dir; }
};

/// Part of a ray inside the support of a brick.
struct Crossing
{
    std::uint32_t brick;
    double t0, t1;
};

/// Finds the supports that a ray crosses: a hierarchy of boxes halved at the median brick. Immutable.
class Supports
{
public:
    explicit Supports(std::span<const PaddedBrick> bricks);

    /// Replaces `crossings` by those of positive length inside [tNear, tFar], in no particular order.
    void cross(const Line& line, double tNear, double tFar, std::vector<Crossing>& crossings) const;

private:
    /// Items [first, first + count) of `order_`, or, if count is 0, nodes `first` and `first + 1`.
    struct Node
    {
        Box3d box;
        std::uint32_t first = 0, count = 0;
    };

    void split(std::uint32_t node, std::uint32_t first, std::uint32_t count);

    std::vector<Box3d> boxes_;
    std::vector<std::uint32_t> order_;
    std::vector<Node> nodes_;
};

/// The box grown by half a cell width.
Box3d supportOf(const PaddedBrick& brick);

} // namespace brickwall::reference
