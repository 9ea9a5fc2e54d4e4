// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Camera.h"

#include "brickwall/channels/Rig.h"
#include "brickwall/core/base/Progress.h"

#include <functional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace brickwall {

/// Where the views of `render` come from; at most one of rig, file and camera is given, none means the overview.
struct ViewOptions
{
    std::string rig;
    std::string viewFile;
    std::string size;           ///< WxH; empty: 1024x1024, or what rig and file say
    std::vector<double> camera; ///< eye, at, up; empty: none
    double fov = 60.0;
};

struct ViewsToRender
{
    std::vector<View> views;
    vec3f background{0.0f}; ///< linear; the rig's
};

/// Adds --rig, --views, --size, --camera and --fov.
void addViewOptions(CLI::App& command, ViewOptions& options, const std::string& aboutSize);

/// The views, once the bounds of the data are known. Refused ones (an eye behind its screen) are noted and left out;
/// throws Error if nothing is left.
using ViewsForBounds = std::function<ViewsToRender(const Box3d& bounds, Progress& progress)>;

/// Reads rig or script, so that what is wrong with them is said before the data are loaded.
ViewsForBounds readViews(const ViewOptions& options);

/// The same rig with viewports, and windows around them, of another size. Throws Error for channels that show parts of
/// a screen: their sizes belong together.
Rig resized(Rig rig, const PixelSize& size);

} // namespace brickwall
