// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Commands.h"
#include "Flight.h"
#include "Folder.h"
#include "TerminalProgress.h"

#include "brickwall/channels/FrameRate.h"
#include "brickwall/channels/FrameTime.h"
#include "brickwall/channels/LeveredViews.h"
#include "brickwall/core/base/Error.h"
#include "brickwall/core/scene/SceneArguments.h"
#include "brickwall/core/scene/SceneSetup.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <string>

namespace brickwall {
namespace {

struct Options
{
    SceneOptions scene;
    std::string file;
    std::string size = "640x480";
    std::string out;
    FlightOptions flight;
    std::string clock = "wall";
    bool compare = false;
};

void print(const char* name, const std::vector<FlightFrame>& frames, const Options& options, const FrameLevers& finest)
{
    const FlightShares shares = sharesOf(frames, 1.0 / options.flight.fps, finest);
    fmt::print(
        "{:<16} {:>6} frames; after the first second {:.1f} % within 20 % of the target, {:.1f} % longer, {:.1f} % "
        "shorter and as wanted; median RMS error {:.2g}\n",
        name, frames.size(), 100 * shares.within, 100 * shares.longer, 100 * shares.shorterAtFinest,
        shares.medianRmsError);
}

int flight(Options options)
{
    options.flight.size = parsePixelSize(options.size, "--size");
    options.flight.processorTime = options.clock == "processor";
    if (options.flight.processorTime && options.scene.threads != 1)
        throw Error("--clock", "the processor's time is that of a frame with one thread only; add --threads 1");
    makeOutputFolder(options.out);
    TerminalProgress progress;
    const Executor executor(options.scene.threads);
    const PreparedScene prepared = prepareScene(options.scene, executor, progress);
    const Flight flight = readFlight(options.file, prepared.bounds);
    const RenderSettings settings = renderSettings(options.scene);
    const Renderer renderer(prepared.scene, executor);

    FlownFlight flown{options.scene.data, describe(settings), flight.seconds(), options.flight, {}, {}};
    flown.frames = fly(renderer, settings, flight, prepared.bounds, options.flight, progress);
    if (options.compare)
        flown.earlier = flyByEarlierRule(renderer, settings, flight, prepared.bounds, options.flight, progress);
    const std::filesystem::path folder(options.out);
    writeFlightCsv((folder / "flight.csv").string(), flown);
    writeFlightSvg((folder / "flight.svg").string(), flown);
    const FrameLevers finest = FrameCost(leversOf(settings)).finest();
    print("held", flown.frames, options, finest);
    if (options.compare)
        print("earlier plugin", flown.earlier, options, finest);
    return 0;
}

} // namespace

void addFlightCommand(CLI::App& app, Action& chosen)
{
    CLI::App* command = app.add_subcommand(
        "flight", "a camera flies through data while the frame time is held: flight.csv, flight.svg");
    auto options = std::make_shared<Options>();
    addDataOption(*command, options->scene);
    command->add_option("--flight", options->file, "the key poses with their times, a JSON file")->required();
    command->add_option("--out", options->out, "the folder for the files")->required();
    command
        ->add_option(
            "--fps", options->flight.fps,
            fmt::format("frames per second to be held, {:g} to {:g} (default {:g})", lowestFps, highestFps, usualFps))
        ->check(CLI::Range(lowestFps, highestFps));
    command->add_option("--size", options->size, "WxH (default 640x480)");
    command
        ->add_option("--measure", options->flight.measureEvery,
                     "compare every Nth frame with one as accurate as wanted, beside the flight's time (default 5; 0: "
                     "none)")
        ->check(CLI::Range(0, 1000000));
    command
        ->add_option(
            "--clock", options->clock,
            "wall, or processor: the time of the process alone, with --threads 1, where others use the machine "
            "as well (default wall)")
        ->check(CLI::IsMember({"wall", "processor"}));
    command->add_flag("--compare", options->compare,
                      "fly again by the rule of the earlier plugin (docs/frame-time.md)");
    addSceneOptions(*command, options->scene);
    addMethodOptions(*command, options->scene);
    command->callback([options, &chosen] {
        checkSceneOptions(options->scene, commandLinePlace);
        chosen = [options] { return flight(*options); };
    });
}

} // namespace brickwall
