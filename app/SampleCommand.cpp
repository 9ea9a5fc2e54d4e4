// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Commands.h"
#include "TerminalProgress.h"

#include "brickwall/core/io/DataSet.h"
#include "brickwall/core/model/PadField.h"
#include "brickwall/core/scene/SceneArguments.h"
#include "brickwall/core/scene/SceneSetup.h"
#include "brickwall/core/trace/SamplePoints.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cerrno>
#include <charconv>
#include <cstring>
#include <fstream>
#include <utility>

namespace brickwall {
namespace {

/// A number at the start of `text`, which is shortened by it and a following comma or blanks.
bool takeNumber(std::string_view& text, double& number)
{
    const auto skip = [&](std::string_view characters) {
        text.remove_prefix(std::min(text.find_first_not_of(characters), text.size()));
    };
    skip(" \t");
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc())
        return false;
    text.remove_prefix(static_cast<std::size_t>(end - text.data()));
    skip(" \t\r");
    if (!text.empty() && text.front() == ',')
        text.remove_prefix(1);
    return true;
}

/// Lines "x,y,z" in world space; a first line that starts with a letter is a heading, '#' starts a comment, further
/// columns are ignored.
std::vector<vec3d> readPoints(const std::string& path)
{
    std::ifstream in(path);
    if (!in)
        throw Error(path, fmt::format("cannot be read: {}", std::strerror(errno)));
    std::vector<vec3d> points;
    std::string line;
    for (std::size_t number = 1; std::getline(in, line); ++number) {
        std::string_view rest = line;
        const bool heading = number == 1 && !line.empty() && std::isalpha(static_cast<unsigned char>(line.front()));
        if (heading || line.empty() || line.front() == '#' || line == "\r")
            continue;
        vec3d p;
        if (!takeNumber(rest, p.x) || !takeNumber(rest, p.y) || !takeNumber(rest, p.z))
            throw Error(fmt::format("{}:{}", path, number), fmt::format("expected x,y,z, found \"{}\"", line));
        points.push_back(p);
    }
    if (in.bad()) // a folder opens, but cannot be read
        throw Error(path, fmt::format("cannot be read: {}", std::strerror(errno)));
    return points;
}

int samplePointsOf(const SceneOptions& options, const std::string& pointsFile)
{
    checkSceneOptions(options, commandLinePlace);
    const std::vector<vec3d> points = readPoints(pointsFile);
    TerminalProgress progress;
    const Executor executor(options.threads);
    const auto data = openData(options);
    Model model = data->load(std::vector{options.field.empty() ? data->defaultField() : options.field}, executor,
                             progress, nonFiniteOf(options));
    const RegionTree regions = buildRegions(model.bricks, executor, progress);
    const PaddedField field = padField(std::move(model.fields.front()), model.bricks, regions, executor, progress);
    progress.end();

    std::vector<PointSample> samples(points.size());
    samplePoints(regions, field, model.worldFromVoxel, points, samples, executor);
    fmt::print("x,y,z,value,gx,gy,gz,valid\n");
    for (std::size_t i = 0; i < points.size(); ++i) {
        const PointSample& s = samples[i];
        fmt::print("{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{:.9g},{}\n", points[i].x, points[i].y, points[i].z,
                   s.value, s.gradient.x, s.gradient.y, s.gradient.z, s.valid ? 1 : 0);
    }
    return 0;
}

} // namespace

void addSampleCommand(CLI::App& app, Action& chosen)
{
    CLI::App* command = app.add_subcommand("sample", "the reconstructed field and its gradient at points, as CSV");
    struct Options
    {
        SceneOptions scene;
        std::string points;
    };
    auto options = std::make_shared<Options>();
    addDataOption(*command, options->scene);
    command->add_option("--points", options->points, "CSV file of x,y,z in world space")->required();
    command->add_option("--field", options->scene.field, "the field (default: the data set's choice)");
    addNonFiniteOption(*command, options->scene);
    addThreadsOption(*command, options->scene.threads);
    command->callback(
        [options, &chosen] { chosen = [options] { return samplePointsOf(options->scene, options->points); }; });
}

} // namespace brickwall
