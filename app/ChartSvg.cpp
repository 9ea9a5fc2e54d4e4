// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The picture of a chart: a row of three panels per view, time upwards against maximum error, RMS error and 1 - SSIM.
#include "Chart.h"
#include "PlotAxes.h"

#include "brickwall/core/base/Median.h"
#include "brickwall/core/base/WholeFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <vector>

namespace brickwall {
namespace {

// Of the picture, in its units.
constexpr double left = 66, right = 84, top = 92, bottom = 42;
constexpr double panelWidth = 370, panelHeight = 330, panelGap = 26;
constexpr double headingHeight = 30, axisHeight = 46;
constexpr double rowHeight = headingHeight + panelHeight + axisHeight;
constexpr double markerSize = 7, labelSize = 9.5;
constexpr double leastError = 1e-9; // errors of float frames end here

struct Style
{
    Method method;
    std::string color; ///< told apart by colour-blind people (Okabe, Ito: Color Universal Design, 2008)
    SvgMarker marker;
};

const std::array<Style, 5> styles = {{{Method::bounded, "#d55e00", SvgMarker::circle},
                                      {Method::midpoint, "#0072b2", SvgMarker::square},
                                      {Method::preintegrated, "#009e73", SvgMarker::diamond},
                                      {Method::bracket, "#cc79a7", SvgMarker::triangle},
                                      {Method::fixed, "#777777", SvgMarker::cross}}};

struct Quantity
{
    const char* name;
    double (*of)(const ChartRow&);
};

const std::array<Quantity, 3> quantities = {
    {{"maximum error", [](const ChartRow& row) { return row.maxError; }},
     {"RMS error", [](const ChartRow& row) { return row.rmsError; }},
     {"1 - SSIM", [](const ChartRow& row) { return std::max(0.0, 1.0 - row.similarity); }}}};

bool isDrawn(const ChartRow& row)
{
    return row.point.method != Method::reference;
}

class Picture
{
public:
    Picture(const Chart& chart, const PreparedScene& prepared)
        : chart_(chart),
          prepared_(prepared),
          svg_(left + 3 * panelWidth + 2 * panelGap + right, top + double(chart.plan.views.size()) * rowHeight + bottom)
    {
        std::vector<double> times;
        for (const ChartRow& row : chart.rows)
            if (isDrawn(row))
                times.push_back(median(row.milliseconds));
        std::tie(time_.lo, time_.hi) = rangeAround(times);
    }

    std::string drawn()
    {
        drawTitle();
        drawLegend();
        for (std::size_t v = 0; v < chart_.plan.views.size(); ++v)
            drawRow(chart_.plan.views[v], top + double(v) * rowHeight);
        drawFootnote();
        return svg_.finished();
    }

private:
    void drawTitle()
    {
        svg_.text({left, 26}, fmt::format("{} ({}): time per frame against error", chart_.data, prepared_.field),
                  {.size = 18, .bold = true});
        svg_.text({left, 45},
                  fmt::format("{} cells, {} thread{}, {} ({} lanes), medians of {} interleaved repetitions; error of a "
                              "linear premultiplied RGBA component against the reference",
                              prepared_.cells, chart_.threads, chart_.threads == 1 ? "" : "s", Renderer::target(),
                              Renderer::lanes(), chart_.plan.repetitions),
                  {.size = 12, .color = "#555555"});
    }

    void drawLegend()
    {
        double x = left + 8;
        for (const Style& style : styles) {
            if (std::none_of(chart_.rows.begin(), chart_.rows.end(),
                             [&](const ChartRow& row) { return row.point.method == style.method; }))
                continue;
            svg_.line({x - 8, 68}, {x + 20, 68}, {.color = style.color, .width = 1.6});
            svg_.marker(style.marker, {x + 6, 68}, markerSize + 1, style.color);
            const std::string text =
                fmt::format("{} ({})", nameOf(style.method), takesSteps(style.method) ? "dt" : "tolerance");
            svg_.text({x + 26, 72}, text, {.size = 13, .color = style.color, .bold = true});
            x += 58 + 7.6 * double(text.size());
        }
        svg_.text({x, 72}, "better: to the lower left", {.size = 12, .color = "#555555"});
    }

