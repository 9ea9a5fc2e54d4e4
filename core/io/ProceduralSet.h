// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/model/Model.h"

#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

/// A field that is a function of position, in world space. May be called from any number of threads.
struct ProceduralField
{
    std::string name;
    std::string unit;
    std::function<double(const vec3d& world)> value;
};

/// Data that know their own answer: functions, and the grid on which they are sampled. The grid starts with rootBlocks
/// blocks of 8^3 cells of level `levels - 1`; the lower corner of the first is voxel (0, 0, 0).
struct ProceduralSet
{
    std::string name;
    std::vector<ProceduralField> fields;                 ///< the first is the default
    std::function<double(const vec3d& world)> refinedBy; ///< cells are small where this changes
    vec3i rootBlocks{1};
    int levels = 1;
    std::uint64_t cells = 0; ///< wanted
    mat4d worldFromVoxel{1.0};
};

/// Air past a ball, at rest in it, and the street of vortices behind it; `refinedBy` is the speed. World unit: the
/// ball's diameter; the ball's centre is the origin, the stream has speed 1 along x. Four levels.
ProceduralSet proceduralWake(std::uint64_t cells);

/// An interstellar cloud: log-normal density over eight decades and more, few clumps and filaments in thin gas.
/// `refinedBy` is the logarithm of the density. World unit: parsec, centred. Five levels (below 1M cells the coarsest
/// may be refined away).
ProceduralSet proceduralCloud(std::uint64_t cells);

/// Blast waves in air: spherical fronts and a plume whose skins are a few of the finest cells thick, in a domain that
/// is coarse elsewhere. World unit: kilometre; the ground is z = 0. Seven levels or more; `refinedBy` is the
/// temperature.
ProceduralSet proceduralImpact(std::uint64_t cells);

/// The grid: blocks of 8^3 leaf cells, in a deterministic order. Starting from the root blocks those with the largest
/// difference of `refinedBy` between neighbouring cell corners are refined first, until there are about `set.cells`
/// cells or nothing changes anywhere. Levels of blocks that share a face differ by at most one. Throws Cancelled.
std::vector<Brick> refineBlocks(const ProceduralSet& set, const Executor& executor, Progress& progress);

/// The field at the centres of a brick's cells, from its cell number `first` on, x fastest.
void sampleBrick(const ProceduralField& field, const mat4d& worldFromVoxel, const Brick& brick, std::uint64_t first,
                 std::span<float> values);

/// The field at all cells' centres, in the order of the bricks. Throws Cancelled.
Field sampleField(const ProceduralField& field, const mat4d& worldFromVoxel, std::span<const Brick> bricks,
                  const Executor& executor, Progress& progress);

/// worldFromVoxel of a grid whose root blocks, together `width` world units wide along x, start at `lower`.
mat4d worldFromGrid(const vec3d& lower, double width, int rootBlocks, int levels);

} // namespace brickwall
