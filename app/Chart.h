// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Renderer.h"
#include "brickwall/core/scene/SceneSetup.h"

#include <string>
#include <vector>

namespace brickwall {

/// A method with its parameter: dt of those that take steps, the tolerance of bounded, nothing of reference.
struct ChartPoint
{
    Method method = Method::bounded;
    double parameter = 0.0;
};

/// What is measured: every point on every view.
struct ChartPlan
{
    std::vector<View> views; ///< with different names
    std::vector<ChartPoint> points;
    RenderSettings look; ///< of all points, but for the method and its parameter; lod not of the reference
    int repetitions = 5;
    double slowMilliseconds = 0.0; ///< what takes longer than this per frame is measured once
};

/// What came of one point on one view. Errors are those of a linear premultiplied RGBA component against the reference.
struct ChartRow
{
    ChartPoint point;
    std::string view;
    std::vector<double> milliseconds; ///< per frame, one per repetition
    double maxError = 0.0;
    double rmsError = 0.0;
    double similarity = 1.0; ///< SSIM of the pictures
    double samplesPerRay = 0.0, fetchesPerRay = 0.0, regionsPerRay = 0.0;
    double largestBound = 0.0; ///< of bounded
    double allowedError = 0.0; ///< of bounded: its tolerance, and that of a light
    std::uint64_t pixelsBeyond = 0;
};

/// All that the files of a chart are written from.
struct Chart
{
    std::string data;
    ChartPlan plan;
    std::vector<ChartRow> rows; ///< by method as in the plan, parameter, view; those of the reference come last
    int threads = 1;
};

/// "1/255", "3e-4", "0.5": the parameter as it is written beside its point; empty for the reference.
std::string parameterLabel(const ChartPoint& point);

/// Whether the bounded method made a larger error than it was allowed.
bool isBeyondTolerance(const ChartRow& row);

/// The settings of a point. The opacity at which stepping ends a ray is that of `render` at dt = 0.5 and above; below,
/// what is left of the ray shrinks with dt^2, as the midpoint rule's error does, so that a chart shows the error of the
/// steps and not of the early end. The reference has a light to 1/4096 and ambient occlusion by 1024 rays, whatever the
/// others have.
RenderSettings settingsOf(const ChartPoint& point, const ChartPlan& plan);

/// Renders the reference once per view, then all points in turn, again and again, so that a drift of the machine hits
/// all alike. Throws Cancelled.
std::vector<ChartRow> measureChart(const Renderer& renderer, const ChartPlan& plan, Progress& progress);

/// The files of a chart: a table, a picture, and what was measured where. Nothing partial is left under these names.
void writeChartCsv(const std::string& path, const Chart& chart);
void writeChartSvg(const std::string& path, const Chart& chart, const PreparedScene& prepared);
void writeChartJson(const std::string& path, const Chart& chart, const PreparedScene& prepared);

} // namespace brickwall
