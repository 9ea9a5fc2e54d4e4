// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/DataName.h"
#include "brickwall/core/io/Formats.h"
#include "brickwall/core/io/Hdf5DataSet.h"
#include "brickwall/core/io/InputFile.h"
#include "brickwall/core/io/VtkHdfLevels.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <memory>
#include <utility>

namespace brickwall {
namespace {

/// A box of a level. Components are side by side: all are read, and one or their magnitude is made of them.
class VtkHdfBox : public BoxReader
{
public:
    VtkHdfBox(const VtkHdfArray& array, std::uint64_t offset, const Box3i& box, const ArrayField& field)
        : data_(array.values), offset_(offset), box_(box), field_(field)
    {
    }

    std::string place() const override { return data_.place(); }
    Box3i box() const override { return box_; }

    void read(int zBegin, int zEnd, std::vector<double>& values) override
    {
        const std::uint64_t plane = std::uint64_t(box_.extent().x) * box_.extent().y;
        const std::uint64_t cells = plane * static_cast<std::uint64_t>(zEnd - zBegin);
        std::vector<std::uint64_t> start{offset_ + plane * static_cast<std::uint64_t>(zBegin - box_.lower.z), 0};
        std::vector<std::uint64_t> count{cells, static_cast<std::uint64_t>(field_.components)};
        start.resize(data_.shape().size());
        count.resize(data_.shape().size());
        data_.read(start, count, values);
        const std::size_t stride = static_cast<std::size_t>(field_.components);
        if (stride > 1)
            for (std::size_t i = 0; i < cells; ++i)
                values[i] = scalarOf(values.data() + i * stride);
        values.resize(cells);
    }

private:
    double scalarOf(const double* v) const
    {
        return field_.component == ArrayField::magnitude ? std::hypot(v[0], v[1], v[2]) : v[field_.component];
    }

    const Hdf5Data& data_;
    std::uint64_t offset_;
    Box3i box_;
    const ArrayField& field_;
};

class VtkHdfDataSet : public Hdf5DataSet
{
public:
    VtkHdfDataSet(Hdf5File file, std::vector<ArrayField> fields, std::int64_t step)
        : Hdf5DataSet(std::move(file), namesOf(fields)), fields_(std::move(fields)), step_(step)
    {
    }

    std::string format() const override { return "VTKHDF overlapping AMR"; }

    Model load(std::span<const std::string> fields, const Executor& executor, Progress& progress,
               NonFinite nonFinite) const override
    {
        Model model = Hdf5DataSet::load(fields, executor, progress, nonFinite);
        if (const std::int64_t count = vtkHdfStepCount(file()); count > 1) {
            model.notes.push_back(fmt::format("{}: step {} of 0 to {} is read, time {}; FILE:step=N chooses another",
                                              file().path(), step_, count - 1, vtkHdfTime(file(), step_)));
            progress.note(model.notes.back());
        }
        return model;
    }

private:
    Layout readLayout(const Executor& executor, Progress& progress) const override
    {
        const auto levels = std::make_shared<const VtkHdfLevels>(readVtkHdfLevels(file(), step_));
        const auto open = [this, levels](std::size_t index) -> OpenBox {
            const ArrayField& field = fields_[index];
            const auto arrays = std::make_shared<std::vector<VtkHdfArray>>();
            for (std::size_t level = 0; level < levels->boxes.size(); ++level)
                arrays->push_back(openVtkHdfArray(file(), *levels, level, field, step_));
            return [&field, levels, arrays](const LeafJob& job) {
                const Box3i& box = levels->boxes[job.levelIndex].boxes[job.box];
                const VtkHdfArray& array = (*arrays)[job.levelIndex];
                return std::make_unique<VtkHdfBox>(array, array.offsets[job.box], box, field);
            };
        };
        return {planLeaves(levels->boxes, file().path(), executor, progress), levels->worldFromVoxel, open};
    }

    std::vector<ArrayField> fields_;
    std::int64_t step_;
};

std::int64_t chosenStep(const DataName& name, const Hdf5File& file, const std::string& data)
{
    const std::int64_t count = vtkHdfStepCount(file);
    std::int64_t step = 0;
    for (const std::string& option : name.options) {
        const std::string number = option.starts_with("step=") ? option.substr(5) : "";
        const auto [end, error] = std::from_chars(number.data(), number.data() + number.size(), step);
        if (number.empty() || error != std::errc() || end != number.data() + number.size() || step < 0 || step >= count)
            throw Error(data, fmt::format("expected step=N with N from 0 to {}, found '{}'", count - 1, option));
    }
    return step;
}

} // namespace

std::unique_ptr<DataSet> openVtkHdf(const std::string& data)
{
    const DataName name = splitDataName(data);
    if (!isRegularFile(name.file) || !looksLikeHdf5(name.file))
        return nullptr;
    Hdf5File file(name.file);
    if (!file.hasAttribute("VTKHDF", "Type"))
        return nullptr;
    const std::string type = file.text("VTKHDF", "Type");
    if (type != "OverlappingAMR")
        throw Error(fmt::format("{}: attribute 'Type' of /VTKHDF", name.file),
                    fmt::format("expected OverlappingAMR, found {}, which is not read", type));
    std::vector<ArrayField> fields = readVtkHdfFields(file);
    const std::int64_t step = chosenStep(name, file, data);
    return std::make_unique<VtkHdfDataSet>(std::move(file), std::move(fields), step);
}

} // namespace brickwall
