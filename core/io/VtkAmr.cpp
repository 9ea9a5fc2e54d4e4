// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/FieldNames.h"
#include "brickwall/core/io/Formats.h"
#include "brickwall/core/io/VtkLevels.h"
#include "brickwall/core/io/VtkPiece.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace brickwall {
namespace {

/// A byte of a piece is at most 1032 bytes of numbers when unpacked. Pieces are opened one by one later, when there
/// already is memory for the cells of all.
void checkPieceSizes(const VtkLevels& levels)
{
    constexpr double mostCellsPerByte = 1100.0;
    for (std::size_t l = 0; l < levels.files.size(); ++l)
        for (std::size_t b = 0; b < levels.files[l].size(); ++b) {
            const vec3d size(levels.boxes[l].boxes[b].extent());
            std::error_code missing; // said when it is opened
            const auto bytes = std::filesystem::file_size(levels.files[l][b], missing);
            if (!missing && size.x * size.y * size.z > mostCellsPerByte * double(bytes))
                throw Error(levels.files[l][b],
                            fmt::format("truncated: its box has {} cells, but the file only {} bytes",
                                        size.x * size.y * size.z, bytes));
        }
}

class VtkAmr : public DataSet
{
public:
    explicit VtkAmr(VtkLevels levels) : levels_(std::move(levels)) {}

    std::string format() const override { return "VTK overlapping AMR"; }
    std::vector<std::string> fieldNames() const override { return namesOf(levels_.fields); }
    std::string defaultField() const override { return usualField(fieldNames()); }

    Model load(std::span<const std::string> fields, const Executor& executor, Progress& progress,
               NonFinite nonFinite) const override
    {
        const auto wanted = fieldIndices(fieldNames(), fields, levels_.place);
        LeafPlan plan = planLeaves(levels_.boxes, levels_.place, executor, progress);
        checkPieceSizes(levels_);
        std::vector<Field> read;
        for (const std::size_t i : wanted) {
            const ArrayField& field = levels_.fields[i];
            const auto open = [&](const LeafJob& job) {
                return openVtkPiece(levels_.files[job.levelIndex][job.box],
                                    levels_.boxes[job.levelIndex].boxes[job.box], field);
            };
            read.push_back(readLeafField(plan, field.name, open, nonFinite, executor, progress));
        }
        return leafModel(std::move(plan), std::move(read), levels_.worldFromVoxel, levels_.place, nonFinite, executor,
                         progress);
    }

    std::vector<std::string> files() const override
    {
        std::vector<std::string> all{levels_.place};
        for (const auto& pieces : levels_.files)
            all.insert(all.end(), pieces.begin(), pieces.end());
        return all;
    }

private:
    VtkLevels levels_;
};

} // namespace

std::unique_ptr<DataSet> openVtkAmr(const std::string& data)
{
    const std::string type = vtkXmlType(data);
    if (type.empty())
        return nullptr;
    if (type != "vtkHierarchicalBoxDataSet" && type != "vtkOverlappingAMR")
        throw Error(data, fmt::format("expected a VTK file of type vtkOverlappingAMR or vtkHierarchicalBoxDataSet, "
                                      "found '{}'{}",
                                      type, type == "ImageData" ? "; open the .vth or .vthb file that names it" : ""));
    return std::make_unique<VtkAmr>(readVtkLevels(data));
}

} // namespace brickwall
