// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/ParaviewPvx.h"
#include "brickwall/channels/RigFilesOrientation.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <sstream>

namespace brickwall {
namespace {

std::string stereoWordOf(StereoMode mode)
{
    switch (mode) {
    case StereoMode::left:
        return "Left";
    case StereoMode::right:
        return "Right";
    case StereoMode::horizontalSplit:
        return "SplitViewportHorizontal";
    case StereoMode::anaglyphic:
        return "Anaglyph";
    case StereoMode::quadBuffer:
        return "Crystal Eyes";
    case StereoMode::horizontalInterlace:
        return "Interlaced";
    case StereoMode::verticalInterlace:
        return "Dresden";
    case StereoMode::checkerboard:
        return "Checkerboard";
    case StereoMode::mono:
    case StereoMode::verticalSplit:
        break;
    }
    return "";
}

/// The room (x, y forward, z up) to pvx (x, y up, z towards the viewer); no "-0" in the file.
std::string cornerText(const vec3d& p)
{
    return fmt::format("{} {} {}", p.x + 0.0, p.z + 0.0, 0.0 - p.y);
}

double separationOf(const Viewer& viewer)
{
    return viewer.rightEye.x - viewer.leftEye.x;
}

void writeMachine(pugi::xml_node& root, const Rig& rig, const Channel& channel)
{
    const Screen screen = screenOfChannel(rig, channel);
    const Window& window = rig.windows[channel.window];
    const PixelRect& port = channel.viewport;
    pugi::xml_node machine = root.append_child("Machine");
    const auto set = [&](const char* name, const std::string& value) {
        machine.append_attribute(name) = value.c_str();
    };
    set("Name", channel.name);
    if (!window.display.empty())
        set("Environment", "DISPLAY=" + window.display);
    set("Geometry", fmt::format("{}x{}{:+}{:+}", port.width, port.height, window.x + port.x,
                                window.y + window.height - port.y - port.height));
    set("ShowBorders", window.decoration ? "1" : "0");
    if (rig.viewers.size() > 1)
        set("ViewerId", std::to_string(channel.viewer));
    if (!stereoWordOf(channel.stereo).empty())
        set("StereoType", stereoWordOf(channel.stereo));
    set("LowerLeft", cornerText(screen.lowerLeft));
    set("LowerRight", cornerText(screen.lowerRight));
    set("UpperRight", cornerText(screen.upperRight));
}

void listLostOfViewers(const Rig& rig, std::vector<std::string>& lost)
{
    for (const Viewer& viewer : rig.viewers) {
        if (viewer.roomFromHead != mat4d(1.0))
            lost.push_back(
                fmt::format("viewer \"{}\": its pose; in ParaView the head comes from the tracker or starts at the "
                            "origin",
                            viewer.name));
        const vec3d half(separationOf(viewer) / 2.0, 0.0, 0.0);
        if (glm::length(viewer.leftEye + half) > 1e-12 || glm::length(viewer.rightEye - half) > 1e-12)
            lost.push_back(
                fmt::format("viewer \"{}\": eye points that are not left and right of the head's origin; only the "
                            "separation is kept",
                            viewer.name));
    }
}

void listLostOfChannels(const Rig& rig, std::vector<std::string>& lost)
{
    std::vector<int> channelsOfWindow(rig.windows.size(), 0);
    for (const Channel& channel : rig.channels) {
        ++channelsOfWindow[channel.window];
        if (channel.stereo == StereoMode::verticalSplit)
            lost.push_back(
                fmt::format("channel \"{}\": stereo mode verticalSplit; it is written without stereo", channel.name));
        if (channel.fixedViewer)
            lost.push_back(fmt::format("channel \"{}\": that its viewer is fixed", channel.name));
        if (channel.lateralOffset != 0.0)
            lost.push_back(
                fmt::format("channel \"{}\": its lateral offset of {} m", channel.name, channel.lateralOffset));
    }
    for (std::size_t i = 0; i < rig.windows.size(); ++i)
        if (channelsOfWindow[i] != 1)
            lost.push_back(
                fmt::format("window \"{}\": one window with {} channels; each channel is written as a window of its "
                            "own",
                            rig.windows[i].name, channelsOfWindow[i]));
}

} // namespace

std::string writePvx(const Rig& rig, std::vector<std::string>& lost)
{
    pugi::xml_document document;
    pugi::xml_node root = document.append_child("pvx");
    if (!rig.viewers.empty())
        root.append_child("EyeSeparation").append_attribute("Value") =
            fmt::format("{}", separationOf(rig.viewers[0])).c_str();
    if (rig.viewers.size() > 1) {
        pugi::xml_node viewers = root.append_child("IndependentViewers");
        for (std::size_t id = 0; id < rig.viewers.size(); ++id) {
            pugi::xml_node viewer = viewers.append_child("Viewer");
            viewer.append_attribute("Id") = int(id);
            viewer.append_attribute("EyeSeparation") = fmt::format("{}", separationOf(rig.viewers[id])).c_str();
        }
    }
    for (const Channel& channel : rig.channels)
        writeMachine(root, rig, channel);
    listLostOfViewers(rig, lost);
    listLostOfChannels(rig, lost);
    lost.push_back("near, far, background and where the scene starts");
    std::ostringstream text;
    document.save(text, "  ", pugi::format_default | pugi::format_indent_attributes);
    return text.str();
}

} // namespace brickwall
