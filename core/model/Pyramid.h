// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/model/Model.h"
#include "brickwall/core/model/Regions.h"

#include <cstdint>
#include <memory>
#include <vector>

namespace brickwall {

/// The model with its cells of `level` averaged into cells of level + 1, in all fields: eight cells that fill a cell of
/// the next level become that cell, with their mean. Where fewer are there (at a ragged edge, around a hole) they stay
/// as they are, and so do all cells of other levels: the same space is filled, and sums of value times volume are kept.
/// A field that is linear in space stays the same function at the centres of its cells.
///
/// The bricks are merged anew. Meshes and notes are left out. Deterministic, whatever the executor. Throws Cancelled.
Model coarsen(const Model& model, int level, const Executor& executor, Progress& progress);

/// A member of a pyramid: the data with every cell finer than `level` averaged into cells of that level.
struct PyramidMember
{
    int level = 0;
    std::uint64_t cells = 0;
    std::shared_ptr<const RegionTree> regions;
    std::vector<std::shared_ptr<const PaddedField>> fields; ///< in the order of the model's

    std::size_t bytes() const;
};

struct PyramidConfig
{
    /// A member is kept if it has at most this share of the cells of the one before: data whose cells are mostly coarse
    /// already gain nothing from members that repeat them. Bounds what all members take together.
    double mostCells = 0.25;
    /// What has no more cells than this gets no coarser members.
    std::uint64_t leastCells = 4096;
};

/// The members of a model, ascending by level: each the average of the one before, as long as that pays. For data of
/// one level all of them take a seventh of the memory that the data take, and what more there is for edges of bricks;
/// for others up to a third (docs/decisions/0037). May be empty. Throws Cancelled.
std::vector<PyramidMember> buildPyramid(const Model& model, const PyramidConfig& config, const Executor& executor,
                                        Progress& progress);

} // namespace brickwall
