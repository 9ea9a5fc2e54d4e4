// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/CoviseXmlHost.h"
#include "brickwall/channels/RigFilesOrientation.h"
#include "brickwall/core/base/Error.h"
#include "brickwall/core/shade/Srgb.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

namespace brickwall {
namespace {

constexpr double metre = 1e-3; // COVISE's unit, the millimetre

std::string indexed(const char* kind, int index)
{
    return fmt::format("{0}Config.{0}:{1}", kind, index);
}

/// A rectangle of a window, and which.
struct Port
{
    int window = 0;
    PixelRect rect;
};

class HostReader
{
public:
    explicit HostReader(const CoviseConfig& coviseConfig) : config(coviseConfig) {}

    Rig read()
    {
        screenCount = config.count("NumScreens", 1);
        channelCount = config.count("NumChannels", screenCount);
        readGeneral();
        for (int i = 0; i < screenCount; ++i)
            readScreen(i);
        for (int i = 0, count = config.count("NumWindows", screenCount); i < count; ++i)
            readWindow(i);
        for (int i = 0; i < channelCount; ++i)
            readChannel(i);
        readViewers();
        noteTheRest();
        rig.notes = config.notes();
        return std::move(rig);
    }

private:
    const CoviseConfig& config;
    Rig rig;
    int screenCount = 0;
    int channelCount = 0;
    int viewerCount = 1;
    std::vector<bool> shown; ///< of each screen

    void readGeneral()
    {
        rig.near = config.number("Near", "value", 10.0) * metre;
        rig.far = config.number("Far", "value", 1e7) * metre;
        rig.sceneSize = config.number("SceneSize", "value", 2000.0) * metre;
        rig.background = {float(linearFromSrgb(config.number("Background", "r", 0.0))),
                          float(linearFromSrgb(config.number("Background", "g", 0.0))),
                          float(linearFromSrgb(config.number("Background", "b", 0.0)))};
    }

    void readScreen(int i)
    {
        const std::string element = indexed("Screen", i);
        if (!config.has(element))
            config.note(fmt::format("screen {} is not described: COVISE's default, 2000 x 1500 mm at the origin", i));
        Screen screen;
        screen.name = lowerCase(config.text(element, "comment"));
        std::replace(screen.name.begin(), screen.name.end(), ' ', '-');
        if (screen.name.empty())
            screen.name = fmt::format("screen-{}", i);
        if (!config.text(element, "frustum").empty()) {
            readFrustum(element, screen);
        } else {
            const double width = config.integer(element, "width", 2000),
                         height = config.integer(element, "height", 1500);
            const vec3d center(config.integer(element, "originX", 0), config.integer(element, "originY", 0),
                               config.integer(element, "originZ", 0));
            const vec3d angles(config.number(element, "h", 0.0), config.number(element, "p", 0.0),
                               config.number(element, "r", 0.0));
            placeScreen(screen, center * metre, width * metre, height * metre, rotationOf(angles));
        }
        shown.push_back(config.flag(element, "render", true));
        rig.screens.push_back(screen);
    }

    /// An eye point, a direction and four angles: where the cone meets the plane at `radius`. COVISE cuts to
    /// millimetres here.
    void readFrustum(const std::string& element, Screen& screen)
    {
        const CoviseValue& frustum = *config.find(element, "frustum");
        const std::vector<std::string> words = splitWords(frustum.text, "; \t");
        std::vector<double> v;
        for (const std::string& word : words)
            if (const std::optional<double> value = parseNumber(word))
                v.push_back(*value);
        if (words.size() != 10 || v.size() != 10)
            throw Error(
                frustum.place,
                fmt::format("{}, attribute frustum: expected cx;cy;cz;h;p;r;left;right;bottom;top, found \"{}\"",
                            element, frustum.text));
        const double radius = config.number(element, "radius", 2800.0);
        const auto reach = [&](double angle) { return std::tan(angle * std::numbers::pi / 180.0) * radius; };
        const double right = reach(v[7]), top = reach(v[9]);
        const double width = std::trunc(right - reach(v[6])), height = std::trunc(top - reach(v[8]));
        const glm::dmat3 rotation = rotationOf(vec3d(v[3], v[4], v[5]));
        const vec3d center =
            vec3d(v[0], v[1], v[2]) + rotation * vec3d(right - width / 2.0, radius, top - height / 2.0);
        placeScreen(screen, glm::trunc(center) * metre, width * metre, height * metre, rotation);
    }

