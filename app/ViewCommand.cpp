// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Commands.h"
#include "RenderViews.h"
#include "TerminalProgress.h"

#include "brickwall/channels/RigFiles.h"
#include "brickwall/core/scene/SceneArguments.h"
#include "brickwall/core/scene/SceneSetup.h"

#include <CLI/CLI.hpp>

#include <memory>
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
};

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
    ViewerOptions viewer;
    viewer.frames = options.frames;
    viewer.screenshotFolder = options.screenshots;
    viewer.renderThreads = options.scene.threads;
    viewer.preview = options.preview;
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
    command->add_option("--frames", options->frames, "draw N complete frames and end (default 0: until Escape)")
        ->check(CLI::Range(0, 1000000));
    command->add_option("--screenshots", options->screenshots,
                        "with --frames: write a PNG of every window into this folder");
    command->callback([options, &chosen] {
        checkSceneOptions(options->scene, commandLinePlace);
        chosen = [options] { return view(*options); };
    });
}

} // namespace brickwall
