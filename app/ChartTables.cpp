// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Chart.h"
#include "LightJson.h"

#include "brickwall/core/base/Median.h"
#include "brickwall/core/base/WholeFile.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>
#include <iterator>
#include <thread>

namespace brickwall {
namespace {

using nlohmann::json;

/// As RFC 4180 has it: quoted where needed.
std::string quoted(const std::string& text)
{
    if (text.find_first_of(",\"\r\n") == std::string::npos)
        return text;
    std::string result = "\"";
    for (const char c : text)
        result += c == '"' ? std::string("\"\"") : std::string(1, c);
    return result + '"';
}

std::string noteOf(const ChartRow& row, const ChartPlan& plan)
{
    if (row.point.method == Method::reference)
        return "rendered once";
    std::string note;
    if (static_cast<int>(row.milliseconds.size()) < plan.repetitions)
        note = fmt::format("rendered once: slower than {:g} s", plan.slowMilliseconds / 1e3);
    if (isBeyondTolerance(row))
        note += std::string(note.empty() ? "" : "; ") + "error above the tolerance";
    return note;
}

/// Linux's name of the processor; empty where it has none.
std::string processorName()
{
    std::ifstream in("/proc/cpuinfo");
    for (std::string line; std::getline(in, line);)
        if (line.rfind("model name", 0) == 0 && line.find(": ") != std::string::npos)
            return line.substr(line.find(": ") + 2);
    return {};
}

json viewsJson(const Chart& chart)
{
    json views = json::array();
    for (const View& view : chart.plan.views) {
        const auto reference = std::find_if(chart.rows.begin(), chart.rows.end(), [&](const ChartRow& row) {
            return row.point.method == Method::reference && row.view == view.name;
        });
        views.push_back({{"name", view.name},
                         {"width", view.window.width},
                         {"height", view.window.height},
                         {"reference_milliseconds", reference->milliseconds.front()}});
    }
    return views;
}

} // namespace

void writeChartCsv(const std::string& path, const Chart& chart)
{
    std::string csv = "method,parameter,view,repetitions,median_ms,min_ms,max_ms,max_error,rms_error,ssim,"
                      "samples_per_ray,fetches_per_ray,regions_per_ray,largest_bound,pixels_beyond,note\n";
    for (const ChartRow& row : chart.rows) {
        const auto [least, most] = std::minmax_element(row.milliseconds.begin(), row.milliseconds.end());
        const bool isReference = row.point.method == Method::reference;
        fmt::format_to(std::back_inserter(csv),
                       "{},{},{},{},{:.4f},{:.4f},{:.4f},{:.6g},{:.6g},{:.9f},{:.4f},{:.4f},{:.4f},{:.6g},{},{}\n",
                       nameOf(row.point.method), isReference ? "" : fmt::format("{:.9g}", row.point.parameter),
                       quoted(row.view), row.milliseconds.size(), median(row.milliseconds), *least, *most, row.maxError,
                       row.rmsError, row.similarity, row.samplesPerRay, row.fetchesPerRay, row.regionsPerRay,
                       row.largestBound, row.pixelsBeyond, quoted(noteOf(row, chart.plan)));
    }
    writeWholeFile(path, csv);
}

void writeChartJson(const std::string& path, const Chart& chart, const PreparedScene& prepared)
{
    json surfaces = json::array();
    for (const IsoSurface& surface : prepared.scene.surfaces)
        surfaces.push_back({{"value", surface.value}, {"opacity", surface.opacity}});
    const TransferFunction& tf = prepared.scene.transferFunction;
    json root = {{"brickwall", BRICKWALL_VERSION},
                 {"data", chart.data},
                 {"field", prepared.field},
                 {"cells", prepared.cells},
                 {"bricks", prepared.scene.regions->bricks.size()},
                 {"regions", prepared.scene.regions->regions.size()},
                 {"machine",
                  {{"processor", processorName()},
                   {"cores", std::thread::hardware_concurrency()},
                   {"threads", chart.threads},
                   {"target", Renderer::target()},
                   {"lanes", Renderer::lanes()}}},
                 {"transfer_function",
                  {{"range", {tf.range.lo, tf.range.hi}},
                   {"scale", tf.scale == Scale::linear ? "linear" : "log"},
                   {"opacity_scale", tf.opacityScale}}},
                 {"surfaces", surfaces},
                 {"lod", chart.plan.look.lod.cellPixels},
                 {"shading", chart.plan.look.shading == Shading::off ? "off" : "headlight"},
                 {"repeat", chart.plan.repetitions},
                 {"slow_seconds", chart.plan.slowMilliseconds / 1e3},
                 {"views", viewsJson(chart)}};
    root.update(lightJson(chart.plan.look));
    writeWholeFile(path, root.dump(2, ' ', false, json::error_handler_t::replace) + '\n');
}

} // namespace brickwall
