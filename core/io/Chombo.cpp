// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/ChomboLevels.h"
#include "brickwall/core/io/FieldNames.h"
#include "brickwall/core/io/Formats.h"
#include "brickwall/core/io/Hdf5Box.h"
#include "brickwall/core/io/Hdf5File.h"
#include "brickwall/core/io/InputFile.h"

#include <fmt/format.h>

#include <utility>

namespace brickwall {
namespace {

class ChomboDataSet : public DataSet
{
public:
    ChomboDataSet(Hdf5File file, std::vector<ChomboField> fields) : file_(std::move(file)), fields_(std::move(fields))
    {
        for (const ChomboField& field : fields_)
            names_.push_back(field.name);
    }

    std::string format() const override { return "Chombo"; }
    std::vector<std::string> fieldNames() const override { return names_; }
    std::string defaultField() const override { return usualField(names_); }

    Model load(std::span<const std::string> fields, const Executor& executor, Progress& progress,
               NonFinite nonFinite) const override
    {
        const std::string& place = file_.path();
        const auto wanted = fieldIndices(names_, fields, place);
        const ChomboLevels levels = readChomboLevels(file_);
        LeafPlan plan = planLeaves(levels.boxes, place, executor, progress);
        std::vector<Field> read;
        for (const std::size_t i : wanted)
            read.push_back(readField(fields_[i], levels, plan, executor, progress, nonFinite));
        return leafModel(std::move(plan), std::move(read), levels.worldFromVoxel, place, nonFinite, executor, progress);
    }

private:
    Field readField(const ChomboField& field, const ChomboLevels& levels, const LeafPlan& plan,
                    const Executor& executor, Progress& progress, NonFinite nonFinite) const
    {
        std::vector<ChomboArray> arrays;
        for (std::size_t level = 0; level < levels.boxes.size(); ++level) {
            arrays.push_back(openChomboArray(file_, levels, level, field.array));
            if (field.component >= arrays.back().components)
                throw Error(arrays.back().values.place(), fmt::format("expected more than {} components, as level_0 "
                                                                      "has, found {}",
                                                                      field.component, arrays.back().components));
        }
        const auto open = [&](const LeafJob& job) {
            const Box3i& box = levels.boxes[job.levelIndex].boxes[job.box];
            const ChomboArray& array = arrays[job.levelIndex];
            return std::make_unique<Hdf5Box>(array.values, placeOf(box, array, job.box, field.component));
        };
        return readLeafField(plan, field.name, open, nonFinite, executor, progress);
    }

    static Hdf5BoxPlace placeOf(const Box3i& box, const ChomboArray& array, std::size_t index, std::int64_t component)
    {
        const Box3i grown{box.lower - array.ghosts, box.upper + array.ghosts};
        const vec3i size = grown.extent();
        const std::uint64_t plane = std::uint64_t(size.x) * size.y;
        const std::uint64_t begin = array.offsets[index] + plane * size.z * static_cast<std::uint64_t>(component);
        return {grown, {begin}, {plane}, 0, plane};
    }

    Hdf5File file_;
    std::vector<ChomboField> fields_;
    std::vector<std::string> names_;
};

} // namespace

std::unique_ptr<DataSet> openChombo(const std::string& data)
{
    if (!isRegularFile(data) || !looksLikeHdf5(data))
        return nullptr;
    Hdf5File file(data);
    if (!file.hasAttribute("Chombo_global", "SpaceDim") || !file.hasAttribute("", "num_levels"))
        return nullptr;
    std::vector<ChomboField> fields = readChomboFields(file);
    return std::make_unique<ChomboDataSet>(std::move(file), std::move(fields));
}

} // namespace brickwall