    void readWindow(int i)
    {
        const std::string element = indexed("Window", i);
        if (!config.has(element))
            config.note(fmt::format("window {} is not described: COVISE's default, 1024 x 768", i));
        Window window;
        window.name = lowerCase(config.text(element, "comment", fmt::format("window-{}", i)));
        window.display = displayOf(config.integer(element, "pipeIndex", 0));
        window.x = config.integer(element, "left", 0);
        window.y = config.integer(element, "top", 0);
        window.width = config.integer(element, "width", 1024);
        window.height = config.integer(element, "height", 768);
        window.decoration = config.flag(element, "decoration", true);
        window.quadBuffer = config.flag(element, "stereo", false);
        if (config.flag(element, "pbuffer", false))
            config.note(fmt::format("{}: {} is a pixel buffer for COVISE, a window here",
                                    config.placeOf(element, "pbuffer"), element));
        if (config.integer(element, "swapGroup", -1) > 0 || config.integer(element, "swapBarrier", -1) > 0)
            config.note(fmt::format("{}: {}: swap groups and barriers are not read",
                                    config.placeOf(element, "swapGroup"), element));
        rig.windows.push_back(window);
    }

    /// Empty where the file says nothing about the pipe: COVISE would take :0.0 whatever DISPLAY is.
    std::string displayOf(int pipe)
    {
        const std::string element = indexed("Pipe", pipe);
        if (!config.has(element) || config.flag(element, "useDISPLAY", false))
            return "";
        return fmt::format("{}:{}.{}", config.text(element, "host"), config.integer(element, "server", 0),
                           config.integer(element, "screen", 0));
    }

    void readChannel(int i)
    {
        const std::string element = indexed("Channel", i);
        Channel channel;
        channel.screen = config.integer(element, "screenIndex", i);
        if (channel.screen < 0 || channel.screen >= screenCount)
            throw Error(config.placeOf(element, "screenIndex"),
                        fmt::format("{}, attribute screenIndex: expected one of the {} screens (NumScreens), found {}",
                                    element, screenCount, channel.screen));
        if (!shown[channel.screen]) {
            config.note(fmt::format("{}: {} shows a screen with render=\"off\" and is left out",
                                    config.placeOf(element, ""), element));
            return;
        }
        channel.name = rig.screens[channel.screen].name;
        channel.stereo = stereoOf(element, i);
        channel.fixedViewer = config.flag(element, "fixedViewer", false);
        channel.lateralOffset = config.number(element, "stereoOffset", 0.0) * metre;
        channel.viewer = config.integer(element, "view", 0);
        if (channel.viewer < 0 || channel.viewer > 9)
            throw Error(
                config.placeOf(element, "view"),
                fmt::format("{}, attribute view: expected a head from 0 to 9, found {}", element, channel.viewer));
        const std::optional<Port> port = portOf(element, i);
        if (!port)
            return;
        viewerCount = std::max(viewerCount, channel.viewer + 1);
        channel.window = port->window;
        channel.viewport = port->rect;
        rig.channels.push_back(channel);
    }

    StereoMode stereoOf(const std::string& element, int i)
    {
        std::string words = config.text(element, "stereoMode");
        std::string place = config.placeOf(element, "stereoMode");
        if (words.empty() && screenCount > 1 && rig.screens[0].name == rig.screens[1].name)
            return i % 2 ? StereoMode::right : StereoMode::left;
        if (words.empty()) {
            words = config.text("StereoMode", "value", "LEFT");
            place = config.placeOf("StereoMode", "value");
        }
        const std::optional<StereoMode> mode = stereoModeOf(words);
        if (!mode)
            throw Error(place,
                        fmt::format("{}, stereoMode: \"{}\" is none of COVISE's modes (LEFT, RIGHT, QUAD_BUFFER, "
                                    "HORIZONTAL_SPLIT, VERTICAL_SPLIT, ANAGLYPHIC, HORIZONTAL_INTERLACE, "
                                    "VERTICAL_INTERLACE, CHECKERBOARD, NONE)",
                                    element, words));
        const std::string mono = lowerCase(config.text("MonoView", "value"));
        if (*mode == StereoMode::mono && (mono == "left" || mono == "right"))
            return mono == "left" ? StereoMode::left : StereoMode::right;
        return *mode;
    }

