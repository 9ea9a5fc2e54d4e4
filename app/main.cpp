// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Commands.h"

#include "brickwall/core/base/Error.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cstdio>
#include <new>

namespace {

constexpr int exitBadInput = 2;
constexpr int exitCancelled = 130; // 128 + SIGINT, as shells report it

int run(int argc, char** argv)
{
    CLI::App app("Renders adaptive-mesh-refinement data as volumes on the walls of a CAVE, a stereo wall or a desktop.",
                 "brickwall");
    app.set_version_flag("--version", BRICKWALL_VERSION);
    app.require_subcommand(1);
    app.failure_message([](const CLI::App*, const CLI::Error& error) {
        return fmt::format("brickwall: {} (--help shows the usage)\n", error.what());
    });
    app.footer("DATA is a file, a folder, or sample:NAME[:SIZE] (wake, cloud, impact; for example sample:cloud:20M).");

    brickwall::Action chosen;
    brickwall::addInfoCommand(app, chosen);
    brickwall::addRenderCommand(app, chosen);
    brickwall::addViewCommand(app, chosen);
    brickwall::addConvertCommand(app, chosen);
    brickwall::addSampleCommand(app, chosen);
    brickwall::addRigCommand(app, chosen);
    brickwall::addChartCommand(app, chosen);
    brickwall::addFlightCommand(app, chosen);
    brickwall::addVerifyCommand(app, chosen);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& error) {
        return app.exit(error) == 0 ? 0 : exitBadInput;
    }
    const int exitCode = chosen();
    if (std::fflush(stdout) != 0 || std::ferror(stdout)) // a full disk behind '>'
        throw brickwall::Error("standard output", "cannot be written: the results are incomplete");
    return exitCode;
}

} // namespace

int main(int argc, char** argv)
{
    try {
        return run(argc, argv);
    } catch (const brickwall::Cancelled&) {
        fmt::print(stderr, "brickwall: stopped\n");
        return exitCancelled;
    } catch (const std::bad_alloc&) {
        fmt::print(stderr, "brickwall: out of memory\n");
        return exitBadInput;
    } catch (const brickwall::TextError& error) {
        fmt::print(stderr, "brickwall: {}\n{}\n", error.what(), error.excerpt());
        return exitBadInput;
    } catch (const std::exception& error) {
        fmt::print(stderr, "brickwall: {}\n", error.what());
        return exitBadInput;
    }
}