    void drawRow(const View& view, double y)
    {
        std::vector<const ChartRow*> rows;
        double referenceSeconds = 0.0;
        for (const ChartRow& row : chart_.rows) {
            if (row.view == view.name && isDrawn(row))
                rows.push_back(&row);
            else if (row.view == view.name)
                referenceSeconds = row.milliseconds.front() / 1e3;
        }
        svg_.text({left, y + 20},
                  fmt::format("{}: {} x {} pixels, the reference took {:.3g} s", view.name, view.window.width,
                              view.window.height, referenceSeconds),
                  {.size = 14, .bold = true});
        const double panelTop = y + headingHeight;
        time_.from = panelTop + panelHeight;
        time_.to = panelTop;
        drawTimes(panelTop);
        const std::vector<std::pair<double, std::string>> steps = midpointSteps(rows);
        for (std::size_t i = 0; i < quantities.size(); ++i)
            drawPanel(quantities[i], rows, steps, {left + double(i) * (panelWidth + panelGap), panelTop});
        drawStepAxis(steps, panelTop);
    }

    void drawTimes(double panelTop)
    {
        for (const PlotTick& tick : fineTicks(time_))
            svg_.text({left - 6, time_.at(tick.value) + 4}, tick.label, {.size = 11, .anchor = "end"});
        svg_.text({18, panelTop + 0.5 * panelHeight}, "milliseconds per frame",
                  {.size = 13, .anchor = "middle", .degrees = -90});
    }

    /// Heights at which midpoint's steps lie, with room between their labels; the steps of the literature first.
    std::vector<std::pair<double, std::string>> midpointSteps(const std::vector<const ChartRow*>& rows) const
    {
        std::vector<const ChartRow*> steps;
        for (const ChartRow* row : rows)
            if (row->point.method == Method::midpoint)
                steps.push_back(row);
        const auto rank = [](const ChartRow* row) {
            constexpr std::array first = {1.0, 0.1, 5.0, 0.5, 2.0};
            return std::find(first.begin(), first.end(), row->point.parameter) - first.begin();
        };
        std::stable_sort(steps.begin(), steps.end(),
                         [&](const ChartRow* a, const ChartRow* b) { return rank(a) < rank(b); });
        std::vector<std::pair<double, std::string>> result;
        for (const ChartRow* row : steps) {
            const double y = time_.at(median(row->milliseconds));
            if (std::all_of(result.begin(), result.end(),
                            [&](const auto& other) { return std::abs(other.first - y) >= 12.0; }))
                result.emplace_back(y, parameterLabel(row->point));
        }
        return result;
    }

    void drawStepAxis(const std::vector<std::pair<double, std::string>>& steps, double panelTop)
    {
        if (steps.empty())
            return;
        const std::string& color = styles[1].color;
        const double x = left + 3 * panelWidth + 2 * panelGap;
        for (const auto& [y, label] : steps) {
            svg_.line({x, y}, {x + 5, y}, {.color = color});
            svg_.text({x + 8, y + 4}, label, {.size = 11, .color = color});
        }
        svg_.text({x + 52, panelTop + 0.5 * panelHeight}, "dt of midpoint in that time",
                  {.size = 13, .color = color, .anchor = "middle", .degrees = 90});
    }

    void drawPanel(const Quantity& quantity, const std::vector<const ChartRow*>& rows,
                   const std::vector<std::pair<double, std::string>>& steps, const SvgPoint& corner)
    {
        std::vector<double> all; // of all views, so that the rows can be compared
        for (const ChartRow& row : chart_.rows)
            if (isDrawn(row))
                all.push_back(quantity.of(row));
        LogAxis error{1.0, 10.0, corner.x, corner.x + panelWidth};
        std::tie(error.lo, error.hi) = decadesAround(all, leastError);
        drawGrid(error, steps, corner);
        svg_.text({corner.x + 0.5 * panelWidth, corner.y + panelHeight + 34}, quantity.name,
                  {.size = 13, .anchor = "middle"});

        LabelPlaces places(corner, panelWidth, panelHeight, labelSize);
        for (const ChartRow* row : rows)
            if (std::isfinite(quantity.of(*row)))
                places.avoid({error.at(quantity.of(*row)), time_.at(median(row->milliseconds))}, markerSize + 1);
        for (const Style& style : styles)
            drawSeries(style, quantity, rows, error, places);
        for (const PlotLabel& label : places.labels())
            svg_.text(label.at, label.text, {.size = labelSize, .color = label.color});
    }

