// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Commands.h"
#include "Flight.h"
#include "RenderViews.h"
#include "TerminalProgress.h"

#include "brickwall/channels/FrameRate.h"
#include "brickwall/channels/RigFiles.h"
#include "brickwall/core/base/Error.h"
#include "brickwall/core/scene/SceneArguments.h"
#include "brickwall/core/scene/SceneSetup.h"
#include "brickwall/core/shade/TransferFunctionFile.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>

#ifdef BRICKWALL_HAS_PLUGIN
#include "brickwall/plugin/RigViewer.h"
#endif

namespace brickwall {
namespace {

struct Options
{
    SceneOptions scene;
    std::string rig = "desktop";
    std::string size;
    int frames = 0;
    std::string screenshots;
    bool preview = false;
    std::optional<double> fps = usualFps; ///< none: off
    std::string flight;
    std::string writeTf;
};

#ifdef BRICKWALL_HAS_PLUGIN
/// Ends with the last key pose.
std::function<std::optional<mat4d>(double)> flightOf(const Flight& flight, const Rig& rig, const Box3d& bounds)
{
    return [=, landed = false](double seconds) mutable -> std::optional<mat4d> {
        if (landed)
            return std::nullopt;
        landed = seconds >= flight.seconds();
        return roomFromWorldAt(flight.at(seconds), rig, bounds);
    };
}
#endif

int view(const Options& options)
{
#ifdef BRICKWALL_HAS_PLUGIN
    if (!options.screenshots.empty() && options.frames == 0)
        throw Error("--screenshots", "expected --frames N with it, the number of frames after which to take them");
    TerminalProgress progress;
    Rig rig = loadRig(options.rig);
    if (!options.size.empty())
        rig = resized(std::move(rig), parsePixelSize(options.size, "--size"));
    rig.background = backgroundColor(options.scene, rig.background);
    for (const std::string& warning : warningsOf(rig))
        progress.note("warning: " + warning);

    const Executor executor(options.scene.threads);
    const PreparedScene prepared = prepareScene(options.scene, executor, progress);
    if (!options.writeTf.empty())
        writeTransferFunction(prepared.transferFunction, options.writeTf);
    ViewerOptions viewer;
    viewer.frames = options.frames;
    viewer.screenshotFolder = options.screenshots;
    viewer.renderThreads = options.scene.threads;
    viewer.preview = options.preview;
    viewer.fps = options.fps;
    if (!options.flight.empty())
        viewer.flight = flightOf(readFlight(options.flight, prepared.bounds), rig, prepared.bounds);
    viewScene(prepared.scene, rig, renderSettings(options.scene), viewer, progress);
    return 0;
#else
    (void)options;
    throw Error("view", "this build has no windows (it was configured with BRICKWALL_PLUGIN=OFF)");
#endif
}

} // namespace

void addViewCommand(CLI::App& app, Action& chosen)
{
    CLI::App* command =
        app.add_subcommand("view", "windows, one per window of the rig; mouse and keyboard move data and head");
    auto options = std::make_shared<Options>();
    addDataOption(*command, options->scene);
    command->add_option("--rig", options->rig,
                        "a display configuration: a file, or desktop, stereo-wall, cave5, tiled-wall");
    command->add_option("--size", options->size, "WxH of every viewport (default: the rig's)");
    addSceneOptions(*command, options->scene);
    addBackgroundOption(*command, options->scene);
    addMethodOptions(*command, options->scene);
    command->add_flag("--preview", options->preview,
                      "one window that shows the rig from outside: its screens, what they show, heads and frusta");
    command->add_option_function<std::string>(
        "--fps", [options](const std::string& text) { options->fps = parseFps(text, "--fps"); },
        fmt::format("frames per second to be held while something moves, {:g} to {:g}, or off (default {:g}): what "
                    "moves is rendered less accurately, what rests as --tolerance or --dt say",
                    lowestFps, highestFps, usualFps));
    command->add_option("--flight", options->flight,
                        "fly through the data: a JSON file of key poses with their times (docs/frame-time.md)");
    command
        ->add_option("--frames", options->frames,
                     "draw N complete frames, after the flight if there is one, and end (default 0: until Escape)")
        ->check(CLI::Range(0, 1000000));
    command->add_option("--screenshots", options->screenshots,
                        "with --frames: write a PNG of every window into this folder");
    addWriteTfOption(*command, options->writeTf);
    command->callback([options, &chosen] {
        checkSceneOptions(options->scene, commandLinePlace);
        chosen = [options] { return view(*options); };
    });
}

} // namespace brickwall
