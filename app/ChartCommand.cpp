// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Chart.h"
#include "Commands.h"
#include "Folder.h"
#include "RenderViews.h"
#include "TerminalProgress.h"

#include "brickwall/core/base/Median.h"
#include "brickwall/core/render/Similarity.h"
#include "brickwall/core/scene/SceneArguments.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

namespace brickwall {
namespace {

struct Options
{
    SceneOptions scene;
    ViewOptions views;
    std::string out;
    std::vector<std::string> methods{"bounded", "fixed", "midpoint", "bracket", "preintegrated"};
    std::vector<double> steps{5, 2, 1, 0.5, 0.2, 0.1, 0.05, 0.02, 0.01};
    std::vector<std::string> tolerances{"1e-1", "3e-2", "1e-2", "1/255", "1e-3", "3e-4", "1e-4", "3e-5", "1e-5"};
    int repeat = 5;
    double slowSeconds = 5.0;
};

/// Of the methods that the user named, with all of their parameters, in the order given; each once.
std::vector<ChartPoint> pointsOf(const Options& options)
{
    std::vector<ChartPoint> points;
    std::set<std::pair<Method, float>> seen;
    const auto add = [&](Method method, double parameter, const char* option) {
        if (!seen.emplace(method, static_cast<float>(parameter)).second)
            throw Error(option, fmt::format("{} is there twice", parameter));
        points.push_back({method, parameter});
    };
    std::set<Method> methods;
    for (const std::string& name : options.methods) {
        const Method method = methodOf(name, "--methods");
        if (method == Method::reference)
            throw Error("--methods", "reference is what the others are measured against, and always rendered");
        if (!methods.insert(method).second)
            throw Error("--methods", fmt::format("{} is there twice", name));
        SceneOptions one;
        one.method = name;
        if (takesSteps(method))
            for (const double dt : options.steps) {
                one.dt = dt;
                checkSceneOptions(one, commandLinePlace);
                add(method, dt, "--dt");
            }
        if (method == Method::bounded)
            for (const std::string& tolerance : options.tolerances) {
                one.tolerance = parseNumber(tolerance, "--tolerance");
                checkSceneOptions(one, commandLinePlace);
                add(method, *one.tolerance, "--tolerance");
            }
    }
    return points;
}

/// All of the data from outside and a view from inside, unless the user says what is seen.
ViewsForBounds chartViews(ViewOptions options)
{
    const bool isGiven = !options.rig.empty() || !options.viewFile.empty();
    if (options.size.empty() && !isGiven)
        options.size = "256x256";
    if (isGiven || !options.camera.empty())
        return readViews(options);
    return [size = parsePixelSize(options.size, "--size")](const Box3d& bounds, Progress&) {
        ViewsToRender result;
        result.views = {overview(bounds, size), insideView(bounds, size)};
        result.views[0].name = "outside";
        result.views[1].name = "inside";
        return result;
    };
}

void checkViews(const std::vector<View>& views)
{
    std::set<std::string> names;
    for (const View& view : views) {
        if (!names.insert(view.name).second)
            throw Error(view.name, "two views have this name: a chart could not tell them apart");
        if (view.window.width < similarityWindow || view.window.height < similarityWindow)
            throw Error(view.name,
                        fmt::format("expected at least {0} x {0} pixels, the window of SSIM, found {1} x {2}; see "
                                    "--size",
                                    similarityWindow, view.window.width, view.window.height));
    }
}

void printRows(const Chart& chart)
{
    fmt::print("{:<14} {:>8} {:<12} {:>10} {:>10} {:>10} {:>10}\n", "method", "", "view", "ms", "max error",
               "RMS error", "1 - SSIM");
    for (const ChartRow& row : chart.rows)
        fmt::print("{:<14} {:>8} {:<12} {:>10.2f} {:>10.2g} {:>10.2g} {:>10.2g}\n", nameOf(row.point.method),
                   parameterLabel(row.point), row.view, median(row.milliseconds), row.maxError, row.rmsError,
                   std::max(0.0, 1.0 - row.similarity));
}

int drawChart(const Options& options)
{
    Chart chart;
    chart.data = options.scene.data;
    chart.plan.points = pointsOf(options);
    chart.plan.repetitions = options.repeat;
    chart.plan.slowMilliseconds = 1e3 * options.slowSeconds;
    chart.plan.look = renderSettings(options.scene);
    const ViewsForBounds viewsForBounds = chartViews(options.views);
    makeOutputFolder(options.out);

    TerminalProgress progress;
    const Executor executor(options.scene.threads);
    chart.threads = executor.threads();
    const PreparedScene prepared = prepareScene(options.scene, executor, progress);
    chart.plan.views = viewsForBounds(prepared.bounds, progress).views;
    checkViews(chart.plan.views);

    const Renderer renderer(prepared.scene, executor);
    chart.rows = measureChart(renderer, chart.plan, progress);
    const std::filesystem::path folder(options.out);
    writeChartCsv((folder / "chart.csv").string(), chart);
    writeChartSvg((folder / "chart.svg").string(), chart, prepared);
    writeChartJson((folder / "chart.json").string(), chart, prepared);
    printRows(chart);
    return 0;
}

} // namespace

void addChartCommand(CLI::App& app, Action& chosen)
{
    CLI::App* command =
        app.add_subcommand("chart", "time per frame against error of every method: chart.csv, chart.svg, chart.json");
    auto options = std::make_shared<Options>();
    addDataOption(*command, options->scene);
    command->add_option("--out", options->out, "the folder for the files")->required();
    addViewOptions(*command, options->views, "WxH of every view (default 256x256, or what the rig or the script says)");
    addSceneOptions(*command, options->scene);
    addLodOption(*command, options->scene);
    const auto addList = [&](const char* name, auto& list, const char* description) {
        command->add_option(name, list, description)->delimiter(',')->allow_extra_args(false);
    };
    addList("--methods", options->methods, "which of bounded, fixed, midpoint, bracket, preintegrated (default: all)");
    addList("--dt", options->steps, "the steps of those that take them (default 5,2,1,0.5,0.2,0.1,0.05,0.02,0.01)");
    addList("--tolerance", options->tolerances,
            "those of bounded (default 1e-1,3e-2,1e-2,1/255,1e-3,3e-4,1e-4,3e-5,1e-5)");
    command->add_option("--repeat", options->repeat, "repetitions, of which the median counts (default 5)")
        ->check(CLI::Range(1, 100000));
    command
        ->add_option("--slow", options->slowSeconds,
                     "what takes longer than this many seconds per frame is rendered once (default 5)")
        ->check(CLI::Range(0.0, 1e9));
    command->callback([options, &chosen] {
        checkSceneOptions(options->scene, commandLinePlace);
        chosen = [options] { return drawChart(*options); };
    });
}

} // namespace brickwall