    void drawGrid(const LogAxis& error, const std::vector<std::pair<double, std::string>>& steps,
                  const SvgPoint& corner)
    {
        const double rightEnd = corner.x + panelWidth, under = corner.y + panelHeight;
        const SvgStroke grid{.color = "#e4e4e4"};
        for (const PlotTick& tick : fineTicks(time_))
            svg_.line({corner.x, time_.at(tick.value)}, {rightEnd, time_.at(tick.value)}, grid);
        for (const auto& [y, label] : steps)
            svg_.line({corner.x, y}, {rightEnd, y}, {.color = "#b9d7ea", .dashes = "2 4"});
        const std::vector<PlotTick> ticks = decadeTicks(error);
        const std::size_t every = ticks.size() > 8 ? 2 : 1;
        for (std::size_t i = 0; i < ticks.size(); ++i) {
            const double x = error.at(ticks[i].value);
            svg_.line({x, corner.y}, {x, under}, grid);
            // Those at the ends keep clear of the next panel's.
            const char* anchor = i == 0 ? "start" : i + 1 == ticks.size() ? "end" : "middle";
            if (i % every == 0)
                svg_.text({x, under + 16}, ticks[i].label, {.size = 11, .anchor = anchor});
        }
        svg_.rect(corner, panelWidth, panelHeight, "none", {.color = "#555555"});
    }

    void drawSeries(const Style& style, const Quantity& quantity, const std::vector<const ChartRow*>& rows,
                    const LogAxis& error, LabelPlaces& places)
    {
        std::vector<std::pair<SvgPoint, const ChartRow*>> points;
        for (const ChartRow* row : rows)
            if (row->point.method == style.method && std::isfinite(quantity.of(*row)))
                points.emplace_back(SvgPoint{error.at(quantity.of(*row)), time_.at(median(row->milliseconds))}, row);
        std::sort(points.begin(), points.end(),
                  [](const auto& a, const auto& b) { return a.second->point.parameter > b.second->point.parameter; });
        std::vector<SvgPoint> line;
        for (const auto& [point, row] : points)
            line.push_back(point);
        if (line.size() > 1)
            svg_.polyline(line, {.color = style.color, .width = 1.6});
        for (const auto& [point, row] : points) {
            svg_.marker(style.marker, point, markerSize, style.color);
            places.place(point, parameterLabel(row->point), style.color);
        }
    }

    void drawFootnote()
    {
        const auto bad = std::count_if(chart_.rows.begin(), chart_.rows.end(),
                                       [](const ChartRow& row) { return !std::isfinite(row.maxError); });
        const auto once = std::count_if(chart_.rows.begin(), chart_.rows.end(), [&](const ChartRow& row) {
            return isDrawn(row) && static_cast<int>(row.milliseconds.size()) < chart_.plan.repetitions;
        });
        const auto beyond = std::count_if(chart_.rows.begin(), chart_.rows.end(), isBeyondTolerance);
        std::string counts;
        if (once > 0)
            counts += fmt::format("Rendered once, because slower than {:g} s: {} points. ",
                                  chart_.plan.slowMilliseconds / 1e3, once);
        if (beyond > 0)
            counts += fmt::format("Points of bounded with more error than their tolerance: {}. ", beyond);
        if (bad > 0)
            counts += fmt::format("Not finite, and not drawn: {} points.", bad);
        const double y = top + double(chart_.plan.views.size()) * rowHeight + 12;
        const SvgFont font{.size = 11, .color = "#555555"};
        svg_.text({left, y},
                  "Points without error lie on a panel's left edge. Labels that have no room are left out; chart.csv "
                  "has all.",
                  font);
        svg_.text({left, y + 16}, counts, font);
    }

    const Chart& chart_;
    const PreparedScene& prepared_;
    SvgWriter svg_;
    LogAxis time_; ///< milliseconds; the same for all rows
};

} // namespace

void writeChartSvg(const std::string& path, const Chart& chart, const PreparedScene& prepared)
{
    writeWholeFile(path, Picture(chart, prepared).drawn());
}

} // namespace brickwall
