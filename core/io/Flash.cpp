// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/FlashBlocks.h"
#include "brickwall/core/io/Formats.h"
#include "brickwall/core/io/Hdf5Box.h"
#include "brickwall/core/io/Hdf5DataSet.h"
#include "brickwall/core/io/InputFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <utility>

namespace brickwall {
namespace {

/// A field is an array of block, z, y, x.
Hdf5BoxPlace placeOf(const LeafJob& job, const FlashBlocks& blocks)
{
    const std::vector<std::uint64_t> plane{1, 1, blocks.shape[2], blocks.shape[3]};
    return {
        blocks.levels[job.levelIndex].boxes[job.box], {blocks.blocks[job.levelIndex][job.box], 0, 0, 0}, plane, 1, 1};
}

class FlashDataSet : public Hdf5DataSet
{
public:
    /// `names` as fields are called, `datasets` as the file calls them.
    FlashDataSet(Hdf5File file, std::vector<std::string> names, std::vector<std::string> datasets)
        : Hdf5DataSet(std::move(file), std::move(names)), datasets_(std::move(datasets))
    {
    }

    std::string format() const override { return "FLASH"; }

private:
    Layout readLayout(const Executor&, Progress& progress) const override
    {
        const auto blocks = std::make_shared<const FlashBlocks>(readFlashBlocks(file(), datasets_.at(0)));
        const auto open = [this, blocks](std::size_t field) -> OpenBox {
            const auto data = std::make_shared<const Hdf5Data>(file().data(datasets_[field]));
            data->expectShape(blocks->shape);
            return
                [data, blocks](const LeafJob& job) { return std::make_unique<Hdf5Box>(*data, placeOf(job, *blocks)); };
        };
        return {planDisjoint(blocks->levels, file().path(), progress), blocks->worldFromVoxel, open};
    }

    std::vector<std::string> datasets_;
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
