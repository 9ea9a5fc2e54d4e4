// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/Pyramid.h"

#include "brickwall/core/model/BrickBuilder.h"

#include <algorithm>
#include <array>
#include <tuple>
#include <utility>

namespace brickwall {
namespace {

constexpr vec3i corner(int i)
{
    return {i & 1, i >> 1 & 1, i >> 2};
}

/// A cell that is not averaged inside of its own brick, and the value slot it has in the model.
struct LooseCell
{
    vec3i parent; ///< the cell of the next level that it lies in, counted from the origin
    vec3i lower;  ///< voxel space
    std::uint64_t slot;
};

/// A brick of the coarser model before bricks are merged, and where its values come from.
struct Part
{
    enum class From {
        copy,    ///< the cells of a brick
        average, ///< eight cells each of a brick
        slots    ///< `Plan::slots`, from `first` on
    };

    Brick brick;
    From from;
    std::size_t source; ///< the brick's index, or first
    vec3i firstCell;    ///< of average: in the source brick
};

struct Plan
{
    std::vector<Part> parts;
    std::vector<std::array<std::uint64_t, 8>> slots; ///< per cell, those whose mean it gets

    std::uint64_t cells() const
    {
        return parts.empty() ? 0 : parts.back().brick.begin + parts.back().brick.cellCount();
    }
};

/// The cells of the next level that the brick fills on its own, counted from the origin; may be empty.
Box3i filledParents(const Brick& b)
{
    const vec3i lower = b.lower >> b.level, upper = lower + b.size;
    return {(lower + 1) >> 1, upper >> 1};
}

void addLoose(const Brick& b, const Box3i& filled, std::vector<LooseCell>& loose)
{
    const vec3i first = b.lower >> b.level;
    for (int z = 0; z < b.size.z; ++z)
        for (int y = 0; y < b.size.y; ++y)
            for (int x = 0; x < b.size.x; ++x) {
                const vec3i cell(x, y, z), parent = (first + cell) >> 1;
                if (filled.contains(parent)) {
                    x = 2 * filled.upper.x - first.x - 1; // on to the last one of the row that is averaged
                    continue;
                }
                loose.push_back({parent, b.lower + (cell << b.level), b.slotOf(cell)});
            }
}

/// Cells of which all eight are there become one.
void gatherLoose(std::vector<LooseCell>& loose, int level, std::vector<Cell>& cells,
                 std::vector<std::array<std::uint64_t, 8>>& slots)
{
    const auto key = [](const LooseCell& c) {
        return std::tuple(c.parent.z, c.parent.y, c.parent.x, c.lower.z, c.lower.y, c.lower.x);
    };
    std::sort(loose.begin(), loose.end(), [&](const LooseCell& a, const LooseCell& b) { return key(a) < key(b); });
    for (std::size_t i = 0, end = 0; i < loose.size(); i = end) {
        while (end < loose.size() && loose[end].parent == loose[i].parent)
            ++end;
        if (end - i == 8) {
            cells.push_back({loose[i].parent << (level + 1), level + 1});
            auto& all = slots.emplace_back();
            for (std::size_t j = 0; j < 8; ++j)
                all[j] = loose[i + j].slot;
            continue;
        }
        for (std::size_t j = i; j < end; ++j) {
            cells.push_back({loose[j].lower, level});
            slots.emplace_back().fill(loose[j].slot); // whose mean is the value itself
        }
    }
}

Plan planOf(const Model& model, int level, const Executor& executor, Progress& progress)
{
    Plan plan;
    std::vector<LooseCell> loose;
    for (std::size_t i = 0; i < model.bricks.size(); ++i) {
        const Brick& b = model.bricks[i];
        if (b.level != level) {
            plan.parts.push_back({b, Part::From::copy, i, vec3i(0)});
            continue;
        }
        progress.check();
        const Box3i filled = filledParents(b);
        if (!filled.empty()) {
            const Brick mean{filled.lower << (level + 1), filled.extent(), level + 1, 0};
            plan.parts.push_back({mean, Part::From::average, i, 2 * filled.lower - (b.lower >> level)});
        }
        addLoose(b, filled, loose);
    }
    std::vector<Cell> cells;
    std::vector<std::array<std::uint64_t, 8>> slots;
    gatherLoose(loose, level, cells, slots);
    const BrickLayout layout = buildBricks(cells, "pyramid", {}, executor, progress);
    for (const Brick& b : layout.bricks)
        plan.parts.push_back({b, Part::From::slots, b.begin, vec3i(0)});
    for (const std::uint32_t cell : layout.source)
        plan.slots.push_back(slots[cell]);
    std::uint64_t begin = 0;
    for (Part& part : plan.parts) {
        part.brick.begin = begin;
        begin += part.brick.cellCount();
    }
    return plan;
}

/// In double, as the pairs of a sum of eight floats may be far apart.
void average(const Brick& from, const vec3i& firstCell, const Brick& to, const float* source, float* target)
{
    for (int z = 0; z < to.size.z; ++z)
        for (int y = 0; y < to.size.y; ++y)
            for (int x = 0; x < to.size.x; ++x) {
                double sum = 0.0;
                for (int i = 0; i < 8; ++i)
                    sum += double(source[from.slotOf(firstCell + 2 * vec3i(x, y, z) + corner(i))]);
                *target++ = static_cast<float>(0.125 * sum);
            }
}

std::vector<float> valuesOf(const Plan& plan, const Model& model, const std::vector<float>& source,
                            const Executor& executor, Progress& progress)
{
    std::vector<float> values(plan.cells());
    executor.forEach(plan.parts.size(), 8, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            progress.check();
            const Part& part = plan.parts[i];
            float* target = values.data() + part.brick.begin;
            const std::size_t cells = part.brick.cellCount();
            if (part.from == Part::From::copy)
                std::copy_n(source.data() + model.bricks[part.source].begin, cells, target);
            else if (part.from == Part::From::average)
                average(model.bricks[part.source], part.firstCell, part.brick, source.data(), target);
            else
                for (std::size_t c = 0; c < cells; ++c) {
                    double sum = 0.0;
                    for (const std::uint64_t slot : plan.slots[part.source + c])
                        sum += double(source[slot]);
                    target[c] = static_cast<float>(0.125 * sum);
                }
        }
        progress.advance(end - begin);
    });
    return values;
}

