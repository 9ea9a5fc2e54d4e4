// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"
#include "brickwall/core/render/View.h"

#include <string>
#include <vector>

namespace brickwall {

/// All spaces here are the room: metres, right-handed, x to the right, y forward into the front screen, z up (COVISE's
/// axes).

enum class Eye { middle, left, right };

/// How the two eyes of a channel share its viewport (the names are COVISE's).
enum class StereoMode {
    mono,
    left, ///< the left eye alone (passive stereo: another channel has the right one)
    right,
    horizontalSplit,     ///< left eye in the left half
    verticalSplit,       ///< left eye in the upper half
    anaglyphic,          ///< left eye red, right eye green and blue
    quadBuffer,          ///< left and right back buffer
    horizontalInterlace, ///< left eye in even rows, counted from the bottom
    verticalInterlace,   ///< left eye in even columns
    checkerboard,        ///< left eye where column + row is even
};

/// A flat rectangle in the room; the upper-left corner is implied.
struct Screen
{
    std::string name;
    vec3d lowerLeft{0.0};
    vec3d lowerRight{0.0};
    vec3d upperRight{0.0};
    /// Pixels of the whole screen, where several channels show parts of it; 0 if every channel shows all of it.
    int pixelWidth = 0;
    int pixelHeight = 0;
};

/// A tracked head: its pose, and two eye points in its own frame (x right, y forward, z up), so that they turn with it.
struct Viewer
{
    std::string name;
    mat4d roomFromHead{1.0};
    vec3d leftEye{-0.032, 0.0, 0.0};
    vec3d rightEye{0.032, 0.0, 0.0};
};

struct Window
{
    std::string name;
    std::string display; ///< X display as in DISPLAY, e.g. ":0.1"; empty: the one the program runs on
    int x = 0;           ///< of the upper-left corner, pixels, y downwards
    int y = 0;
    int width = 0;
    int height = 0;
    bool decoration = true;
    bool quadBuffer = false; ///< the window's visual has left and right buffers
};

/// One viewport: one screen (or a part of it), one viewer, a pixel rectangle of a window.
struct Channel
{
    std::string name;
    int screen = 0;
    int viewer = 0;
    int window = 0;
    PixelRect viewport; ///< of the window, y upwards
    PixelRect part;     ///< of the screen's pixels; width 0: all of the screen
    StereoMode stereo = StereoMode::mono;
    bool fixedViewer = false;   ///< ignores head tracking: the viewer's configured pose stays
    double lateralOffset = 0.0; ///< metres along the head's x, added to the eye (COVISE's stereoOffset)
};

/// A complete installation. Indices refer to the vectors here.
struct Rig
{
    std::string name;
    std::vector<Screen> screens;
    std::vector<Viewer> viewers;
    std::vector<Window> windows;
    std::vector<Channel> channels;
    double near = 0.01;             ///< metres
    double far = 1000.0;            ///< metres
    vec3d sceneCenter{0.0};         ///< where the centre of the data is put at the start
    double sceneSize = 2.0;         ///< how long its longest side is made, metres
    vec3f background{0.0f};         ///< linear RGB
    std::vector<std::string> notes; ///< what a reader ignored, repaired or found strange, one line each
};

/// One image that a rig needs: a channel seen by one eye.
struct ChannelView
{
    std::string name; ///< channel and eye: "front-left"; the channel alone if it is mono
    int channel = 0;
    Eye eye = Eye::middle;
    PixelRect viewport; ///< of the window; for split modes that eye's half
    View view;          ///< world space
};

/// A view that cannot be shown now, and why (an eye on or behind its screen).
struct RefusedView
{
    std::string name;
    std::string reason;
};

struct RigViews
{
    std::vector<ChannelView> views;
    std::vector<RefusedView> refused;
};

/// Every image that the rig needs, in the order of the channels, left before right. `worldFromRoom` is a similarity
/// (rotation, uniform scale, translation); eye points, corners, near and far are carried over by it.
RigViews viewsOfRig(const Rig& rig, const mat4d& worldFromRoom);

/// Where data with these world bounds stand at the start: centred at the rig's sceneCenter, longest side sceneSize,
/// data x to the right, data y up, data z towards the viewer.
mat4d worldFromRoom(const Rig& rig, const vec3d& boundsLower, const vec3d& boundsUpper);

vec3d eyePoint(const Viewer& viewer, Eye eye, double lateralOffset = 0.0);
bool needsTwoEyes(StereoMode mode);
std::string toString(StereoMode mode);
std::string toString(Eye eye);

/// What looks wrong, a line each: screens that are no rectangles, channels without a window, unused screens, windows or
/// viewports that leave their window, eyes behind screens, overlapping viewports.
std::vector<std::string> warningsOf(const Rig& rig);

/// Throws Error naming `place` for indices out of range, empty viewports, screens without an area: what no program
/// could show.
void checkRig(const Rig& rig, const std::string& place);

} // namespace brickwall
