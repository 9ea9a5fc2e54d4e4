// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/EmptyCells.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/model/BrickBuilder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace brickwall {
namespace {

bool isEmpty(const Model& model, std::uint64_t slot)
{
    return std::any_of(model.fields.begin(), model.fields.end(),
                       [&](const Field& field) { return !std::isfinite(field.values[slot]); });
}

bool hasEmptyCells(const Model& model, const Brick& brick)
{
    return std::any_of(model.fields.begin(), model.fields.end(), [&](const Field& field) {
        const auto first = field.values.begin() + std::ptrdiff_t(brick.begin);
        return !std::all_of(first, first + std::ptrdiff_t(brick.cellCount()), [](float v) { return std::isfinite(v); });
    });
}

/// Cells that are taken out of their bricks, with the slots of their values.
struct LooseCells
{
    std::vector<Cell> cells;
    std::vector<std::uint64_t> slots;
};

void appendFullCells(const Model& model, const Brick& brick, LooseCells& loose)
{
    std::uint64_t slot = brick.begin;
    for (int z = 0; z < brick.size.z; ++z)
        for (int y = 0; y < brick.size.y; ++y)
            for (int x = 0; x < brick.size.x; ++x, ++slot)
                if (!isEmpty(model, slot)) {
                    loose.cells.push_back({brick.lower + vec3i(x, y, z) * brick.cellWidth(), brick.level});
                    loose.slots.push_back(slot);
                }
}

/// Whole bricks first, then carved ones.
struct Carved
{
    std::vector<Brick> whole; ///< with `begin` in the old values
    LooseCells loose;
    BrickLayout layout; ///< of the loose cells
};

std::vector<float> valuesOf(const Carved& carved, const std::vector<float>& old)
{
    std::vector<float> values;
    for (const Brick& brick : carved.whole) {
        const auto first = old.begin() + std::ptrdiff_t(brick.begin);
        values.insert(values.end(), first, first + std::ptrdiff_t(brick.cellCount()));
    }
    for (const std::uint32_t cell : carved.layout.source)
        values.push_back(old[carved.loose.slots[cell]]);
    return values;
}

} // namespace

void leaveOutNonFinite(Model& model, std::string_view place, const Executor& executor, Progress& progress)
{
    progress.begin("looking for cells without a finite value", model.bricks.size());
    Carved carved;
    for (const Brick& brick : model.bricks) {
        progress.check();
        if (hasEmptyCells(model, brick))
            appendFullCells(model, brick, carved.loose);
        else
            carved.whole.push_back(brick);
        progress.advance(1);
    }
    progress.end();
    const std::size_t emptied = model.bricks.size() - carved.whole.size();
    if (emptied == 0)
        return;
    if (!carved.loose.cells.empty())
        carved.layout = buildBricks(carved.loose.cells, place, {}, executor, progress);
    for (Field& field : model.fields) {
        field.values = valuesOf(carved, field.values);
        field.range = rangeOf(field.values);
    }
    const std::uint64_t before = model.cellCount;
    model.bricks = carved.whole;
    model.bricks.insert(model.bricks.end(), carved.layout.bricks.begin(), carved.layout.bricks.end());
    model.cellCount = 0;
    for (Brick& brick : model.bricks) {
        brick.begin = model.cellCount;
        model.cellCount += brick.cellCount();
    }
    if (model.cellCount == 0)
        throw Error(place, "expected cells with finite values, found none");
    model.notes.push_back(fmt::format("{}: {} cells without a finite value left out, in {} bricks; the other {} cells "
                                      "of these carved into {} bricks",
                                      place, before - model.cellCount, emptied, carved.layout.source.size(),
                                      carved.layout.bricks.size()));
}

} // namespace brickwall
