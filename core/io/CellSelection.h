// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/ValueSource.h"
#include "brickwall/core/model/Model.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <utility>
#include <vector>

namespace brickwall {

/// Which of a model's cells are meant.
struct CellChoice
{
    std::optional<Box3d> box; ///< world: cells that have a common interior with it; none: all
    int finestLevel = 0;
    int coarsestLevel = maxLevel;
};

/// The chosen cells, as bricks cut out of the model's bricks.
struct CellSelection
{
    std::vector<Brick> bricks;          ///< `begin` counts the chosen cells
    std::vector<std::uint32_t> sources; ///< of each brick: the model's brick that it is cut from
    std::uint64_t cellCount = 0;
};

/// In the order of the model's bricks. A box whose faces are within a millionth of a voxel of cell faces takes no cells
/// beyond them. Where the model's axes are not those of the world, the box in voxel space that has all of `box` counts.
/// Throws Error at `place` if no cell is chosen.
CellSelection selectCells(const Model& model, const CellChoice& choice, std::string_view place);

/// The values of the chosen cells: those of the field, or of a source of values for the model's bricks.
class SelectedValues
{
public:
    SelectedValues(const CellSelection& cells, const Model& model, const Field& field, ValueSource source = {})
        : cells_(cells), model_(model), field_(field), source_(std::move(source))
    {
    }

    const Field& field() const { return field_; }

    /// Of the brick `brick` of the selection: out.size() values from its cell number `first`, x fastest.
    void read(std::size_t brick, std::uint64_t first, std::span<float> out) const;

private:
    const CellSelection& cells_;
    const Model& model_;
    const Field& field_;
    ValueSource source_;
};

} // namespace brickwall
