// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/CoviseXml.h"
#include "brickwall/channels/RigFilesOrientation.h"
#include "brickwall/core/shade/Srgb.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <sstream>
#include <utility>

namespace brickwall {
namespace {

class CoviseWriter
{
public:
    CoviseWriter(const Rig& coviseRig, std::vector<std::string>& lostThings) : rig(coviseRig), lost(lostThings) {}

    std::string write()
    {
        pugi::xml_node root = document.append_child("COCONFIG");
        root.append_attribute("version") = "1";
        cover = root.append_child("GLOBAL").append_child("COVER");
        listScreens();
        listPipes();
        setValue("NumScreens", std::to_string(screens.size()));
        setValue("NumWindows", std::to_string(rig.windows.size()));
        setValue("NumChannels", std::to_string(rig.channels.size()));
        setValue("NumViewports", std::to_string(rig.channels.size()));
        setValue("NumPipes", std::to_string(std::max<std::size_t>(pipes.size(), 1)));
        writeGeneral();
        writeViewers();
        writeScreens();
        writePipes();
        writeWindows();
        writeChannels();
        if (std::max({screens.size(), rig.windows.size(), rig.channels.size()}) > 50)
            lost.push_back("COVISE reads no more than 50 screens, windows and channels");
        std::ostringstream text;
        document.save(text, "  ");
        return text.str();
    }

private:
    const Rig& rig;
    std::vector<std::string>& lost;
    pugi::xml_document document;
    pugi::xml_node cover;
    std::vector<Screen> screens;
    std::vector<int> screenOf;      ///< of each channel
    std::vector<std::string> pipes; ///< displays

    static void set(pugi::xml_node element, const char* attribute, const std::string& value)
    {
        element.append_attribute(attribute) = value.c_str();
    }

    void setValue(const char* element, const std::string& value) { set(cover.append_child(element), "value", value); }

    static std::string millimetres(double metres) { return fmt::format("{}", std::round(metres * 1e9) / 1e6 + 0.0); }

    static pugi::xml_node item(pugi::xml_node parent, const char* tag, std::size_t index)
    {
        pugi::xml_node element = parent.append_child(tag);
        set(element, "name", std::to_string(index));
        return element;
    }

    /// Parts of screens become screens.
    void listScreens()
    {
        screens = rig.screens;
        for (const Channel& channel : rig.channels) {
            screenOf.push_back(channel.screen);
            if (channel.part.width == 0)
                continue;
            screenOf.back() = int(screens.size());
            screens.push_back(screenOfChannel(rig, channel));
            lost.push_back(fmt::format(
                "channel \"{}\": that it shows a part of screen \"{}\"; it is written as a screen of its own",
                channel.name, rig.screens[channel.screen].name));
        }
    }

    void listPipes()
    {
        for (const Window& window : rig.windows)
            if (std::find(pipes.begin(), pipes.end(), window.display) == pipes.end())
                pipes.push_back(window.display);
    }

    void writeGeneral()
    {
        setValue("Near", millimetres(rig.near));
        if (std::isfinite(rig.far))
            setValue("Far", millimetres(rig.far));
        else
            lost.push_back("an infinite far plane; COVISE's default of 10 km stays");
        setValue("SceneSize", millimetres(rig.sceneSize));
        pugi::xml_node background = cover.append_child("Background");
        const char* names[] = {"r", "g", "b"};
        for (int i = 0; i < 3; ++i)
            set(background, names[i], fmt::format("{:.6g}", srgbFromLinear(double(rig.background[i]))));
        if (rig.sceneCenter != vec3d(0.0))
            lost.push_back("where the centre of the scene is put; COVISE puts it into the origin");
    }

    void writeViewers()
    {
        if (rig.viewers.empty())
            return;
        const Viewer& first = rig.viewers[0];
        const vec3d position(first.roomFromHead[3]);
        const double separation = first.rightEye.x - first.leftEye.x;
        pugi::xml_node stereo = cover.append_child("Stereo"), place = cover.append_child("ViewerPosition");
        set(stereo, "value", separation == 0.0 ? "OFF" : "ON");
        set(stereo, "separation", millimetres(separation));
        set(place, "x", millimetres(position.x));
        set(place, "y", millimetres(position.y));
        set(place, "z", millimetres(position.z));
        for (const Viewer& viewer : rig.viewers) {
            const vec3d half(separation / 2.0, 0.0, 0.0);
            if (glm::dmat3(viewer.roomFromHead) != glm::dmat3(1.0))
                lost.push_back(
                    fmt::format("viewer \"{}\": where the head looks; only its position is written", viewer.name));
            if (glm::distance(viewer.leftEye, -half) > 1e-12 || glm::distance(viewer.rightEye, half) > 1e-12)
                lost.push_back(fmt::format(
                    "viewer \"{}\": its own eye points; the first viewer's separation is written", viewer.name));
            if (vec3d(viewer.roomFromHead[3]) != position)
                lost.push_back(fmt::format("viewer \"{}\": its position; the first viewer's is written", viewer.name));
        }
    }

