// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Statistics.h"

#include "brickwall/core/base/WholeFile.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>

namespace brickwall {
namespace {

using nlohmann::json;

json viewJson(const RenderStatistics& statistics, const Frame& frame, std::size_t view)
{
    json milliseconds = json::array();
    for (const auto& repetition : statistics.repetitions)
        milliseconds.push_back(repetition[view].milliseconds);
    const ViewStatistics& last = statistics.repetitions.back()[view];
    return {{"name", last.name},
            {"width", frame.width},
            {"height", frame.height},
            {"milliseconds", milliseconds},
            {"rays", last.rays},
            {"samples", last.counts.samples},
            {"regions_visited", last.counts.regionsVisited}};
}

std::uint64_t samplesOf(const std::vector<ViewStatistics>& views)
{
    std::uint64_t samples = 0;
    for (const ViewStatistics& view : views)
        samples += view.counts.samples;
    return samples;
}

} // namespace

double median(std::vector<double> values)
{
    std::sort(values.begin(), values.end());
    const std::size_t n = values.size();
    return n == 0 ? 0.0 : 0.5 * (values[(n - 1) / 2] + values[n / 2]);
}

void writeStatistics(const std::string& path, const RenderStatistics& statistics, const SceneOptions& options,
                     const PreparedScene& prepared, const std::vector<Frame>& frames, int threads)
{
    json views = json::array();
    for (std::size_t i = 0; i < frames.size(); ++i)
        views.push_back(viewJson(statistics, frames[i], i));
    const json root = {{"data", options.data},
                       {"field", prepared.field},
                       {"cells", prepared.cells},
                       {"bricks", prepared.scene.regions->bricks.size()},
                       {"regions", prepared.scene.regions->regions.size()},
                       {"method", {{"name", options.method}, {"dt", options.dt}}},
                       {"threads", threads},
                       {"lanes", Renderer::lanes()},
                       {"target", Renderer::target()},
                       {"load_milliseconds", prepared.loadMilliseconds},
                       {"prepare_milliseconds", prepared.prepareMilliseconds},
                       {"milliseconds", statistics.totalMilliseconds},
                       {"median_milliseconds", median(statistics.totalMilliseconds)},
                       {"samples", samplesOf(statistics.repetitions.back())},
                       {"peak_memory_bytes", peakMemory()},
                       {"views", views}};
    writeWholeFile(path, root.dump(2, ' ', false, json::error_handler_t::replace) + '\n');
}

void printSummary(const RenderStatistics& statistics, const PreparedScene& prepared, std::size_t views,
                  const std::string& folder)
{
    const double milliseconds = median(statistics.totalMilliseconds);
    const std::uint64_t samples = samplesOf(statistics.repetitions.back());
    fmt::print("{} of {}: {} cells, {} regions, {:.1f} bytes per cell\n", prepared.field, prepared.name, prepared.cells,
               prepared.scene.regions->regions.size(), double(prepared.bytes) / double(prepared.cells));
    fmt::print("{} view{} in {:.0f} ms ({:.1f} million samples, {:.0f} million per second, {} lanes) into {}\n", views,
               views == 1 ? "" : "s", milliseconds, samples / 1e6, samples / 1e3 / milliseconds, Renderer::lanes(),
               folder);
}

} // namespace brickwall