/// Bricks that are not merged, or merged with another copy of the values meanwhile.
Model coarsened(const Model& model, const Plan& plan, bool merged, const Executor& executor, Progress& progress)
{
    Model coarser;
    coarser.name = model.name;
    coarser.worldFromVoxel = model.worldFromVoxel;
    coarser.cellCount = plan.cells();
    for (const Part& part : plan.parts)
        coarser.bricks.push_back(part.brick);
    std::vector<std::uint32_t> source;
    if (merged) {
        BrickLayout layout = mergeBricks(coarser.bricks, {}, executor, progress);
        coarser.bricks = std::move(layout.bricks);
        source = std::move(layout.source);
    }
    for (const Field& field : model.fields) {
        progress.begin("averaging cells", plan.parts.size());
        Field mean{
            field.name, field.unit, valuesOf(plan, model, field.values, executor, progress), {}, field.preferredRange};
        if (merged)
            mean.values = gather(mean.values, source, executor);
        mean.range = rangeOf(mean.values);
        coarser.fields.push_back(std::move(mean));
    }
    progress.end();
    return coarser;
}

PyramidMember memberOf(const Model& model, int level, const Executor& executor, Progress& progress)
{
    PyramidMember member;
    member.level = level;
    member.cells = model.cellCount;
    const auto regions = std::make_shared<RegionTree>(buildRegions(model.bricks, executor, progress));
    for (const Field& field : model.fields)
        member.fields.push_back(
            std::make_shared<PaddedField>(padField(field, model.bricks, *regions, executor, progress)));
    member.regions = regions;
    return member;
}

} // namespace

Model coarsen(const Model& model, int level, const Executor& executor, Progress& progress)
{
    return coarsened(model, planOf(model, level, executor, progress), true, executor, progress);
}

std::size_t PyramidMember::bytes() const
{
    std::size_t sum = regions->bytes();
    for (const auto& field : fields)
        sum += field->bytes();
    return sum;
}

std::vector<PyramidMember> buildPyramid(const Model& model, const PyramidConfig& config, const Executor& executor,
                                        Progress& progress)
{
    std::vector<PyramidMember> members;
    if (model.bricks.empty())
        return members;
    int level = maxLevel, coarsest = 0;
    for (const Brick& b : model.bricks) {
        level = std::min(level, b.level);
        coarsest = std::max(coarsest, b.level);
    }
    std::uint64_t kept = model.cellCount, before = kept;
    Model last;
    for (; kept > config.leastCells && level < maxLevel; ++level) {
        const Model& source = last.bricks.empty() ? model : last;
        const Plan plan = planOf(source, level, executor, progress);
        if (plan.cells() == before && level >= coarsest)
            break; // ragged all over: nothing will ever be averaged
        before = plan.cells();
        const bool isMember = double(before) <= config.mostCells * double(kept);
        last = coarsened(source, plan, isMember, executor, progress);
        if (!isMember)
            continue;
        kept = before;
        members.push_back(memberOf(last, level + 1, executor, progress));
    }
    return members;
}

} // namespace brickwall
