// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Commands.h"
#include "PeakMemory.h"
#include "TerminalProgress.h"

#include "brickwall/core/io/VectorFields.h"
#include "brickwall/core/model/Regions.h"
#include "brickwall/core/scene/SceneArguments.h"
#include "brickwall/core/scene/SceneSetup.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <utility>

namespace brickwall {
namespace {

using nlohmann::json;

/// Values of all fields at once up to this many bytes; beyond it one field after the other.
constexpr std::uint64_t bytesAtOnce = std::uint64_t(2) << 30;

struct FieldSummary
{
    std::string name, unit;
    Range range;
};

struct DataSummary
{
    std::string format;
    std::string defaultField;
    Model model; ///< without values
    std::vector<FieldSummary> fields;
    std::vector<VectorFields> vectors;
    std::size_t regions = 0, multiBrickRegions = 0, levelBoundaryRegions = 0;
    std::uint64_t modelBytes = 0, regionBytes = 0, bytesPerField = 0;
};

/// Reads the names' fields, remembers their ranges and lets the values go.
void summarizeFields(const DataSet& data, std::span<const std::string> names, const Executor& executor,
                     Progress& progress, DataSummary& summary)
{
    Model model = data.load(names, executor, progress);
    for (const Field& field : model.fields)
        summary.fields.push_back({field.name, field.unit, field.range});
    model.fields.clear();
    summary.model = std::move(model);
}

DataSummary summarize(const SceneOptions& options, const Executor& executor, Progress& progress)
{
    checkSceneOptions(options, commandLinePlace);
    const auto data = openData(options);
    DataSummary summary;
    summary.format = data->format();
    summary.defaultField = data->defaultField();
    const std::vector<std::string> fields = data->fieldNames();
    summary.vectors = findVectors(fields);
    const std::size_t first = std::min<std::size_t>(1, fields.size());
    summarizeFields(*data, std::span(fields).first(first), executor, progress, summary);
    if (summary.model.cellCount * sizeof(float) * fields.size() <= bytesAtOnce) {
        if (fields.size() > first) {
            summarizeFields(*data, std::span(fields).subspan(first), executor, progress, summary);
        }
    } else {
        for (std::size_t i = first; i < fields.size(); ++i)
            summarizeFields(*data, std::span(fields).subspan(i, 1), executor, progress, summary);
    }
    const RegionTree tree = buildRegions(summary.model.bricks, executor, progress);
    summary.regions = tree.regions.size();
    for (const Region& region : tree.regions) {
        summary.multiBrickRegions += region.brickCount > 1;
        summary.levelBoundaryRegions += region.finestLevel != region.coarsestLevel;
    }
    summary.modelBytes = summary.model.bricks.size() * sizeof(Brick);
    summary.regionBytes = tree.bytes();
    summary.bytesPerField = tree.paddedCellCount * sizeof(float) + tree.regions.size() * sizeof(Range);
    return summary;
}

json toJson(const DataSummary& s, const std::string& data)
{
    const Box3i voxels = voxelBounds(s.model.bricks);
    const Box3d world = worldBounds(s.model);
    json levels = json::array();
    const auto cells = cellsPerLevel(s.model.bricks);
    for (std::size_t level = 0; level < cells.size(); ++level)
        levels.push_back({{"level", level}, {"cell_width", 1 << level}, {"cells", cells[level]}});
    json fields = json::array();
    for (const FieldSummary& f : s.fields)
        fields.push_back({{"name", f.name}, {"unit", f.unit}, {"range", {f.range.lo, f.range.hi}}});
    json vectors = json::array();
    for (const VectorFields& v : s.vectors)
        vectors.push_back({{"name", v.name}, {"components", v.components}, {"magnitude", v.magnitude()}});
    const auto list = [](const auto& v) { return json{v.x, v.y, v.z}; };
    return {{"data", data},
            {"format", s.format},
            {"cells", s.model.cellCount},
            {"levels", levels},
            {"bricks", s.model.bricks.size()},
            {"regions", s.regions},
            {"multi_brick_regions", s.multiBrickRegions},
            {"level_boundary_regions", s.levelBoundaryRegions},
            {"voxel_bounds", {{"lower", list(voxels.lower)}, {"upper", list(voxels.upper)}}},
            {"world_bounds", {{"lower", list(world.lower)}, {"upper", list(world.upper)}}},
            {"default_field", s.defaultField},
            {"fields", fields},
            {"vectors", vectors},
            {"triangle_meshes", s.model.meshes.size()},
            {"memory",
             {{"regions_bytes", s.regionBytes + s.modelBytes},
              {"bytes_per_field", s.bytesPerField},
              {"peak_bytes", peakMemory()}}},
            {"notes", s.model.notes}};
}

void print(const DataSummary& s, const std::string& data)
{
    const Box3i voxels = voxelBounds(s.model.bricks);
    const Box3d world = worldBounds(s.model);
    const auto cells = cellsPerLevel(s.model.bricks);
    fmt::print("{:<12} {} ({})\n", "data", data, s.format);
    fmt::print("{:<12} {}\n", "cells", s.model.cellCount);
    for (std::size_t level = 0; level < cells.size(); ++level)
        fmt::print("{:<12} {:>12} cells, {} wide\n", fmt::format("  level {}", level), cells[level], 1 << level);
    fmt::print("{:<12} {}\n", "bricks", s.model.bricks.size());
    fmt::print("{:<12} {}, of them {} with several bricks, {} with several levels\n", "regions", s.regions,
               s.multiBrickRegions, s.levelBoundaryRegions);
    fmt::print("{:<12} {} {} {} to {} {} {}\n", "voxels", voxels.lower.x, voxels.lower.y, voxels.lower.z,
               voxels.upper.x, voxels.upper.y, voxels.upper.z);
    fmt::print("{:<12} {:g} {:g} {:g} to {:g} {:g} {:g}\n", "world", world.lower.x, world.lower.y, world.lower.z,
               world.upper.x, world.upper.y, world.upper.z);
    for (const FieldSummary& f : s.fields)
        fmt::print("{:<12} {:<16} {:g} to {:g} {}{}\n", "field", f.name, f.range.lo, f.range.hi, f.unit,
                   f.name == s.defaultField ? " (default)" : "");
    for (const VectorFields& v : s.vectors)
        fmt::print("{:<12} {:<16} {}; its length is the field {}\n", "vector", v.name, fmt::join(v.components, " "),
                   v.magnitude());
    if (!s.model.meshes.empty())
        fmt::print("{:<12} {}\n", "meshes", s.model.meshes.size());
    constexpr double mb = 1024.0 * 1024.0;
    fmt::print("{:<12} {:.1f} MiB for the regions, {:.1f} MiB for each field ({:.1f} bytes per cell in all), peak "
               "{:.0f} MiB\n",
               "memory", (s.regionBytes + s.modelBytes) / mb, s.bytesPerField / mb,
               double(s.regionBytes + s.modelBytes + s.bytesPerField) /
                   double(std::max<std::uint64_t>(1, s.model.cellCount)),
               peakMemory() / mb);
    for (const std::string& note : s.model.notes)
        fmt::print("{:<12} {}\n", "note", note);
}

} // namespace

void addInfoCommand(CLI::App& app, Action& chosen)
{
    CLI::App* command =
        app.add_subcommand("info", "levels, cells, bricks, regions, bounds, fields with ranges, memory");
    struct Options
    {
        SceneOptions scene;
        bool json = false;
    };
    auto options = std::make_shared<Options>();
    addDataOption(*command, options->scene);
    command->add_flag("--json", options->json, "as JSON");
    addThreadsOption(*command, options->scene.threads);
    command->callback([options, &chosen] {
        chosen = [options] {
            TerminalProgress progress;
            const Executor executor(options->scene.threads);
            const DataSummary summary = summarize(options->scene, executor, progress);
            progress.end();
            if (options->json)
                fmt::print(
                    "{}\n",
                    toJson(summary, options->scene.data).dump(2, ' ', false, nlohmann::json::error_handler_t::replace));
            else
                print(summary, options->scene.data);
            return 0;
        };
    });
}

} // namespace brickwall
