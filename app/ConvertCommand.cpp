// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Commands.h"
#include "TerminalProgress.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/Convert.h"
#include "brickwall/core/scene/SceneArguments.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <csignal>
#include <filesystem>
#include <string_view>
#include <system_error>

namespace brickwall {
namespace {

struct Options
{
    SceneOptions scene;
    std::string destination;
    std::vector<std::string> fields;
    std::vector<double> box;
    std::string levels;
    bool compress = false;
    bool overwrite = false;
};

/// A level; an Error naming the whole option for anything else.
int levelOf(std::string_view text, const std::string& levels)
{
    int level = -1;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), level);
    if (error != std::errc() || end != text.data() + text.size() || level < 0 || level > maxLevel)
        throw Error("--levels",
                    fmt::format("expected A:B or A, levels from 0 (the finest) to {}, found \"{}\"", maxLevel, levels));
    return level;
}

CellChoice cellsOf(const Options& options)
{
    CellChoice cells;
    if (!options.levels.empty()) {
        const std::string_view text = options.levels;
        const std::size_t colon = text.find(':');
        cells.finestLevel = levelOf(text.substr(0, colon), options.levels);
        cells.coarsestLevel =
            colon == std::string_view::npos ? cells.finestLevel : levelOf(text.substr(colon + 1), options.levels);
        if (cells.finestLevel > cells.coarsestLevel)
            throw Error("--levels", fmt::format("expected A:B with A at most B, found \"{}\"", options.levels));
    }
    if (options.box.empty())
        return cells;
    if (options.box.size() != 6)
        throw Error("--box", fmt::format("expected six numbers x0,y0,z0,x1,y1,z1, found {}", options.box.size()));
    Box3d box;
    for (int axis = 0; axis < 3; ++axis) {
        box.lower[axis] = options.box[static_cast<std::size_t>(axis)];
        box.upper[axis] = options.box[static_cast<std::size_t>(axis) + 3];
        if (!(box.lower[axis] < box.upper[axis]) || !std::isfinite(box.extent()[axis]))
            throw Error("--box", fmt::format("expected a box with a volume, found {} to {} along {}", box.lower[axis],
                                             box.upper[axis], "xyz"[axis]));
    }
    cells.box = box;
    return cells;
}

ConvertOptions convertOptions(const Options& options)
{
    return {options.fields, cellsOf(options), nonFiniteOf(options.scene), options.compress, options.overwrite};
}

void checkOptions(const Options& options)
{
    checkSceneOptions(options.scene, commandLinePlace);
    cellsOf(options);
    checkDestination(options.destination);
    std::error_code none;
    if (std::filesystem::equivalent(options.scene.data, options.destination, none))
        throw Error(options.destination, "expected another file than the one that is converted");
}

int convertData(const Options& options)
{
    std::signal(SIGXFSZ, SIG_IGN); // a file that may not grow is an error like a full disk, and no reason to die
    TerminalProgress progress;
    const Executor executor(options.scene.threads);
    convert(*openData(options.scene), options.destination, convertOptions(options), executor, progress);
    return 0;
}

} // namespace

void addConvertCommand(CLI::App& app, Action& chosen)
{
    CLI::App* command = app.add_subcommand("convert", "write data in another format: " + targetExtensions());
    auto options = std::make_shared<Options>();
    addDataOption(*command, options->scene);
    command->add_option("DESTINATION", options->destination, "the file to write: " + targetExtensions())->required();
    command->add_option("--field", options->fields, "a field to write (may be repeated; default: all that info lists)")
        ->allow_extra_args(false);
    addNonFiniteOption(*command, options->scene);
    command->add_option("--box", options->box, "x0,y0,z0,x1,y1,z1 in world space: write the cells in it")
        ->delimiter(',')
        ->allow_extra_args(false);
    command->add_option("--levels", options->levels, "A:B: write the leaf cells of these levels, 0 being the finest");
    command->add_flag("--compress", options->compress, "of .vthb: compress with zlib");
    command->add_flag("--overwrite", options->overwrite, "replace what is there");
    addThreadsOption(*command, options->scene.threads);
    command->callback([options, &chosen] {
        checkOptions(*options);
        chosen = [options] { return convertData(*options); };
    });
}

} // namespace brickwall