    void writeScreens()
    {
        pugi::xml_node parent = cover.append_child("ScreenConfig");
        for (std::size_t i = 0; i < screens.size(); ++i) {
            const Screen& screen = screens[i];
            const vec3d center = glm::round(centerOf(screen) * 1e3) + 0.0;
            const double width = std::round(widthOf(screen) * 1e3), height = std::round(heightOf(screen) * 1e3);
            const glm::dmat3 rotation = rotationOf(screen);
            const vec3d angles = headingPitchRollOf(rotation);
            pugi::xml_node element = item(parent, "Screen", i);
            const std::pair<const char*, double> values[] = {
                {"width", width},      {"height", height}, {"originX", center.x}, {"originY", center.y},
                {"originZ", center.z}, {"h", angles.x},    {"p", angles.y},       {"r", angles.z}};
            set(element, "comment", screen.name);
            for (const auto& [name, value] : values)
                set(element, name, fmt::format("{}", value));
            Screen written;
            placeScreen(written, center * 1e-3, width * 1e-3, height * 1e-3, rotationOf(angles));
            const double error = std::max({glm::distance(written.lowerLeft, screen.lowerLeft),
                                           glm::distance(written.lowerRight, screen.lowerRight),
                                           glm::distance(written.upperRight, screen.upperRight)});
            if (error > 1e-6)
                lost.push_back(
                    fmt::format("screen \"{}\": its corners are written {:.2g} mm off, as a rectangle in whole "
                                "millimetres",
                                screen.name, error * 1e3));
        }
    }

    void writePipes()
    {
        pugi::xml_node parent = cover.append_child("PipeConfig");
        for (std::size_t i = 0; i < pipes.size(); ++i) {
            pugi::xml_node element = item(parent, "Pipe", i);
            const std::size_t colon = pipes[i].rfind(':');
            const std::vector<std::string> numbers =
                colon == pipes[i].npos ? std::vector<std::string>() : splitWords(pipes[i].substr(colon + 1), ".");
            if (numbers.empty()) {
                set(element, "useDISPLAY", "true");
                if (!pipes[i].empty())
                    lost.push_back(fmt::format("display \"{}\", which is no HOST:SERVER.SCREEN", pipes[i]));
                continue;
            }
            set(element, "host", pipes[i].substr(0, colon));
            set(element, "server", numbers[0]);
            set(element, "screen", numbers.size() > 1 ? numbers[1] : "0");
        }
    }

    void writeWindows()
    {
        pugi::xml_node parent = cover.append_child("WindowConfig");
        for (std::size_t i = 0; i < rig.windows.size(); ++i) {
            const Window& window = rig.windows[i];
            pugi::xml_node element = item(parent, "Window", i);
            set(element, "comment", window.name);
            set(element, "pipeIndex",
                std::to_string(std::find(pipes.begin(), pipes.end(), window.display) - pipes.begin()));
            set(element, "left", std::to_string(window.x));
            set(element, "top", std::to_string(window.y));
            set(element, "width", std::to_string(window.width));
            set(element, "height", std::to_string(window.height));
            set(element, "decoration", window.decoration ? "true" : "false");
            set(element, "stereo", window.quadBuffer ? "true" : "false");
        }
    }

    void writeChannels()
    {
        pugi::xml_node ports = cover.append_child("ViewportConfig"), parent = cover.append_child("ChannelConfig");
        for (std::size_t i = 0; i < rig.channels.size(); ++i) {
            const Channel& channel = rig.channels[i];
            writePort(item(ports, "Viewport", i), channel);
            pugi::xml_node element = item(parent, "Channel", i);
            set(element, "comment", channel.name);
            set(element, "stereoMode", coviseWordOf(channel.stereo));
            set(element, "screenIndex", std::to_string(screenOf[i]));
            set(element, "viewportIndex", std::to_string(i));
            set(element, "fixedViewer", channel.fixedViewer ? "true" : "false");
            set(element, "stereoOffset", millimetres(channel.lateralOffset));
            set(element, "view", std::to_string(channel.viewer));
        }
    }

    /// Pixels; but a value of one pixel would be read as the whole window, so it is written as a fraction.
    void writePort(pugi::xml_node element, const Channel& channel)
    {
        const Window& window = rig.windows[channel.window];
        const PixelRect& port = channel.viewport;
        const auto text = [](int pixels, int size) {
            return pixels == 1 ? fmt::format("{:.17g}", 1.0 / size) : std::to_string(pixels);
        };
        set(element, "windowIndex", std::to_string(channel.window));
        set(element, "left", text(port.x, window.width));
        set(element, "bottom", text(port.y, window.height));
        set(element, "width", text(port.width, window.width));
        set(element, "height", text(port.height, window.height));
    }
};

} // namespace

std::string writeCovise(const Rig& rig, std::vector<std::string>& lost)
{
    return CoviseWriter(rig, lost).write();
}

} // namespace brickwall
