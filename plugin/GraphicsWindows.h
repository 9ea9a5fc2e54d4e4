// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/Rig.h"
#include "brickwall/plugin/RigLayout.h"

#include <osg/DisplaySettings>
#include <osgViewer/GraphicsWindow>

#include <memory>
#include <vector>

namespace brickwall {

/// A connection to the X display of every window of a rig; throws Error unless all can be opened. Keep them while
/// windows are opened: that makes and closes connections, and an X server that has lost its last client starts anew and
/// refuses or drops whoever connects meanwhile (Xvfb, the server of a CAVE without a window manager).
[[nodiscard]] std::vector<std::shared_ptr<void>> connectDisplays(const Rig& rig);

/// A window with an OpenGL context, not yet realized. Its viewports are left alone when it is resized; its traits tell
/// the current size. Throws Error if the display has no such window, a stereo visual for quad buffers above all.
osg::ref_ptr<osgViewer::GraphicsWindow> openWindow(const Rig& rig, int window, const WindowSize& size, double scale);

/// The name of a window for messages and files.
std::string nameOf(const Rig& rig, int window);

/// For viewers that make their eyes themselves: OSG's own stereo (OSG_STEREO and its like) would split every camera's
/// image once more.
osg::ref_ptr<osg::DisplaySettings> withoutStereo();

} // namespace brickwall
