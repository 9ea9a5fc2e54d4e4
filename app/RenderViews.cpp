// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "RenderViews.h"

#include "ViewFile.h"

#include "brickwall/channels/RigFiles.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <cmath>
#include <utility>

namespace brickwall {
namespace {

constexpr const char* defaultSize = "1024x1024";

View withSize(const View& view, const PixelSize& size)
{
    View resizedView = view;
    resizedView.screenWidth = size.width;
    resizedView.screenHeight = size.height;
    resizedView.window = {0, 0, size.width, size.height};
    return resizedView;
}

ViewsToRender viewsOf(const Rig& rig, const Box3d& bounds, Progress& progress)
{
    for (const std::string& warning : warningsOf(rig))
        progress.note("warning: " + warning);
    const RigViews rigViews = viewsOfRig(rig, worldFromRoom(rig, bounds.lower, bounds.upper));
    for (const RefusedView& refused : rigViews.refused)
        progress.note(fmt::format("not rendered: {}: {}", refused.name, refused.reason));
    if (rigViews.views.empty())
        throw Error(rig.name, "no channel of this rig can be shown");
    ViewsToRender result;
    result.background = rig.background;
    for (const ChannelView& channelView : rigViews.views) {
        result.views.push_back(channelView.view);
        result.views.back().name = channelView.name;
    }
    return result;
}

} // namespace

void addViewOptions(CLI::App& command, ViewOptions& options, const std::string& aboutSize)
{
    command.add_option("--rig", options.rig,
                       "a display configuration: a file, or desktop, stereo-wall, cave5, tiled-wall");
    command.add_option("--views", options.viewFile, "JSON with camera matrices");
    command.add_option("--size", options.size, aboutSize);
    command.add_option("--camera", options.camera, "ex,ey,ez,ax,ay,az,ux,uy,uz: eye, point looked at, up")
        ->delimiter(',')
        ->expected(9);
    command.add_option("--fov", options.fov, "vertical opening angle for --camera in degrees (default 60)")
        ->check(CLI::Range(0.1, 179.0))
        ->needs("--camera");
}

Rig resized(Rig rig, const PixelSize& size)
{
    for (Channel& channel : rig.channels) {
        if (channel.part.width > 0)
            throw Error("--size",
                        fmt::format("channel \"{}\" shows a part of its screen: its size is the rig's", channel.name));
        // Where a window has several channels, they keep their places in it.
        const double sx = double(size.width) / channel.viewport.width;
        const double sy = double(size.height) / channel.viewport.height;
        const auto scaled = [](int n, double s) { return static_cast<int>(std::lround(n * s)); };
        channel.viewport = {scaled(channel.viewport.x, sx), scaled(channel.viewport.y, sy), size.width, size.height};
    }
    for (std::size_t i = 0; i < rig.windows.size(); ++i) {
        PixelSize around; // a channel with window -1 is in none
        for (const Channel& channel : rig.channels)
            if (channel.window == static_cast<int>(i)) {
                around.width = std::max(around.width, channel.viewport.x + channel.viewport.width);
                around.height = std::max(around.height, channel.viewport.y + channel.viewport.height);
            }
        if (around.width > 0 && around.height > 0) {
            rig.windows[i].width = around.width;
            rig.windows[i].height = around.height;
        }
    }
    return rig;
}

ViewsForBounds readViews(const ViewOptions& options)
{
    const int given = !options.rig.empty() + !options.viewFile.empty() + !options.camera.empty();
    if (given > 1)
        throw Error("--rig, --views, --camera", "only one of them can say what is seen");
    const PixelSize size = parsePixelSize(options.size.empty() ? defaultSize : options.size, "--size");
    if (!options.rig.empty()) {
        Rig rig = loadRig(options.rig);
        if (!options.size.empty())
            rig = resized(std::move(rig), size);
        return [rig](const Box3d& bounds, Progress& progress) { return viewsOf(rig, bounds, progress); };
    }
    if (!options.viewFile.empty()) {
        ViewsToRender result;
        for (const ScriptedView& scripted : readViewFile(options.viewFile).views)
            result.views.push_back(options.size.empty() ? scripted.view : withSize(scripted.view, size));
        return [result](const Box3d&, Progress&) { return result; };
    }
    return [camera = options.camera, fov = options.fov, size](const Box3d& bounds, Progress&) {
        ViewsToRender result;
        result.views.push_back(camera.empty() ? overview(bounds, size) : cameraView(camera, fov, bounds, size));
        return result;
    };
}

} // namespace brickwall
