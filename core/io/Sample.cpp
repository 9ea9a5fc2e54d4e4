// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/Sample.h"

#include "brickwall/core/model/BrickBuilder.h"
#include "brickwall/core/model/CheckModel.h"
#include "brickwall/core/model/MergeBoxes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

namespace brickwall {
namespace {

constexpr std::string_view prefix = "sample:";
constexpr double fewestCells = 50e3, mostCells = 2000e6;

struct Sample
{
    std::string_view name;
    std::uint64_t cells; ///< if nobody says how many
    ProceduralSet (*make)(std::uint64_t cells);
};

constexpr std::array samples{Sample{"wake", 1500000, proceduralWake}, Sample{"cloud", 2000000, proceduralCloud},
                             Sample{"impact", 1500000, proceduralImpact}};

std::string allNames()
{
    std::string list;
    for (const Sample& sample : samples)
        list += fmt::format("{}{}", list.empty() ? "" : ", ", sample.name);
    return list;
}

/// "1.5M" -> 1500000.
std::uint64_t parseCells(const std::string& data, std::string_view size)
{
    double count = 0.0;
    const auto [end, error] = std::from_chars(size.data(), size.data() + size.size(), count);
    const std::string_view unit(end, std::size_t(size.data() + size.size() - end));
    const double factor = unit == "M" ? 1e6 : unit == "k" ? 1e3 : unit.empty() ? 1.0 : 0.0;
    const double cells = count * factor;
    if (error != std::errc() || !(cells >= fewestCells && cells <= mostCells))
        throw Error(
            data,
            fmt::format("expected a number of cells from 50k to 2000M, such as 500k, 1.5M or 100M, found '{}'", size));
    return std::uint64_t(cells + 0.5);
}

class SampleDataSet : public DataSet
{
public:
    SampleDataSet(std::string data, ProceduralSet set) : data_(std::move(data)), set_(std::move(set)) {}

    std::string format() const override { return "sample"; }

    std::vector<std::string> fieldNames() const override
    {
        std::vector<std::string> names;
        for (const ProceduralField& field : set_.fields)
            names.push_back(field.name);
        return names;
    }

    std::string defaultField() const override { return set_.fields.front().name; }

    /// All values are finite.
    Model load(std::span<const std::string> names, const Executor& executor, Progress& progress,
               NonFinite) const override
    {
        std::vector<const ProceduralField*> fields;
        for (const std::string& name : names)
            fields.push_back(&fieldNamed(name));
        Model model = grid(executor, progress);
        for (const ProceduralField* field : fields)
            model.fields.push_back(sampleField(*field, set_.worldFromVoxel, model.bricks, executor, progress));
        checkModel(model, data_);
        return model;
    }

    std::optional<StreamedModel> stream(std::span<const std::string> names, const Executor& executor,
                                        Progress& progress) const override
    {
        std::vector<const ProceduralField*> fields;
        for (const std::string& name : names)
            fields.push_back(&fieldNamed(name));
        StreamedModel streamed{grid(executor, progress), {}};
        const auto bricks = std::make_shared<const std::vector<Brick>>(streamed.model.bricks);
        for (const ProceduralField* field : fields) {
            streamed.model.fields.push_back({field->name, field->unit, {}, {}, {}});
            streamed.values.push_back([this, field, bricks](std::size_t b, std::uint64_t first, std::span<float> out) {
                sampleBrick(*field, set_.worldFromVoxel, (*bricks)[b], first, out);
            });
        }
        return streamed;
    }

private:
    /// The model without fields.
    Model grid(const Executor& executor, Progress& progress) const
    {
        Model model;
        model.name = set_.name;
        model.worldFromVoxel = set_.worldFromVoxel;
        model.bricks = refineBlocks(set_, executor, progress);
        progress.begin("merging bricks", 0);
        mergeBoxes(model.bricks, BrickBuilderConfig().maxBrickWidth, progress);
        model.cellCount = model.bricks.back().begin + model.bricks.back().cellCount();
        progress.end();
        return model;
    }

    const ProceduralField& fieldNamed(const std::string& name) const
    {
        const auto it = std::ranges::find(set_.fields, name, &ProceduralField::name);
        if (it == set_.fields.end())
            throw Error(data_, fmt::format("expected a field of {}, found '{}'", fmt::join(fieldNames(), ", "), name));
        return *it;
    }

    std::string data_;
    ProceduralSet set_;
};

} // namespace

ProceduralSet proceduralSample(const std::string& data)
{
    if (!data.starts_with(prefix))
        throw Error(data, "expected sample:NAME[:SIZE]");
    const std::string_view rest = std::string_view(data).substr(prefix.size());
    const std::size_t colon = rest.find(':');
    const std::string_view name = rest.substr(0, colon);
    const auto sample = std::ranges::find(samples, name, &Sample::name);
    if (sample == samples.end())
        throw Error(data, fmt::format("expected sample:NAME[:SIZE] with a name of {}, found '{}'", allNames(), name));
    const bool sized = colon != std::string_view::npos;
    return sample->make(sized ? parseCells(data, rest.substr(colon + 1)) : sample->cells);
}

std::unique_ptr<DataSet> openSample(const std::string& data)
{
    if (!data.starts_with(prefix))
        return nullptr;
    return std::make_unique<SampleDataSet>(data, proceduralSample(data));
}

} // namespace brickwall
