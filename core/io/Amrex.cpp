// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/AmrexFab.h"
#include "brickwall/core/io/AmrexLevels.h"
#include "brickwall/core/io/FieldNames.h"
#include "brickwall/core/io/Formats.h"
#include "brickwall/core/io/LeafFields.h"

#include <fmt/format.h>

#include <filesystem>
#include <utility>

namespace brickwall {
namespace {

/// One component of a FAB. Each opens its file anew, as there may be more data files than a process may keep open.
class FabReader : public BoxReader
{
public:
    FabReader(const AmrexLevels& levels, const LeafJob& job, std::size_t component)
        : file_(dataFile(levels, job)),
          offset_(levels.cells[job.levelIndex].fabs[job.box].offset),
          layout_(readFabLayout(file_, offset_)),
          component_(static_cast<std::int64_t>(component))
    {
        checkLayout(levels, job);
    }

    std::string place() const override { return fmt::format("{}: FAB at byte {}", file_.path(), offset_); }
    Box3i box() const override { return layout_.box; }
    std::int64_t slabValues() const override { return std::int64_t(1) << 15; }
    void read(int zBegin, int zEnd, std::vector<double>& values) override
    {
        readFabPlanes(file_, layout_, component_, zBegin, zEnd, values);
    }

private:
    static std::string dataFile(const AmrexLevels& levels, const LeafJob& job)
    {
        const AmrexCells& cells = levels.cells[job.levelIndex];
        return (std::filesystem::path(levels.folders[job.levelIndex]) / cells.files[cells.fabs[job.box].file]).string();
    }

    void checkLayout(const AmrexLevels& levels, const LeafJob& job) const
    {
        const AmrexCells& cells = levels.cells[job.levelIndex];
        const Box3i& box = levels.boxes[job.levelIndex].boxes[job.box];
        const Box3i expected{box.lower - cells.ghosts, box.upper + cells.ghosts}, &found = layout_.box;
        if (found != expected || layout_.components != cells.components)
            throw Error(place(),
                        fmt::format("expected box {} of {}, ({},{},{}) to ({},{},{}) with {} components, found "
                                    "({},{},{}) to ({},{},{}) with {}",
                                    job.box, levels.boxes[job.levelIndex].place, expected.lower.x, expected.lower.y,
                                    expected.lower.z, expected.upper.x - 1, expected.upper.y - 1, expected.upper.z - 1,
                                    cells.components, found.lower.x, found.lower.y, found.lower.z, found.upper.x - 1,
                                    found.upper.y - 1, found.upper.z - 1, layout_.components));
    }

    InputFile file_;
    std::uint64_t offset_;
    FabLayout layout_;
    std::int64_t component_;
};

class Plotfile : public DataSet
{
public:
    Plotfile(std::string folder, AmrexHeader header) : folder_(std::move(folder)), header_(std::move(header)) {}

    std::string format() const override { return "AMReX plotfile"; }
    std::vector<std::string> fieldNames() const override { return header_.components; }
    std::string defaultField() const override { return usualField(header_.components); }

    std::vector<std::string> files() const override { return filesBelow(folder_); }

    Model load(std::span<const std::string> fields, const Executor& executor, Progress& progress,
               NonFinite nonFinite) const override
    {
        const auto wanted = fieldIndices(header_.components, fields, folder_);
        const AmrexLevels levels = readAmrexLevels(folder_, header_, progress);
        LeafPlan plan = planLeaves(levels.boxes, folder_, executor, progress);
        checkDataSizes(levels);
        std::vector<Field> read;
        for (const std::size_t component : wanted) {
            const auto open = [&](const LeafJob& job) { return std::make_unique<FabReader>(levels, job, component); };
            read.push_back(readLeafField(plan, header_.components[component], open, nonFinite, executor, progress));
        }
        const AmrexLevel& finest = header_.levels.back();
        return leafModel(std::move(plan), std::move(read),
                         worldFromIndices(header_.lower, finest.domain.lower, finest.cellSize), folder_, nonFinite,
                         executor, progress);
    }

private:
    std::string folder_;
    AmrexHeader header_;
};

} // namespace

std::unique_ptr<DataSet> openPlotfile(const std::string& data)
{
    std::filesystem::path folder(data);
    if (folder.filename() == "Header")
        folder = folder.has_parent_path() ? folder.parent_path() : ".";
    const std::string file = (folder / "Header").string();
    if (!std::filesystem::is_directory(folder) || !isRegularFile(file))
        return nullptr;
    const std::string start = fileStart(file, 256);
    if (start.empty())
        throw Error(file, "the file is empty, expected the header of a plotfile");
    const std::string firstLine = TextCursor(file, start).line("a version");
    if (!isPlotfileVersion(firstLine))
        return nullptr;
    return std::make_unique<Plotfile>(folder.string(), readAmrexHeader(file));
}

} // namespace brickwall
