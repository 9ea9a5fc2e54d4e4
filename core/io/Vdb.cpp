// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/ArrayFields.h"
#include "brickwall/core/io/DataName.h"
#include "brickwall/core/io/FieldNames.h"
#include "brickwall/core/io/Formats.h"
#include "brickwall/core/io/LeafFields.h"
#include "brickwall/core/io/VdbArray.h"
#include "brickwall/core/io/VdbLeaves.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace brickwall {
namespace {

using Grids = std::vector<openvdb::GridBase::Ptr>;

/// The values of an array in cells of any level.
class CellValues
{
public:
    CellValues(const Grids& grids, const std::vector<VdbLevel>& levels) : levels_(levels)
    {
        for (const auto& grid : grids)
            values_.push_back(valuesOf(*grid));
    }

    /// At the cell's centre: of the finest grid that is active there, else what the coarsest has there.
    std::array<double, 3> at(const vec3i& lower, int width)
    {
        const vec3i centre = lower + width / 2;
        std::array<double, 3> value{};
        for (std::size_t g = 0; g < values_.size(); ++g) {
            const int level = levels_[g].level;
            const openvdb::Coord cell(centre.x >> level, centre.y >> level, centre.z >> level);
            if (values_[g]->at(cell - levels_[g].shift, value))
                break;
        }
        return value;
    }

private:
    const std::vector<VdbLevel>& levels_;
    std::vector<std::unique_ptr<VdbValues>> values_;
};

double scalarOf(const std::array<double, 3>& value, int component)
{
    return component == ArrayField::magnitude ? std::hypot(value[0], value[1], value[2])
                                              : value[static_cast<std::size_t>(component)];
}

class VdbDataSet : public DataSet
{
public:
    VdbDataSet(VdbFile file, bool background)
        : file_(std::move(file)), arrays_(arraysOf(file_.grids())), background_(background)
    {
        for (const VdbArray& array : arrays_)
            appendArrayFields(array.name, array.components, fields_);
    }

    std::string format() const override { return "OpenVDB"; }
    std::vector<std::string> fieldNames() const override { return namesOf(fields_); }

    /// The magnitude, if the first array is of vectors.
    std::string defaultField() const override
    {
        const std::string usual = usualField(fieldNames());
        return usual == fields_[0].name && fields_[0].components == 3 ? fields_[3].name : usual;
    }

    Model load(std::span<const std::string> names, const Executor& executor, Progress& progress,
               NonFinite nonFinite) const override
    {
        const auto wanted = fieldIndices(fieldNames(), names, file_.path());
        const std::vector<const VdbArray*> arrays = arraysFor(wanted);
        const VdbFrame frame = frameOf(arrays, file_.path());
        Grids grids;
        LeafPlan plan = planCells(arrays, frame, grids, progress);
        std::vector<Field> fields(wanted.size());
        for (std::size_t a = 0; a < arrays.size(); ++a) {
            if (arrays.size() > 1)
                grids = readGrids(*arrays[a], progress);
            for (std::size_t i = 0; i < wanted.size(); ++i)
                if (fields_[wanted[i]].array == arrays[a]->name)
                    fields[i] =
                        readField(plan, fields_[wanted[i]], grids, frame.levels[a], nonFinite, executor, progress);
        }
        grids.clear();
        return leafModel(std::move(plan), std::move(fields), worldFromIndices(frame.lower, vec3i(0), frame.voxelSize),
                         file_.path(), nonFinite, executor, progress);
    }

    std::vector<std::string> files() const override { return {file_.path()}; }

private:
    /// Without wanted fields those of the default one, for the cells.
    std::vector<const VdbArray*> arraysFor(const std::vector<std::size_t>& wanted) const
    {
        std::vector<const VdbArray*> some;
        for (const VdbArray& array : arrays_)
            if (std::any_of(wanted.begin(), wanted.end(),
                            [&](std::size_t i) { return fields_[i].array == array.name; }))
                some.push_back(&array);
        if (some.empty())
            some.push_back(&arrays_[0]);
        return some;
    }

    Grids readGrids(const VdbArray& array, Progress& progress) const
    {
        progress.begin(fmt::format("reading {}", array.name), array.grids.size());
        Grids grids;
        for (const VdbGridInfo& info : array.grids) {
            progress.check();
            grids.push_back(file_.read(info));
            progress.advance(1);
        }
        progress.end();
        return grids;
    }

