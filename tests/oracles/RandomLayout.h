// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Model.h"

#include <cstdint>
#include <span>
#include <vector>

namespace brickwall::oracles {

/// A small random number generator whose numbers are the same on every machine (SplitMix64; Steele et al. 2014).
class Random
{
public:
    explicit Random(std::uint64_t seed) : state_(seed) {}

    std::uint64_t bits();
    /// In [0, 1).
    double real();
    /// In [0, count).
    int below(int count) { return int(real() * count); }

private:
    std::uint64_t state_;
};

/// Blocks that are refined, left out or cut in two at random: what adaptive codes write, and worse.
struct RandomLayoutConfig
{
    std::uint64_t seed = 1;
    int coarsestLevel = 2;
    vec3i rootBlocks{2, 2, 2};
    int blockWidth = 4;   ///< cells per axis of a block
    vec3i lower{0, 0, 0}; ///< of the first root block; a multiple of the coarsest cell width
    double refined = 0.4; ///< probability that a block is refined
    double jump = 0.3;    ///< of those, refined by 4 instead of 2
    double hole = 0.1;    ///< probability that a block is left out
    double cut = 0.5;     ///< probability that a leaf block becomes two bricks, and those again
};

/// Disjoint aligned bricks with contiguous `begin`. At least one.
std::vector<Brick> randomLayout(const RandomLayoutConfig& config);

/// blocks.x * blocks.y * blocks.z bricks of one level, `width` cells per axis each, side by side.
std::vector<Brick> uniformBlocks(const vec3i& blocks, int width, int level = 0, const vec3i& lower = vec3i(0));

/// Cubes of blocks, each nested in the middle of the coarser one around it, which is left out there: `levels` levels of
/// blocks of `width` cells per axis; the level's cube is `blocks` blocks wide, a multiple of 4.
std::vector<Brick> nestedLevels(int levels, int blocks, int width);

/// Sets `begin` of all bricks; returns the number of cells.
std::uint64_t numberCells(std::vector<Brick>& bricks);

/// All cells of the bricks, in the order of their values.
std::vector<Cell> cellsOfBricks(std::span<const Brick> bricks);

/// Uniform values in [-1, 1], one per cell.
Field randomField(std::span<const Brick> bricks, std::uint64_t seed);

} // namespace brickwall::oracles
