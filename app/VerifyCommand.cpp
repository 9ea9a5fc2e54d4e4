// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Commands.h"
#include "TerminalProgress.h"
#include "ViewFile.h"

#include "brickwall/core/scene/SceneArguments.h"
#include "brickwall/core/scene/SceneSetup.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <utility>

namespace brickwall {
namespace {

int verify(ViewFile file)
{
    if (file.scene.data.empty())
        throw Error(file.path, "\"data\" is missing: a script that is verified names its data");
    TerminalProgress progress;
    const Executor executor(file.scene.threads);
    const PreparedScene prepared = prepareScene(file.scene, executor, progress);
    std::vector<View> views;
    for (const ScriptedView& scripted : file.views)
        views.push_back(scripted.view);
    const Renderer renderer(prepared.scene, executor);
    const std::vector<Frame> frames = renderer.render(views, renderSettings(file.scene), progress);
    progress.end();

    int failed = 0;
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const std::vector<std::string> failures = failuresOf(file.views[i].expect, frames[i]);
        failed += !failures.empty();
        fmt::print("{:<6} {}\n", failures.empty() ? "ok" : "FAILED", views[i].name);
        for (const std::string& failure : failures)
            fmt::print("       {}\n", failure);
    }
    fmt::print("{} views, {} as expected, {} not\n", frames.size(), frames.size() - static_cast<std::size_t>(failed),
               failed);
    return failed == 0 ? 0 : 1;
}

} // namespace

void addVerifyCommand(CLI::App& app, Action& chosen)
{
    CLI::App* command =
        app.add_subcommand("verify", "render the views of a script and check what it expects: exit 0 or 1");
    struct Options
    {
        std::string file;
        int threads = 0;
    };
    auto options = std::make_shared<Options>();
    command->add_option("VIEWS", options->file, "JSON with data, camera matrices and expectations")->required();
    addThreadsOption(*command, options->threads);
    command->callback([options, &chosen] {
        chosen = [options] {
            ViewFile file = readViewFile(options->file);
            file.scene.threads = options->threads;
            return verify(std::move(file));
        };
    });
}

} // namespace brickwall
