// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Statistics.h"

#include "LightJson.h"
#include "PeakMemory.h"

#include "brickwall/core/base/Median.h"
#include "brickwall/core/base/WholeFile.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace brickwall {
namespace {

using nlohmann::json;

json viewJson(const RenderStatistics& statistics, const RenderSettings& settings, const Frame& frame, std::size_t view)
{
    json milliseconds = json::array();
    for (const auto& repetition : statistics.repetitions)
        milliseconds.push_back(repetition[view].milliseconds);
    const ViewStatistics& last = statistics.repetitions.back()[view];
    json result = {{"name", last.name},
                   {"width", frame.width},
                   {"height", frame.height},
                   {"milliseconds", milliseconds},
                   {"rays", last.rays},
                   {"samples", last.counts.samples},
                   {"fetches", last.counts.fetches},
                   {"regions_visited", last.counts.regionsVisited},
                   {"pieces_skipped", last.counts.piecesSkipped},
                   {"pieces_merged", last.counts.piecesMerged},
                   {"pieces_split", last.counts.piecesSplit},
                   {"surface_hits", last.surfaceHits}};
    if (settings.method == Method::bounded) {
        result["largest_bound"] = last.largestBound;
        result["pixels_beyond"] = last.pixelsBeyond;
        result["beyond_because"] = last.beyondBecause;
    }
    if (settings.lod.cellPixels > 0.0f)
        result["member_samples"] = last.memberSamples;
    return result;
}

json methodJson(const RenderSettings& settings)
{
    json method = {{"name", nameOf(settings.method)}};
    if (settings.method == Method::bounded)
        method["tolerance"] = settings.bounded.tolerance;
    if (takesSteps(settings.method))
        method["dt"] = settings.step.dt;
    if (settings.method != Method::reference)
        method["lod"] = settings.lod.cellPixels;
    method.update(lightJson(settings));
    return method;
}

json surfacesJson(const std::vector<IsoSurface>& surfaces)
{
    json values = json::array();
    for (const IsoSurface& surface : surfaces)
        values.push_back(
            {{"value", surface.value}, {"opacity", surface.opacity}, {"colored_by_field", surface.coloredByField}});
    return values;
}

/// What colours are of, and over which of its values.
json colorsJson(const TransferFunction& tf, const PreparedScene& prepared)
{
    const Range& range = tf.colorField ? tf.colorField->range : tf.range;
    return {{"field", prepared.colorField}, {"range", {range.lo, range.hi}}};
}

json pyramidJson(const Scene& scene)
{
    json members = json::array();
    for (const SceneMember& member : scene.pyramid)
        members.push_back({{"level", member.level}, {"regions", member.regions->regions.size()}});
    return members;
}

/// The last repetition of all views.
ViewStatistics sumOf(const std::vector<ViewStatistics>& views)
{
    ViewStatistics sum;
    for (const ViewStatistics& view : views) {
        sum.counts += view.counts;
        sum.surfaceHits += view.surfaceHits;
        sum.largestBound = std::max(sum.largestBound, view.largestBound);
        sum.pixelsBeyond += view.pixelsBeyond;
        sum.memberSamples.resize(std::max(sum.memberSamples.size(), view.memberSamples.size()));
        for (std::size_t level = 0; level < view.memberSamples.size(); ++level)
            sum.memberSamples[level] += view.memberSamples[level];
        if (sum.beyondBecause.empty())
            sum.beyondBecause = view.beyondBecause;
    }
    return sum;
}

} // namespace

void writeStatistics(const std::string& path, const RenderStatistics& statistics, const std::string& data,
                     const RenderSettings& settings, const PreparedScene& prepared, const std::vector<Frame>& frames,
                     int threads)
{
    json views = json::array();
    for (std::size_t i = 0; i < frames.size(); ++i)
        views.push_back(viewJson(statistics, settings, frames[i], i));
    const json root = {{"data", data},
                       {"field", prepared.field},
                       {"colors", colorsJson(prepared.scene.transferFunction, prepared)},
                       {"cells", prepared.cells},
                       {"bricks", prepared.scene.regions->bricks.size()},
                       {"regions", prepared.scene.regions->regions.size()},
                       {"method", methodJson(settings)},
                       {"surfaces", surfacesJson(prepared.scene.surfaces)},
                       {"planes", prepared.scene.planes.size()},
                       {"pyramid", pyramidJson(prepared.scene)},
                       {"threads", threads},
                       {"lanes", Renderer::lanes()},
                       {"target", Renderer::target()},
                       {"load_milliseconds", prepared.loadMilliseconds},
                       {"prepare_milliseconds", prepared.prepareMilliseconds},
                       {"milliseconds", statistics.totalMilliseconds},
                       {"median_milliseconds", median(statistics.totalMilliseconds)},
                       {"samples", sumOf(statistics.repetitions.back()).counts.samples},
                       {"peak_memory_bytes", peakMemory()},
                       {"views", views}};
    writeWholeFile(path, root.dump(2, ' ', false, json::error_handler_t::replace) + '\n');
}

void printSummary(const RenderStatistics& statistics, const RenderSettings& settings, const PreparedScene& prepared,
                  const std::string& folder)
{
    const double milliseconds = median(statistics.totalMilliseconds);
    const std::size_t views = statistics.repetitions.back().size();
    const ViewStatistics sum = sumOf(statistics.repetitions.back());
    const auto samples = static_cast<double>(sum.counts.samples);
    fmt::print("{} of {}: {} cells, {} regions, {:.1f} bytes per cell\n", prepared.field, prepared.name, prepared.cells,
               prepared.scene.regions->regions.size(), double(prepared.bytes) / double(prepared.cells));
    fmt::print("{} view{} in {:.0f} ms ({:.1f} million samples, {:.0f} million per second, {} lanes) into {}\n", views,
               views == 1 ? "" : "s", milliseconds, samples / 1e6, samples / 1e3 / milliseconds, Renderer::lanes(),
               folder);
    fmt::print("{}", describe(settings));
    if (settings.method == Method::bounded)
        fmt::print("; error at most {:.3g}{}", sum.largestBound,
                   sum.memberSamples.size() > 1 ? " of the data used" : "");
    if (sum.pixelsBeyond > 0)
        fmt::print(", {} pixels beyond the tolerance: {}", sum.pixelsBeyond, sum.beyondBecause);
    if (settings.lod.cellPixels > 0.0f && samples > 0.0)
        fmt::print("; cells about {:g} pixels wide, {:.0f} % of the samples in averaged data", settings.lod.cellPixels,
                   100.0 * (1.0 - double(sum.memberSamples.front()) / samples));
    if (!prepared.scene.surfaces.empty())
        fmt::print("; {} surface hits", sum.surfaceHits);
    fmt::print("\n");
}

} // namespace brickwall
