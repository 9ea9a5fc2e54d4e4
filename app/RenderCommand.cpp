// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Commands.h"
#include "Folder.h"
#include "RenderViews.h"
#include "ShowPictures.h"
#include "Statistics.h"
#include "TerminalProgress.h"

#include "brickwall/core/base/Stopwatch.h"
#include "brickwall/core/render/Accumulation.h"
#include "brickwall/core/render/ImageFiles.h"
#include "brickwall/core/render/Legend.h"
#include "brickwall/core/scene/SceneArguments.h"
#include "brickwall/core/scene/SceneSetup.h"
#include "brickwall/core/shade/TransferFunctionFile.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <utility>
#include <vector>

namespace brickwall {
namespace {

struct Options
{
    SceneOptions scene;
    ViewOptions views;
    std::string out;
    std::vector<std::string> formats{"png"};
    bool legend = false;
    std::string show; ///< one of showNames, or empty
    int samplesPerPixel = 1;
    int repeat = 1;
    std::string stats;
    std::string writeTf;
};

/// Names of channels and views may hold anything; those of files may not.
std::string fileName(std::string name)
{
    std::replace_if(
        name.begin(), name.end(),
        [](unsigned char c) { return !(std::isalnum(c) || c == '-' || c == '_' || c == '.'); }, '_');
    return name.empty() || name.front() == '.' ? "_" + name : name;
}

std::vector<std::string> fileNames(const std::vector<View>& views)
{
    std::vector<std::string> names;
    for (const View& view : views) {
        names.push_back(fileName(view.name));
        if (std::count(names.begin(), names.end(), names.back()) > 1)
            throw Error(view.name, "two views would be written to the same file");
    }
    return names;
}

/// What would make the work futile is found before it.
void checkOutputs(const Options& options)
{
    const auto& formats = options.formats;
    if (options.legend && std::find(formats.begin(), formats.end(), "png") == formats.end())
        throw Error("--legend", "is drawn into the PNG; add png to --format");
    makeOutputFolder(options.out);
    if (options.stats.empty())
        return;
    const std::filesystem::path folder = std::filesystem::path(options.stats).parent_path();
    if (std::filesystem::is_directory(options.stats))
        throw Error("--stats", fmt::format("{} is a folder; expected a file", options.stats));
    if (!folder.empty() && !std::filesystem::is_directory(folder))
        throw Error("--stats",
                    fmt::format("{} cannot be written: there is no folder {}", options.stats, folder.string()));
}

/// The colours over the values that they are of.
TransferFunction legendOf(const PreparedScene& prepared)
{
    const TransferFunction& tf = prepared.scene.transferFunction;
    return tf.colorField ? colorFunction(tf) : tf;
}

void writeFrame(const Frame& frame, const Options& options, const PreparedScene& prepared, const vec3f& background,
                const std::string& stem)
{
    for (const std::string& format : options.formats) {
        if (format == "exr") {
            writeExr(frame, stem + ".exr");
            continue;
        }
        Image image = imageOver(frame, background);
        if (options.legend)
            drawLegend(image, legendOf(prepared), prepared.colorField, prepared.colorUnit);
        writePng(image, stem + ".png");
    }
}

/// In place of the colours, how they came about.
void writeShown(const Renderer& renderer, const View& view, const Options& options, const Executor& executor,
                Progress& progress, const std::string& stem)
{
    const auto name = std::find(showNames.begin(), showNames.end(), options.show);
    const ShownView shown = showView(renderer, view, renderSettings(options.scene),
                                     static_cast<Show>(name - showNames.begin()), executor, progress);
    const std::string path = stem + "-" + options.show;
    for (const std::string& format : options.formats) {
        if (format == "exr") {
            writeExr(shown.numbers, path + ".exr");
            continue;
        }
        Image image = imageOver(shown.colors, vec3f(0.0f));
        if (options.legend)
            drawLegend(image, shown.scale, shown.title, "");
        writePng(image, path + ".png");
    }
    fmt::print("{}: {} up to {:.4g}, {:.4g} on average\n", view.name, shown.title, shown.scale.range.hi, shown.mean);
}

void add(const ViewStatistics& more, ViewStatistics& sum)
{
    sum.milliseconds += more.milliseconds;
    sum.rays += more.rays;
    sum.counts += more.counts;
    sum.surfaceHits += more.surfaceHits;
    sum.pixelsBeyond = std::max(sum.pixelsBeyond, more.pixelsBeyond);
    if (more.largestBound > sum.largestBound)
        sum.largestBound = more.largestBound;
    if (sum.beyondBecause.empty())
        sum.beyondBecause = more.beyondBecause;
    sum.memberSamples.resize(std::max(sum.memberSamples.size(), more.memberSamples.size()));
    for (std::size_t level = 0; level < more.memberSamples.size(); ++level)
        sum.memberSamples[level] += more.memberSamples[level];
}

/// The mean of as many frames as there are samples per pixel.
std::vector<Frame> renderSamples(const Renderer& renderer, const std::vector<View>& views, const Options& options,
                                 Progress& progress, std::vector<ViewStatistics>& statistics)
{
    const RenderSettings settings = renderSettings(options.scene);
    std::vector<Frame> means = renderer.render(views, settings, progress, &statistics);
    if (options.samplesPerPixel == 1)
        return means;
    Accumulation accumulation;
    accumulation.next(views);
    accumulation.add(std::move(means));
    while (accumulation.count() < options.samplesPerPixel) {
        std::vector<ViewStatistics> more;
        means = accumulation.add(renderer.render(accumulation.next(views), settings, progress, &more));
        for (std::size_t i = 0; i < more.size(); ++i)
            add(more[i], statistics[i]);
    }
    return means;
}

int render(const Options& options)
{
    const ViewsForBounds viewsForBounds = readViews(options.views);
    checkOutputs(options);
    TerminalProgress progress;
    const Executor executor(options.scene.threads);
    const PreparedScene prepared = prepareScene(options.scene, executor, progress);
    if (!options.writeTf.empty())
        writeTransferFunction(prepared.transferFunction, options.writeTf);
    const ViewsToRender toRender = viewsForBounds(prepared.bounds, progress);
    const std::vector<std::string> stems = fileNames(toRender.views);
    const RenderSettings settings = renderSettings(options.scene);
    const vec3f background = backgroundColor(options.scene, toRender.background);

    const Renderer renderer(prepared.scene, executor);
    std::vector<Frame> frames;
    RenderStatistics statistics;
    for (int i = 0; i < options.repeat; ++i) {
        const Stopwatch stopwatch;
        std::vector<ViewStatistics> views;
        frames = renderSamples(renderer, toRender.views, options, progress, views);
        statistics.totalMilliseconds.push_back(stopwatch.milliseconds());
        statistics.repetitions.push_back(std::move(views));
    }
    progress.begin("writing images", frames.size());
    for (std::size_t i = 0; i < frames.size(); ++i) {
        progress.check();
        const std::string stem = (std::filesystem::path(options.out) / stems[i]).string();
        if (options.show.empty())
            writeFrame(frames[i], options, prepared, background, stem);
        else
            writeShown(renderer, toRender.views[i], options, executor, progress, stem);
        progress.advance(1);
    }
    progress.end();
    if (!options.stats.empty())
        writeStatistics(options.stats, statistics, options.scene.data, settings, prepared, frames, executor.threads());
    printSummary(statistics, settings, prepared, options.out);
    return 0;
}

} // namespace

void addRenderCommand(CLI::App& app, Action& chosen)
{
    CLI::App* command = app.add_subcommand("render", "pictures of every view, as PNG or EXR");
    auto options = std::make_shared<Options>();
    addDataOption(*command, options->scene);
    command->add_option("--out", options->out, "the folder for the pictures, named after channel and eye")->required();
    addViewOptions(*command, options->views, "WxH of every view (default 1024x1024, or the rig's)");
    addSceneOptions(*command, options->scene);
    addBackgroundOption(*command, options->scene);
    addMethodOptions(*command, options->scene);
    command->add_option("--format", options->formats, "png, exr or both: png,exr (default png)")
        ->delimiter(',')
        ->check(CLI::IsMember({"png", "exr"}));
    command->add_flag("--legend", options->legend, "draw the colour bar into the PNG");
    command
        ->add_option(
            "--show", options->show,
            "instead of the colours, per pixel: cost (samples), regions, levels (the finest) or error (of bounded)")
        ->check(CLI::IsMember(std::vector<std::string>(showNames.begin(), showNames.end())));
    command
        ->add_option("--samples-per-pixel", options->samplesPerPixel,
                     "average N frames of other points of the pixels, so that edges are smooth (default 1: centres)")
        ->check(CLI::Range(1, 65536))
        ->excludes("--show");
    command->add_option("--repeat", options->repeat, "render N times, for --stats")->check(CLI::Range(1, 100000));
    command->add_option("--stats", options->stats, "write times, samples and bounds to this JSON file");
    addWriteTfOption(*command, options->writeTf);
    command->callback([options, &chosen] {
        checkSceneOptions(options->scene, commandLinePlace);
        chosen = [options] { return render(*options); };
    });
}

} // namespace brickwall
