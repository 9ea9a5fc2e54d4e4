// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "SceneSetup.h"

#include "Stopwatch.h"

#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/shade/ColorMaps.h"
#include "brickwall/core/shade/DefaultTransferFunction.h"
#include "brickwall/core/shade/Srgb.h"
#include "brickwall/core/shade/TransferFunctionFile.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <utility>

#include <sys/resource.h>

namespace brickwall {
namespace {

void checkRange(const std::vector<double>& range)
{
    const float lo = static_cast<float>(range[0]), hi = static_cast<float>(range[1]);
    if (!(lo < hi) || !std::isfinite(lo) || !std::isfinite(hi))
        throw Error("--range", fmt::format("expected LO < HI, both finite and apart as 32-bit floats, found {},{}",
                                           range[0], range[1]));
}

TransferFunction chooseTransferFunctionFor(const SceneOptions& options, const Model& model, Field& field,
                                           Progress& progress)
{
    if (!options.range.empty())
        field.preferredRange = {static_cast<float>(options.range[0]), static_cast<float>(options.range[1])};
    const std::string colors = options.colorMap.empty() ? "Cool Warm" : options.colorMap;
    TransferFunction tf;
    if (options.transferFunction.empty()) {
        DefaultChoice choice = chooseTransferFunction(model, field, colors);
        progress.note(choice.explanation);
        tf = std::move(choice.tf);
    } else {
        const Range& range = field.preferredRange.empty() ? field.range : field.preferredRange;
        tf = readTransferFunction(options.transferFunction, colorMap(colors), range);
        if (!options.colorMap.empty())
            tf.colors = colorMap(colors);
        if (!options.range.empty())
            tf.range = range;
    }
    tf.opacityScale *= static_cast<float>(options.opacityScale);
    checkTransferFunction(tf, options.transferFunction.empty() ? "--range" : options.transferFunction);
    return tf;
}

} // namespace

void addDataOption(CLI::App& command, SceneOptions& options)
{
    command.add_option("DATA", options.data, "a file, a folder, or sample:NAME[:SIZE]")->required();
}

void addThreadsOption(CLI::App& command, int& threads)
{
    constexpr int mostThreads = 1024; // the system refuses far larger numbers in the middle of the work
    command.add_option("--threads", threads, "0 (default): one per core")->check(CLI::Range(0, mostThreads));
}

void addSceneOptions(CLI::App& command, SceneOptions& options)
{
    const auto positive = CLI::Validator(
        [](std::string& text) {
            double value = 0.0;
            return CLI::detail::lexical_cast(text, value) && value > 0.0 && std::isfinite(value)
                       ? std::string()
                       : "expected a finite number above 0, found " + text;
        },
        "> 0");
    command.add_option("--field", options.field, "the field to show (default: the data set's choice)");
    command.add_option("--tf", options.transferFunction,
                       "transfer function: .xf or JSON (default: chosen from the data)");
    command.add_option("--colormap", options.colorMap, "colour map by name")->check([](const std::string& name) {
        try {
            colorMap(name);
            return std::string();
        } catch (const Error& error) {
            return std::string(error.what());
        }
    });
    command.add_option("--range", options.range, "LO,HI: the values that the transfer function covers")
        ->delimiter(',')
        ->expected(2);
    command.add_option("--opacity-scale", options.opacityScale, "multiplies all opacities (default 1)")
        ->check(positive);
    command.add_option("--shading", options.shading, "headlight (default) or off")
        ->check(CLI::IsMember({"headlight", "off"}));
    command.add_option("--background", options.background, "R,G,B in [0, 1] as displayed (default black)")
        ->delimiter(',')
        ->expected(3)
        ->check([](const std::string& text) {
            double value = 0.0; // CLI::Range lets nan through
            return CLI::detail::lexical_cast(text, value) && value >= 0.0 && value <= 1.0
                       ? std::string()
                       : "expected numbers from 0 to 1, found " + text;
        });
    command.add_option("--method", options.method, "midpoint")->check(CLI::IsMember({"midpoint"}));
    command.add_option("--dt", options.dt, "step in finest cell widths of the region (default 0.5)")->check(positive);
    addThreadsOption(command, options.threads);
}

RenderSettings renderSettings(const SceneOptions& options)
{
    RenderSettings settings;
    settings.step.dt = static_cast<float>(options.dt);
    settings.shading = options.shading == "off" ? Shading::off : Shading::headlight;
    return settings;
}

vec3f backgroundColor(const SceneOptions& options, const vec3f& otherwise)
{
    if (options.background.empty())
        return otherwise;
    vec3f color;
    for (int i = 0; i < 3; ++i)
        color[i] = linearFromSrgb(static_cast<float>(options.background[i]));
    return color;
}

PreparedScene prepareScene(const SceneOptions& options, const Executor& executor, Progress& progress)
{
    if (!options.range.empty())
        checkRange(options.range);
    const Stopwatch loading;
    const auto data = openDataSet(options.data);
    const std::string fieldName = options.field.empty() ? data->defaultField() : options.field;
    if (fieldName.empty())
        throw Error(options.data, "there is no field to show");
    Model model = data->load(std::vector{fieldName}, executor, progress);
    for (const std::string& note : model.notes)
        progress.note(note);
    PreparedScene prepared;
    prepared.loadMilliseconds = loading.milliseconds();

    const Stopwatch preparing;
    Field& field = model.fields.front();
    prepared.scene.transferFunction = chooseTransferFunctionFor(options, model, field, progress);
    auto regions = std::make_shared<RegionTree>(buildRegions(model.bricks, executor, progress));
    auto padded = std::make_shared<PaddedField>(padField(field, model.bricks, *regions, executor, progress));
    prepared.prepareMilliseconds = preparing.milliseconds();

    prepared.bytes = regions->bytes() + padded->bytes();
    prepared.scene.regions = std::move(regions);
    prepared.scene.field = std::move(padded);
    if (!model.meshes.empty())
        prepared.scene.triangles = std::make_shared<TriangleScene>(model.meshes);
    prepared.scene.worldFromVoxel = model.worldFromVoxel;
    prepared.name = model.name;
    prepared.field = field.name;
    prepared.unit = field.unit;
    prepared.bounds = worldBounds(model);
    prepared.cells = model.cellCount;
    progress.end();
    return prepared;
}

std::uint64_t peakMemory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::uint64_t(usage.ru_maxrss) * 1024; // Linux counts kilobytes
}

} // namespace brickwall
