// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Chart.h"

#include "brickwall/core/base/Stopwatch.h"
#include "brickwall/core/render/Compare.h"
#include "brickwall/core/render/Similarity.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <span>

namespace brickwall {
namespace {

/// Shows nothing of the many frames, and hands on that the user wants to stop.
class FrameProgress : public Progress
{
public:
    explicit FrameProgress(const Progress& outer) : outer_(outer) {}
    void advance(std::uint64_t) override
    {
        if (outer_.cancelled())
            cancel();
    }

private:
    const Progress& outer_;
};

struct TimedFrame
{
    Frame frame;
    double milliseconds = 0.0;
    ViewStatistics statistics;
};

TimedFrame renderTimed(const Renderer& renderer, const View& view, const RenderSettings& settings,
                       const Progress& progress)
{
    progress.check();
    FrameProgress inner(progress);
    std::vector<ViewStatistics> statistics;
    const Stopwatch stopwatch;
    std::vector<Frame> frames = renderer.render(std::span(&view, 1), settings, inner, &statistics);
    const double milliseconds = stopwatch.milliseconds();
    return {std::move(frames.front()), milliseconds, statistics.front()};
}

ChartRow rowOf(const ChartPoint& point, const RenderSettings& look, const TimedFrame& timed, const Frame& reference)
{
    const FrameDifference difference = compareFrames(timed.frame, reference);
    const auto perRay = [&](std::uint64_t count) { return double(count) / double(timed.statistics.rays); };
    ChartRow row;
    row.point = point;
    row.view = timed.frame.view.name;
    row.maxError = difference.max;
    row.rmsError = difference.rms;
    row.similarity = structuralSimilarity(timed.frame, reference);
    row.samplesPerRay = perRay(timed.statistics.counts.samples);
    row.fetchesPerRay = perRay(timed.statistics.counts.fetches);
    row.regionsPerRay = perRay(timed.statistics.counts.regionsVisited);
    row.largestBound = timed.statistics.largestBound;
    row.allowedError = point.parameter + (look.light ? look.light->tolerance : 0.0);
    row.pixelsBeyond = timed.statistics.pixelsBeyond;
    return row;
}

/// Indices of the points in the order in which they are rendered: the methods take turns.
std::vector<std::size_t> turns(const std::vector<ChartPoint>& points)
{
    std::map<Method, std::size_t> seen;
    std::vector<std::pair<std::size_t, std::size_t>> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        order.emplace_back(seen[points[i].method]++, i);
    std::sort(order.begin(), order.end());
    std::vector<std::size_t> indices;
    for (const auto& [turn, index] : order)
        indices.push_back(index);
    return indices;
}

} // namespace

std::string parameterLabel(const ChartPoint& point)
{
    if (point.method == Method::reference)
        return {};
    if (takesSteps(point.method))
        return fmt::format("{:g}", point.parameter);
    const double exponent = std::floor(std::log10(point.parameter) + 1e-9);
    const double digits = point.parameter / std::pow(10.0, exponent);
    if (std::abs(digits - std::round(digits)) < 1e-6)
        return fmt::format("{:g}e{:g}", std::round(digits), exponent);
    const double inverse = 1.0 / point.parameter;
    if (std::abs(inverse - std::round(inverse)) < 1e-6 * inverse)
        return fmt::format("1/{:.0f}", inverse);
    return fmt::format("{:.3g}", point.parameter);
}

bool isBeyondTolerance(const ChartRow& row)
{
    return row.point.method == Method::bounded && !(row.maxError <= row.allowedError);
}

RenderSettings settingsOf(const ChartPoint& point, const ChartPlan& plan)
{
    RenderSettings settings = plan.look;
    settings.method = point.method;
    if (point.method == Method::reference) {
        if (settings.light)
            settings.light->tolerance = std::min(settings.light->tolerance, 1.0f / 4096.0f);
        if (settings.ambientOcclusion)
            settings.ambientOcclusion->rays = 1024;
    }
    if (point.method == Method::bounded)
        settings.bounded.tolerance = static_cast<float>(point.parameter);
    if (takesSteps(point.method)) {
        settings.step.dt = static_cast<float>(point.parameter);
        const double ofDefault = point.parameter / StepConfig().dt;
        const double left = (1.0 - StepConfig().terminationOpacity) * std::min(1.0, ofDefault * ofDefault);
        settings.step.terminationOpacity = static_cast<float>(1.0 - left);
    }
    return settings;
}

std::vector<ChartRow> measureChart(const Renderer& renderer, const ChartPlan& plan, Progress& progress)
{
    progress.begin("rendering the reference", plan.views.size());
    std::vector<Frame> references;
    std::vector<ChartRow> referenceRows;
    for (const View& view : plan.views) {
        const ChartPoint point{Method::reference, 0.0};
        TimedFrame timed = renderTimed(renderer, view, settingsOf(point, plan), progress);
        referenceRows.push_back(rowOf(point, plan.look, timed, timed.frame));
        referenceRows.back().milliseconds.push_back(timed.milliseconds);
        references.push_back(std::move(timed.frame));
        progress.advance(1);
    }

    const std::vector<std::size_t> order = turns(plan.points);
    std::vector<ChartRow> rows(plan.points.size() * plan.views.size());
    progress.begin("measuring", rows.size() * static_cast<std::size_t>(plan.repetitions));
    for (int repetition = 0; repetition < plan.repetitions; ++repetition)
        for (const std::size_t i : order)
            for (std::size_t v = 0; v < plan.views.size(); ++v) {
                ChartRow& row = rows[i * plan.views.size() + v];
                progress.advance(1);
                if (repetition > 0 && row.milliseconds.front() > plan.slowMilliseconds)
                    continue;
                const ChartPoint& point = plan.points[i];
                const TimedFrame timed = renderTimed(renderer, plan.views[v], settingsOf(point, plan), progress);
                if (repetition == 0) // the same bits every time
                    row = rowOf(point, plan.look, timed, references[v]);
                row.milliseconds.push_back(timed.milliseconds);
            }
    progress.end();
    rows.insert(rows.end(), referenceRows.begin(), referenceRows.end());
    return rows;
}

} // namespace brickwall