    /// Keeps the grids of the last array in `grids`.
    LeafPlan planCells(const std::vector<const VdbArray*>& arrays, const VdbFrame& frame, Grids& grids,
                       Progress& progress) const
    {
        std::vector<VdbMask> masks(static_cast<std::size_t>(frame.coarsest) + 1);
        for (std::size_t l = 0; l < masks.size(); ++l)
            masks[l].level.level = static_cast<int>(l);
        for (std::size_t a = 0; a < arrays.size(); ++a) {
            grids = readGrids(*arrays[a], progress);
            for (std::size_t g = 0; g < grids.size(); ++g)
                addGrid(*grids[g], frame.levels[a][g], masks);
        }
        if (background_)
            fillBounds(masks);
        // Of several arrays one may have voxels of another level where the other has a tile.
        const bool tiles = !background_ && (arrays.size() == 1 || frame.coarsest == 0);
        return vdbLeaves(std::move(masks), tiles, file_.path(), progress);
    }

    void addGrid(const openvdb::GridBase& grid, const VdbLevel& level, std::vector<VdbMask>& masks) const
    {
        VdbMask& mask = masks[static_cast<std::size_t>(level.level)];
        if (mask.active.empty())
            mask.level = level;
        else if (mask.level.shift != level.shift)
            throw Error(file_.path(),
                        fmt::format("expected grids of one voxel size to count from the same origin, found "
                                    "grid '{}' elsewhere; load its field alone",
                                    grid.getName()));
        addActive(grid, mask.active);
    }

    /// Makes all voxels of the coarsest level active within the bounds of those that are, on any level.
    void fillBounds(std::vector<VdbMask>& masks) const
    {
        const VdbLevel& to = masks.back().level;
        openvdb::CoordBBox bounds;
        std::uint64_t stored = 0;
        for (const VdbMask& mask : masks) {
            openvdb::CoordBBox box;
            stored += storedCount(mask.active);
            if (!mask.active.evalActiveVoxelBoundingBox(box))
                continue;
            const int steps = to.level - mask.level.level;
            for (const openvdb::Coord& c : {box.min() + mask.level.shift, box.max() + mask.level.shift})
                bounds.expand(openvdb::Coord(c.x() >> steps, c.y() >> steps, c.z() >> steps) - to.shift);
        }
        if (bounds.empty())
            return;
        checkExpansion(volumeOf(bounds), stored, file_.path() + ":background");
        masks.back().active.denseFill(bounds, true, true);
    }

    Field readField(const LeafPlan& plan, const ArrayField& wanted, const Grids& grids,
                    const std::vector<VdbLevel>& levels, NonFinite nonFinite, const Executor& executor,
                    Progress& progress) const
    {
        progress.begin(fmt::format("taking {}", wanted.name), plan.cellCount);
        Field field;
        field.name = wanted.name;
        field.values.resize(plan.cellCount);
        executor.forEach(plan.bricks.size(), 16, [&](std::size_t begin, std::size_t end) {
            CellValues values(grids, levels);
            for (std::size_t b = begin; b < end; ++b) {
                progress.check();
                fill(plan.bricks[b], wanted, values, nonFinite, field.values.data() + plan.bricks[b].begin);
                progress.advance(plan.bricks[b].cellCount());
            }
        });
        field.range = rangeOf(field.values);
        progress.end();
        return field;
    }

    void fill(const Brick& brick, const ArrayField& wanted, CellValues& values, NonFinite nonFinite, float* out) const
    {
        for (int z = 0; z < brick.size.z; ++z)
            for (int y = 0; y < brick.size.y; ++y)
                for (int x = 0; x < brick.size.x; ++x) {
                    const vec3i lower = brick.lower + vec3i(x, y, z) * brick.cellWidth();
                    const double value = scalarOf(values.at(lower, brick.cellWidth()), wanted.component);
                    *out = static_cast<float>(value);
                    if (!std::isfinite(*out++) && nonFinite == NonFinite::error)
                        failNotFinite(
                            value, file_.path(), wanted.name,
                            fmt::format("the cell of level {} at ({},{},{})", brick.level, lower.x, lower.y, lower.z));
                }
    }

    VdbFile file_;
    std::vector<VdbArray> arrays_;
    std::vector<ArrayField> fields_;
    bool background_;
};

} // namespace

std::unique_ptr<DataSet> openVdb(const std::string& data)
{
    const DataName name = splitDataName(data);
    if (!isVdb(name.file))
        return nullptr;
    for (const std::string& option : name.options)
        if (option != "background")
            throw Error(data, fmt::format("expected the option background, found '{}'", option));
    return std::make_unique<VdbDataSet>(VdbFile(name.file), !name.options.empty());
}

} // namespace brickwall
