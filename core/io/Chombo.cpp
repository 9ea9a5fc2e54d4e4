// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/ChomboLevels.h"
#include "brickwall/core/io/Formats.h"
#include "brickwall/core/io/Hdf5Box.h"
#include "brickwall/core/io/Hdf5DataSet.h"
#include "brickwall/core/io/InputFile.h"

#include <fmt/format.h>

#include <memory>
#include <utility>

namespace brickwall {
namespace {

/// The arrays of a field on all levels.
std::vector<ChomboArray> openArrays(const Hdf5File& file, const ChomboLevels& levels, const ChomboField& field)
{
    std::vector<ChomboArray> arrays;
    for (std::size_t level = 0; level < levels.boxes.size(); ++level) {
        arrays.push_back(openChomboArray(file, levels, level, field.array));
        if (field.component >= arrays.back().components)
            throw Error(arrays.back().values.place(),
                        fmt::format("expected more than {} components, as level_0 has, found {}", field.component,
                                    arrays.back().components));
    }
    return arrays;
}

Hdf5BoxPlace placeOf(const Box3i& box, const ChomboArray& array, std::size_t index, std::int64_t component)
{
    const Box3i grown{box.lower - array.ghosts, box.upper + array.ghosts};
    const vec3i size = grown.extent();
    const std::uint64_t plane = std::uint64_t(size.x) * size.y;
    const std::uint64_t begin = array.offsets[index] + plane * size.z * static_cast<std::uint64_t>(component);
    return {grown, {begin}, {plane}, 0, plane};
}

std::vector<std::string> namesOf(const std::vector<ChomboField>& fields)
{
    std::vector<std::string> names;
    for (const ChomboField& field : fields)
        names.push_back(field.name);
    return names;
}

class ChomboDataSet : public Hdf5DataSet
{
public:
    ChomboDataSet(Hdf5File file, std::vector<ChomboField> fields)
        : Hdf5DataSet(std::move(file), namesOf(fields)), fields_(std::move(fields))
    {
    }

    std::string format() const override { return "Chombo"; }

private:
    Layout readLayout(const Executor& executor, Progress& progress) const override
    {
        const auto levels = std::make_shared<const ChomboLevels>(readChomboLevels(file()));
        const auto open = [this, levels](std::size_t index) -> OpenBox {
            const ChomboField& field = fields_[index];
            const auto arrays = std::make_shared<const std::vector<ChomboArray>>(openArrays(file(), *levels, field));
            return [&field, levels, arrays](const LeafJob& job) {
                const ChomboArray& array = (*arrays)[job.levelIndex];
                const Box3i& box = levels->boxes[job.levelIndex].boxes[job.box];
                return std::make_unique<Hdf5Box>(array.values, placeOf(box, array, job.box, field.component));
            };
        };
        return {planLeaves(levels->boxes, file().path(), executor, progress), levels->worldFromVoxel, open};
    }

    std::vector<ChomboField> fields_;
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
