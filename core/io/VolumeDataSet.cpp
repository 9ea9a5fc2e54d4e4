// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/EmptyCells.h"
#include "brickwall/core/io/FieldNames.h"
#include "brickwall/core/io/InputFile.h"
#include "brickwall/core/io/VolumeCells.h"
#include "brickwall/core/model/CheckModel.h"

#include <fmt/format.h>

#include <utility>

namespace brickwall {
namespace {

class VolumeDataSet : public DataSet
{
public:
    explicit VolumeDataSet(VolumeFile volume) : volume_(std::move(volume)) {}

    std::string format() const override { return volume_.format; }
    std::vector<std::string> fieldNames() const override { return {volume_.field}; }
    std::string defaultField() const override { return volume_.field; }

    /// Which cells there are depends on the values, so that they are read even if no field is asked for.
    Model load(std::span<const std::string> fields, const Executor& executor, Progress& progress,
               NonFinite nonFinite) const override
    {
        const auto wanted = fieldIndices(fieldNames(), fields, volume_.place);
        VolumeCells cells = mergeVolume(volume_, nonFinite, executor, progress);
        Model model;
        model.name = stemOf(volume_.place);
        model.worldFromVoxel = volume_.worldFromVoxel;
        model.bricks = std::move(cells.bricks);
        model.cellCount = cells.cellCount;
        for (std::size_t i = 0; i < wanted.size(); ++i) {
            Field field;
            field.name = volume_.field;
            field.unit = volume_.unit;
            field.values = i + 1 < wanted.size() ? cells.values : std::move(cells.values);
            field.range = rangeOf(field.values);
            model.fields.push_back(std::move(field));
        }
        const vec3i& size = volume_.size;
        if (const std::uint64_t voxels = std::uint64_t(size.x) * size.y * size.z; voxels > model.cellCount)
            model.notes.push_back(
                fmt::format("{}: {} voxels merged into {} cells, where they vary by at most {} of the "
                            "range (threshold)",
                            volume_.place, voxels, model.cellCount, volume_.threshold));
        if (nonFinite == NonFinite::empty)
            leaveOutNonFinite(model, volume_.place, executor, progress);
        for (const std::string& note : model.notes)
            progress.note(note);
        checkModel(model, volume_.place);
        return model;
    }

    std::vector<std::string> files() const override
    {
        if (volume_.data == volume_.place)
            return {volume_.place};
        return {volume_.place, volume_.data};
    }

private:
    VolumeFile volume_;
};

} // namespace

std::unique_ptr<DataSet> makeVolumeDataSet(VolumeFile volume)
{
    checkVolume(volume);
    return std::make_unique<VolumeDataSet>(std::move(volume));
}

} // namespace brickwall