    /// The window's rectangle of channel i. Old files have it in the channel; a channel that goes to a pixel buffer is
    /// shown where the buffer is.
    std::optional<Port> portOf(const std::string& element, int i)
    {
        int viewport = config.integer(element, "viewportIndex", i);
        const int buffer = config.integer(element, "PBOIndex", -1);
        if (buffer >= 0) {
            viewport = viewportOfBuffer(buffer);
            config.note(
                fmt::format("{}: {} renders to pixel buffer {}; it is shown where the buffer is, without warping",
                            config.placeOf(element, "PBOIndex"), element, buffer));
        }
        const int count = config.count("NumViewports", channelCount);
        if (viewport < 0 || viewport >= count) {
            config.note(fmt::format("{}: {} has no viewport ({} of {}) and is left out",
                                    config.placeOf(element, "viewportIndex"), element, viewport, count));
            return std::nullopt;
        }
        const std::string own = indexed("Viewport", viewport), legacy = indexed("Channel", viewport);
        const std::string& source = config.find(own, "windowIndex") ? own : legacy;
        Port port;
        port.window = config.integer(source, "windowIndex", rig.windows.size() == 1 ? 0 : viewport);
        if (port.window < 0 || port.window >= int(rig.windows.size()))
            throw Error(config.placeOf(source, "windowIndex"),
                        fmt::format("{}, attribute windowIndex: expected one of the {} windows (NumWindows), found {}",
                                    source, rig.windows.size(), port.window));
        port.rect = rectOf(source, rig.windows[port.window]);
        for (const char* image : {"distortMesh", "blendingTexture"})
            if (!config.text(source, image).empty())
                config.note(fmt::format("{}: {}: {} is not applied", config.placeOf(source, image), source, image));
        return port;
    }

    int viewportOfBuffer(int buffer)
    {
        for (int i = 0, count = config.count("NumViewports", channelCount); i < count; ++i)
            if (config.integer(indexed("Viewport", i), "PBOIndex", -1) == buffer)
                return i;
        return -1;
    }

    /// Values up to 1 are fractions of the window, larger ones pixels.
    PixelRect rectOf(const std::string& element, const Window& window)
    {
        const auto pixels = [](double value, int size) { return int(std::lround(value > 1.0 ? value : value * size)); };
        const auto value = [&](const char* attribute, double fallback) {
            const double number = config.number(element, attribute, fallback);
            if (std::abs(number) > 1e6)
                throw Error(config.placeOf(element, attribute),
                            fmt::format("{}, attribute {}: {} pixels are too many", element, attribute, number));
            return number;
        };
        PixelRect rect;
        rect.x = pixels(value("left", 0.0), window.width);
        rect.y = pixels(value("bottom", 0.0), window.height);
        rect.width = config.find(element, "right") ? pixels(value("right", 1.0), window.width) - rect.x
                                                   : pixels(value("width", 1.0), window.width);
        rect.height = config.find(element, "top") ? pixels(value("top", 1.0), window.height) - rect.y
                                                  : pixels(value("height", 1.0), window.height);
        return rect;
    }

    double eyeSeparation()
    {
        if (!config.flag("Stereo", "value", true)) {
            config.note(fmt::format("{}: stereo is switched off: both eyes are in the middle",
                                    config.placeOf("Stereo", "value")));
            return 0.0;
        }
        for (const std::string& person : config.elementsWith("Input.Persons.Person:"))
            if (config.find(person, "eyeDistance"))
                return config.number(person, "eyeDistance", 64.0) * metre;
        if (config.text("Stereo", "separation").starts_with("AUTO")) {
            config.note(
                fmt::format("{}: eye separation AUTO is 1000 mm in COVISE", config.placeOf("Stereo", "separation")));
            return 1.0;
        }
        return config.number("Stereo", "separation", 64.0) * metre;
    }

    void readViewers()
    {
        const vec3d position(config.number("ViewerPosition", "x", 0.0), config.number("ViewerPosition", "y", -2000.0),
                             config.number("ViewerPosition", "z", 30.0));
        const double separation = eyeSeparation();
        for (int i = 0; i < viewerCount; ++i) {
            Viewer viewer;
            viewer.name = viewerCount == 1 ? "viewer" : fmt::format("viewer-{}", i);
            viewer.roomFromHead = glm::translate(mat4d(1.0), position * metre);
            viewer.leftEye = {-separation / 2.0, 0.0, 0.0};
            viewer.rightEye = {separation / 2.0, 0.0, 0.0};
            rig.viewers.push_back(viewer);
        }
    }

    void noteTheRest()
    {
        if (config.count("NumBlendingTextures", 0) > 0)
            config.note("blending textures are not applied");
        if (!config.elementsWith("Input.").empty())
            config.note(fmt::format("{}: tracking is not part of a rig; Input is not read except for eyeDistance",
                                    config.placeOf("Input", "")));
        if (config.number("WorldAngle", "value", 0.0) != 0.0)
            config.note(fmt::format("{}: WorldAngle is not read", config.placeOf("WorldAngle", "value")));
        if (config.flag("HMD", "mode", false) || config.flag("HMD", "tracked", false))
            config.note(fmt::format("{}: head-mounted displays are not read", config.placeOf("HMD", "mode")));
        const int described = int(config.elementsWith("ScreenConfig.Screen:").size());
        if (described > screenCount && screenCount > 0)
            config.note(fmt::format("{} screens are described, but NumScreens is {}: the others are not shown",
                                    described, screenCount));
    }
};

} // namespace

Rig rigOfCoviseHost(const CoviseConfig& config)
{
    return HostReader(config).read();
}

} // namespace brickwall
