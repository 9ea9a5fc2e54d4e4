// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/FieldNames.h"
#include "brickwall/core/io/FlashBlocks.h"
#include "brickwall/core/io/Formats.h"
#include "brickwall/core/io/Hdf5Box.h"
#include "brickwall/core/io/Hdf5File.h"
#include "brickwall/core/io/InputFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace brickwall {
namespace {

class FlashDataSet : public DataSet
{
public:
    /// `names` as fields are called, `datasets` as the file calls them.
    FlashDataSet(Hdf5File file, std::vector<std::string> names, std::vector<std::string> datasets)
        : file_(std::move(file)), names_(std::move(names)), datasets_(std::move(datasets))
    {
    }

    std::string format() const override { return "FLASH"; }
    std::vector<std::string> fieldNames() const override { return names_; }
    std::string defaultField() const override { return usualField(names_); }

    Model load(std::span<const std::string> fields, const Executor& executor, Progress& progress,
               NonFinite nonFinite) const override
    {
        const std::string& place = file_.path();
        const auto wanted = fieldIndices(names_, fields, place);
        const FlashBlocks blocks = readFlashBlocks(file_, datasets_.at(0));
        LeafPlan plan = planDisjoint(blocks.levels, place, progress);
        std::vector<Field> read;
        for (const std::size_t i : wanted) {
            const Hdf5Data data = file_.data(datasets_[i]);
            data.expectShape(blocks.shape);
            const auto open = [&](const LeafJob& job) { return std::make_unique<Hdf5Box>(data, placeOf(job, blocks)); };
            read.push_back(readLeafField(plan, names_[i], open, nonFinite, executor, progress));
        }
        return leafModel(std::move(plan), std::move(read), blocks.worldFromVoxel, place, nonFinite, executor, progress);
    }

private:
    /// A field is an array of block, z, y, x.
    static Hdf5BoxPlace placeOf(const LeafJob& job, const FlashBlocks& blocks)
    {
        const std::vector<std::uint64_t> plane{1, 1, blocks.shape[2], blocks.shape[3]};
        return {blocks.levels[job.levelIndex].boxes[job.box],
                {blocks.blocks[job.levelIndex][job.box], 0, 0, 0},
                plane,
                1,
                1};
    }

    Hdf5File file_;
    std::vector<std::string> names_, datasets_;
};

/// Names of four characters are padded with blanks, in `unknown names` as in the dataset's own name.
std::string datasetOf(const Hdf5File& file, const std::string& name)
{
    std::string padded = name;
    padded.resize(std::max<std::size_t>(name.size(), 4), ' ');
    for (const std::string& candidate : {name, padded})
        if (!candidate.empty() && file.has(candidate))
            return candidate;
    throw Error(file.path(), fmt::format("expected a dataset '{}', which 'unknown names' lists, found none", name));
}

} // namespace

std::unique_ptr<DataSet> openFlash(const std::string& data)
{
    if (!isRegularFile(data) || !looksLikeHdf5(data))
        return nullptr;
    Hdf5File file(data);
    const bool blocks = file.has("node type") && file.has("bounding box");
    if (!blocks && !file.has("unknown names") && !file.has("sim info"))
        return nullptr;
    if (!file.has("unknown names") && file.has("particle names"))
        throw Error(data, "is a particle file of FLASH; expected a plot file or checkpoint (..._hdf5_plt_cnt_0000, "
                          "..._hdf5_chk_0000)");
    std::vector<std::string> names = file.data("unknown names").texts(), datasets;
    if (names.empty())
        throw Error(data, "expected fields, but 'unknown names' lists none");
    for (const std::string& name : names)
        datasets.push_back(datasetOf(file, name));
    return std::make_unique<FlashDataSet>(std::move(file), std::move(names), std::move(datasets));
}

} // namespace brickwall
