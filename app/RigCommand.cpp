// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "Commands.h"

#include "brickwall/channels/RigFiles.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <map>
#include <memory>

namespace brickwall {
namespace {

std::string point(const vec3d& p)
{
    return fmt::format("({:.4g} {:.4g} {:.4g})", p.x, p.y, p.z);
}

void print(const Rig& rig)
{
    fmt::print("rig {}: {} screens, {} viewers, {} windows, {} channels (metres; x right, y forward, z up)\n", rig.name,
               rig.screens.size(), rig.viewers.size(), rig.windows.size(), rig.channels.size());
    for (const Screen& s : rig.screens)
        fmt::print("screen  {:<12} {:.4g} x {:.4g}, lower left {}, lower right {}, upper right {}\n", s.name,
                   glm::length(s.lowerRight - s.lowerLeft), glm::length(s.upperRight - s.lowerRight),
                   point(s.lowerLeft), point(s.lowerRight), point(s.upperRight));
    for (const Viewer& v : rig.viewers)
        fmt::print("viewer  {:<12} left eye {}, right eye {}, {:.4g} apart\n", v.name, point(eyePoint(v, Eye::left)),
                   point(eyePoint(v, Eye::right)), glm::length(v.rightEye - v.leftEye));
    for (const Window& w : rig.windows)
        fmt::print("window  {:<12} {}x{}+{}+{}{}{}\n", w.name, w.width, w.height, w.x, w.y,
                   w.display.empty() ? "" : " on " + w.display, w.quadBuffer ? ", quad-buffered" : "");
    for (const Channel& c : rig.channels)
        fmt::print("channel {:<12} screen {}, viewer {}, window {}, viewport {}x{}+{}+{}, {}\n", c.name,
                   rig.screens[static_cast<std::size_t>(c.screen)].name,
                   rig.viewers[static_cast<std::size_t>(c.viewer)].name,
                   c.window < 0 ? "none" : rig.windows[static_cast<std::size_t>(c.window)].name, c.viewport.width,
                   c.viewport.height, c.viewport.x, c.viewport.y, toString(c.stereo));
    fmt::print("near {:g}, far {:g}, scene of {:g} at {}\n", rig.near, rig.far, rig.sceneSize, point(rig.sceneCenter));
    for (const std::string& note : rig.notes)
        fmt::print("note    {}\n", note);
}

void warn(const std::vector<std::string>& lines)
{
    for (const std::string& line : lines)
        fmt::print(stderr, "warning: {}\n", line);
}

RigFormat formatNamed(const std::string& name)
{
    static const std::map<std::string, RigFormat> formats = {
        {"toml", RigFormat::toml}, {"json", RigFormat::json}, {"covise", RigFormat::covise}, {"pvx", RigFormat::pvx}};
    return formats.at(name);
}

} // namespace

void addRigCommand(CLI::App& app, Action& chosen)
{
    CLI::App* command = app.add_subcommand("rig", "check a display configuration, say what it describes, convert it");
    struct Options
    {
        std::string rig;
        RigScope scope;
        std::string format;
    };
    auto options = std::make_shared<Options>();
    command
        ->add_option(
            "RIG", options->rig,
            fmt::format("a file (TOML, JSON, COVISE XML, ParaView .pvx) or one of: {}", fmt::join(builtInRigs(), ", ")))
        ->required();
    command->add_option("--to", options->format, "toml, json, covise or pvx: written to standard output")
        ->check(CLI::IsMember({"toml", "json", "covise", "pvx"}));
    command->add_option("--host", options->scope.host, "what this host of a cluster shows (COVISE's LOCAL HOST)");
    command->add_option("--master", options->scope.master, "the cluster's master (COVISE's CLUSTER MASTER)");
    command->add_option("--rank", options->scope.rank, "the rank in the cluster (COVISE's RANK)");
    command->callback([options, &chosen] {
        chosen = [options] {
            const Rig rig = loadRig(options->rig, options->scope);
            if (!options->format.empty()) {
                std::vector<std::string> lost;
                fmt::print("{}", writeRig(rig, formatNamed(options->format), lost));
                warn(lost);
            } else {
                print(rig);
            }
            warn(warningsOf(rig));
            return 0;
        };
    });
}

} // namespace brickwall
