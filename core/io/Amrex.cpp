// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/AmrexFab.h"
#include "brickwall/core/io/AmrexPlan.h"
#include "brickwall/core/io/EmptyCells.h"
#include "brickwall/core/io/FieldNames.h"
#include "brickwall/core/io/Formats.h"
#include "brickwall/core/model/CheckModel.h"

#include <glm/gtc/matrix_transform.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <utility>

namespace brickwall {
namespace {

FabLayout checkedLayout(const InputFile& file, const AmrexPlotLevel& level, std::uint32_t fab)
{
    const std::uint64_t offset = level.cells.fabs[fab].offset;
    const FabLayout layout = readFabLayout(file, offset);
    const Box3i& box = level.cells.boxes[fab];
    const Box3i expected{box.lower - level.cells.ghosts, box.upper + level.cells.ghosts};
    if (layout.box != expected || layout.components != level.cells.components)
        throw Error(
            fmt::format("{}: FAB at byte {}", file.path(), offset),
            fmt::format("expected box {} of {}, ({},{},{}) to ({},{},{}) with {} components, found ({},{},{}) to "
                        "({},{},{}) with {}",
                        fab, level.place, expected.lower.x, expected.lower.y, expected.lower.z, expected.upper.x - 1,
                        expected.upper.y - 1, expected.upper.z - 1, level.cells.components, layout.box.lower.x,
                        layout.box.lower.y, layout.box.lower.z, layout.box.upper.x - 1, layout.box.upper.y - 1,
                        layout.box.upper.z - 1, layout.components));
    return layout;
}

class FieldReader
{
public:
    FieldReader(const AmrexPlan& plan, const AmrexHeader& header, std::size_t component, NonFinite nonFinite)
        : plan_(plan),
          name_(header.components[component]),
          component_(static_cast<std::int64_t>(component)),
          nonFinite_(nonFinite)
    {
    }

    Field read(const Executor& executor, Progress& progress) const
    {
        progress.begin(fmt::format("reading {}", name_), plan_.cellCount);
        Field field;
        field.name = name_;
        field.values.resize(plan_.cellCount);
        executor.forEach(plan_.jobs.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t j = begin; j < end; ++j) {
                progress.check();
                readJob(plan_.jobs[j], field.values, progress);
            }
        });
        field.range = rangeOf(field.values);
        progress.end();
        return field;
    }

private:
    /// In slabs of planes, which bounds memory and the time until Progress::check.
    void readJob(const AmrexJob& job, std::vector<float>& values, Progress& progress) const
    {
        constexpr std::int64_t slabBytes = 8 << 20;
        const AmrexPlotLevel& level = plan_.levels[job.levelIndex];
        const AmrexFab& fab = level.cells.fabs[job.fab];
        // Opened for each FAB, as there may be more data files than a process may keep open.
        const InputFile file((std::filesystem::path(level.folder) / fab.file).string());
        const FabLayout layout = checkedLayout(file, level, job.fab);
        Box3i needed;
        for (std::size_t p = job.firstPiece; p < job.endPiece; ++p)
            needed.extend(plan_.pieces[p].cells);
        const std::int64_t planeBytes = std::int64_t(layout.box.extent().x) * layout.box.extent().y * layout.bytes;
        const int planes = static_cast<int>(std::clamp<std::int64_t>(slabBytes / planeBytes, 1, needed.extent().z));
        for (int z = needed.lower.z; z < needed.upper.z; z += planes) {
            progress.check();
            const int end = std::min(z + planes, needed.upper.z);
            const FabPlanes slab(file, layout, component_, z, end);
            const std::string place = fmt::format("{}: FAB at byte {}", file.path(), fab.offset);
            for (std::size_t p = job.firstPiece; p < job.endPiece; ++p) {
                Box3i cells = plan_.pieces[p].cells;
                cells.lower.z = std::max(cells.lower.z, z);
                cells.upper.z = std::min(cells.upper.z, end);
                copy(cells, plan_.bricks[plan_.pieces[p].brick], slab, values, place);
                progress.advance(static_cast<std::uint64_t>(volume(cells)));
            }
        }
    }

    /// The values of these cells, in the level's indices, which the brick holds all.
    void copy(const Box3i& c, const Brick& brick, const FabPlanes& slab, std::vector<float>& values,
              const std::string& place) const
    {
        const vec3i origin = brick.lower / brick.cellWidth();
        for (int z = c.lower.z; z < c.upper.z; ++z)
            for (int y = c.lower.y; y < c.upper.y; ++y) {
                const std::uint64_t row = std::uint64_t(z - origin.z) * brick.size.y + (y - origin.y);
                float* out = values.data() + brick.begin + row * brick.size.x + (c.lower.x - origin.x);
                for (int x = c.lower.x; x < c.upper.x; ++x) {
                    const double value = slab.at(x, y, z);
                    *out = static_cast<float>(value);
                    if (!std::isfinite(*out++) && nonFinite_ == NonFinite::error)
                        failNotFinite(value, place, name_, fmt::format("cell ({},{},{})", x, y, z));
                }
            }
    }

    const AmrexPlan& plan_;
    std::string name_;
    std::int64_t component_;
    NonFinite nonFinite_;
};

class Plotfile : public DataSet
{
public:
    Plotfile(std::string folder, AmrexHeader header) : folder_(std::move(folder)), header_(std::move(header)) {}

    std::string format() const override { return "AMReX plotfile"; }
    std::vector<std::string> fieldNames() const override { return header_.components; }

    std::string defaultField() const override
    {
        for (const char* usual : {"velmag", "magvel", "speed", "density", "dens", "rho"})
            if (std::find(header_.components.begin(), header_.components.end(), usual) != header_.components.end())
                return usual;
        return header_.components[0];
    }

    Model load(std::span<const std::string> fields, const Executor& executor, Progress& progress,
               NonFinite nonFinite) const override
    {
        const auto wanted = fieldIndices(header_.components, fields, folder_);
        AmrexPlan plan = planPlotfile(folder_, header_, executor, progress);
        Model model;
        model.name = stemOf(folder_);
        for (const std::size_t component : wanted)
            model.fields.push_back(FieldReader(plan, header_, component, nonFinite).read(executor, progress));
        model.worldFromVoxel = worldFromVoxel();
        model.bricks = std::move(plan.bricks);
        model.cellCount = plan.cellCount;
        if (plan.coveredCells > 0)
            model.notes.push_back(
                fmt::format("{}: {} cells left out that finer levels cover", folder_, plan.coveredCells));
        if (nonFinite == NonFinite::empty)
            leaveOutNonFinite(model, folder_, executor, progress);
        for (const std::string& note : model.notes)
            progress.note(note);
        checkModel(model, folder_);
        return model;
    }

private:
    /// The finest level's indices are voxels; its cells may be wider along one axis than along another.
    mat4d worldFromVoxel() const
    {
        const AmrexLevel& finest = header_.levels.back();
        const mat4d scaled = glm::scale(glm::translate(mat4d(1.0), header_.lower), finest.cellSize);
        return glm::translate(scaled, -vec3d(finest.domain.lower));
    }

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
