// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/RigControls.h"

#include "brickwall/channels/FrameRate.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace brickwall {
namespace {

using Event = osgGA::GUIEventAdapter;

constexpr double headStep = 0.05;                    ///< metres per key press
constexpr double headTurn = std::numbers::pi / 36.0; ///< 5 degrees
constexpr double scalePerWheelStep = 1.1;
constexpr double scaleOverWindow = 4.0; ///< of a drag over the window's height
constexpr double turnOverWindow = std::numbers::pi;

constexpr const char* helpText = "left drag: turn the data\n"
                                 "right drag, wheel: scale the data\n"
                                 "middle drag: move the data\n"
                                 "arrows: move the head left, right, forward, back\n"
                                 "page up, down: move the head up, down\n"
                                 "shift + arrows: turn the head\n"
                                 "r: back to the start\n"
                                 "f: full screen\n"
                                 "+, -: frames per second; 0: as many as there are\n"
                                 "t: what they cost, or not\n"
                                 "h: this text\n"
                                 "escape: quit";

/// How movements in a window translate to the room.
struct WindowAxes
{
    vec3d right{1.0, 0.0, 0.0};
    vec3d up{0.0, 0.0, 1.0};
    double metresPerPixelX = 0.0;
    double metresPerPixelY = 0.0;
};

/// Those of the screen of the window's first channel.
WindowAxes axesOf(const Rig& rig, int window)
{
    WindowAxes axes;
    const auto channel = std::find_if(rig.channels.begin(), rig.channels.end(),
                                      [window](const Channel& c) { return c.window == window; });
    if (channel == rig.channels.end())
        return axes;
    const Screen& screen = rig.screens[channel->screen];
    const vec3d right = screen.lowerRight - screen.lowerLeft, up = screen.upperRight - screen.lowerRight;
    axes.right = glm::normalize(right);
    axes.up = glm::normalize(up);
    axes.metresPerPixelX = glm::length(right) / channel->viewport.width;
    axes.metresPerPixelY = glm::length(up) / channel->viewport.height;
    return axes;
}

double upwards(const Event& event)
{
    return event.getMouseYOrientation() == Event::Y_INCREASING_UPWARDS ? event.getY() : -event.getY();
}

} // namespace

bool RigControls::handle(const Event& event, osgGA::GUIActionAdapter&)
{
    rememberWindow(event);
    switch (event.getEventType()) {
    case Event::KEYDOWN:
        return key(event);
    case Event::PUSH:
        remember(event);
        return true;
    case Event::DRAG:
        return drag(event);
    case Event::SCROLL: {
        const bool up = event.getScrollingMotion() == Event::SCROLL_UP;
        navigation_.scaleData(up ? scalePerWheelStep : 1.0 / scalePerWheelStep);
        return true;
    }
    case Event::CLOSE_WINDOW:
        windows_.viewer().setDone(true);
        return true;
    default:
        return false;
    }
}

void RigControls::rememberWindow(const Event& event)
{
    int window = windows_.windowOf(event.getGraphicsContext());
    for (unsigned i = 0; window < 0 && i < event.getNumPointerData(); ++i)
        window = windows_.windowOf(dynamic_cast<const osg::GraphicsContext*>(event.getPointerData(i)->object.get()));
    if (window >= 0)
        window_ = window;
}

void RigControls::remember(const Event& event)
{
    lastX_ = event.getX();
    lastY_ = upwards(event);
}

bool RigControls::drag(const Event& event)
{
    const double dx = event.getX() - lastX_, dy = upwards(event) - lastY_;
    remember(event);
    const WindowAxes axes = axesOf(rig_, window_);
    const double width = rig_.windows[window_].width, height = rig_.windows[window_].height;
    const unsigned buttons = event.getButtonMask();
    if (buttons & Event::LEFT_MOUSE_BUTTON) {
        navigation_.rotateData(axes.up, turnOverWindow * dx / width);
        navigation_.rotateData(axes.right, -turnOverWindow * dy / height);
    } else if (buttons & Event::MIDDLE_MOUSE_BUTTON) {
        navigation_.translateData(axes.right * (dx * axes.metresPerPixelX) + axes.up * (dy * axes.metresPerPixelY));
    } else if (buttons & Event::RIGHT_MOUSE_BUTTON) {
        navigation_.scaleData(std::pow(scaleOverWindow, dy / height));
    }
    return true;
}

void RigControls::showStatus(const std::string& status)
{
    status_ = status;
    showText();
}

void RigControls::showText()
{
    std::string text = statusShown_ ? status_ : "";
    if (helpShown_)
        text += (text.empty() ? "" : "\n\n") + std::string(helpText);
    if (text != shownText_)
        windows_.setText(text);
    shownText_ = text;
}

bool RigControls::setFps(int key)
{
    if (!pace_)
        return false;
    if (key == '0')
        pace_->setFps(pace_->fps() ? std::nullopt : std::optional(usualFps));
    else
        pace_->setFps(pace_->fps().value_or(usualFps) + (key == '-' ? -1.0 : 1.0));
    showStatus(pace_->status());
    return true;
}

bool RigControls::key(const Event& event)
{
    switch (event.getKey()) {
    case 'r':
        navigation_.reset();
        return true;
    case 'h':
        helpShown_ = !helpShown_;
        showText();
        return true;
    case 't':
        statusShown_ = !statusShown_;
        showText();
        return true;
    case '+':
    case '=':
    case '-':
    case '0':
        return setFps(event.getKey());
    case 'f':
        windows_.toggleFullScreen(window_);
        return true;
    default:
        return moveHeadsByKey(navigation_, event.getKey(), event.getModKeyMask() & Event::MODKEY_SHIFT);
    }
}

bool moveHeadsByKey(RigNavigation& navigation, int key, bool shift)
{
    switch (key) {
    case Event::KEY_Left:
        shift ? navigation.turnHeads(headTurn, 0.0) : navigation.moveHeads({-headStep, 0.0, 0.0});
        return true;
    case Event::KEY_Right:
        shift ? navigation.turnHeads(-headTurn, 0.0) : navigation.moveHeads({headStep, 0.0, 0.0});
        return true;
    case Event::KEY_Up:
        shift ? navigation.turnHeads(0.0, headTurn) : navigation.moveHeads({0.0, headStep, 0.0});
        return true;
    case Event::KEY_Down:
        shift ? navigation.turnHeads(0.0, -headTurn) : navigation.moveHeads({0.0, -headStep, 0.0});
        return true;
    case Event::KEY_Page_Up:
        navigation.moveHeads({0.0, 0.0, headStep});
        return true;
    case Event::KEY_Page_Down:
        navigation.moveHeads({0.0, 0.0, -headStep});
        return true;
    default:
        return false;
    }
}

} // namespace brickwall
