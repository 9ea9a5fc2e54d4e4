// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/GraphicsWindows.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/plugin/StereoState.h"

#include <osg/Notify>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <X11/Xlib.h>

namespace brickwall {
namespace {

/// OSG writes its own lines about what we report as an Error.
class QuietOsg
{
public:
    QuietOsg() { osg::setNotifyLevel(osg::ALWAYS); }
    ~QuietOsg() { osg::setNotifyLevel(level_); }

private:
    osg::NotifySeverity level_ = osg::getNotifyLevel();
};

/// Instead of OSG's way, which scales every viewport and projection: RigLayout does it, exactly.
struct RecordSize : osg::GraphicsContext::ResizedCallback
{
    osg::ref_ptr<osg::GraphicsContext::Traits> traits;

    void resizedImplementation(osg::GraphicsContext*, int x, int y, int width, int height) override
    {
        traits->x = x;
        traits->y = y;
        traits->width = width;
        traits->height = height;
    }
};

bool anyChannel(const Rig& rig, int window, bool (*holds)(StereoMode))
{
    return std::any_of(rig.channels.begin(), rig.channels.end(),
                       [&](const Channel& channel) { return channel.window == window && holds(channel.stereo); });
}

bool needsQuadBuffer(const Rig& rig, int window)
{
    return rig.windows[window].quadBuffer ||
           anyChannel(rig, window, [](StereoMode mode) { return mode == StereoMode::quadBuffer; });
}

osg::GraphicsContext::ScreenIdentifier screenOf(const Window& window)
{
    osg::GraphicsContext::ScreenIdentifier screen;
    if (window.display.empty())
        screen.readDISPLAY();
    else
        screen.setScreenIdentifier(window.display);
    screen.setUndefinedScreenDetailsToDefaultScreen();
    return screen;
}

osg::ref_ptr<osg::GraphicsContext::Traits> traitsOf(const Rig& rig, int index, const WindowSize& size, double scale)
{
    const Window& window = rig.windows[index];
    osg::ref_ptr<osg::GraphicsContext::Traits> traits = new osg::GraphicsContext::Traits;
    static_cast<osg::GraphicsContext::ScreenIdentifier&>(*traits) = screenOf(window);
    traits->windowName = nameOf(rig, index);
    traits->x = int(std::lround(window.x * scale));
    traits->y = int(std::lround(window.y * scale));
    traits->width = size.width;
    traits->height = size.height;
    traits->windowDecoration = window.decoration;
    traits->supportsResize = true;
    traits->doubleBuffer = true;
    traits->depth = 24;
    traits->stencil = anyChannel(rig, index, isInterlaced) ? 8 : 0;
    traits->quadBufferStereo = needsQuadBuffer(rig, index);
    return traits;
}

} // namespace

std::string nameOf(const Rig& rig, int window)
{
    return rig.windows[window].name.empty() ? fmt::format("window{}", window) : rig.windows[window].name;
}

std::vector<std::shared_ptr<void>> connectDisplays(const Rig& rig)
{
    std::vector<std::shared_ptr<void>> connections;
    for (int i = 0; i < int(rig.windows.size()); ++i) {
        const Window& window = rig.windows[i];
        const char* current = std::getenv("DISPLAY");
        if (window.display.empty() && (!current || !*current))
            throw Error("DISPLAY", "is not set, so no window can be opened; run this in a graphical session, or under "
                                   "xvfb-run, or give the rig's windows a display");
        const std::string name = window.display.empty() ? current : window.display;
        Display* display = XOpenDisplay(name.c_str());
        if (!display)
            throw Error("DISPLAY", fmt::format("cannot open the X display '{}' for window '{}'; is it running, and may "
                                               "this user connect to it (xhost, XAUTHORITY)?",
                                               name, nameOf(rig, i)));
        connections.emplace_back(display, XCloseDisplay);
    }
    return connections;
}

osg::ref_ptr<osgViewer::GraphicsWindow> openWindow(const Rig& rig, int window, const WindowSize& size, double scale)
{
    const QuietOsg quiet;
    const std::string place = fmt::format("window '{}'", nameOf(rig, window));
    const osg::ref_ptr<osg::GraphicsContext::Traits> traits = traitsOf(rig, window, size, scale);
    const osg::ref_ptr<osg::GraphicsContext> context = osg::GraphicsContext::createGraphicsContext(traits);
    osg::ref_ptr<osgViewer::GraphicsWindow> result = dynamic_cast<osgViewer::GraphicsWindow*>(context.get());
    if (!result || !result->valid()) {
        if (needsQuadBuffer(rig, window))
            throw Error(place,
                        "this display has no visual with left and right buffers (QUAD_BUFFER); switch stereo on in "
                        "the graphics driver, or choose another stereo mode, such as HORIZONTAL_SPLIT or ANAGLYPHIC");
        throw Error(place,
                    fmt::format("the display gives no OpenGL window of {} x {} pixels with {} bits of depth and {} of "
                                "stencil; is its GLX extension on?",
                                size.width, size.height, traits->depth, traits->stencil));
    }
    osg::ref_ptr<RecordSize> recordSize = new RecordSize;
    recordSize->traits = traits;
    result->setResizedCallback(recordSize);
    return result;
}

osg::ref_ptr<osg::DisplaySettings> withoutStereo()
{
    osg::ref_ptr<osg::DisplaySettings> settings = new osg::DisplaySettings(*osg::DisplaySettings::instance());
    settings->setStereo(false);
    settings->setNumMultiSamples(0);
    return settings;
}

} // namespace brickwall
