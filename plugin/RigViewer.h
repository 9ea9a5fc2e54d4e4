// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/Rig.h"
#include "brickwall/core/base/Box.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/base/Vec.h"
#include "brickwall/core/render/Renderer.h"
#include "brickwall/plugin/FramePace.h"
#include "brickwall/plugin/ViewRendering.h"

#include <functional>
#include <optional>
#include <string>

namespace brickwall {

struct ViewerOptions
{
    /// Draw this many frames, each with its rendering completed, then return; 0: until the user quits. After the
    /// flight, if there is one.
    int frames = 0;
    /// Where a picture of every window, as it is after the last of `frames`, is put: WINDOW.png, and WINDOW-right.png
    /// for the right buffer of quad-buffered ones. The folder is made. Empty: no pictures.
    std::string screenshotFolder;
    double windowScale = 1.0; ///< of the windows' sizes and positions
    bool drawThreads = false; ///< a draw thread per window, for several graphics cards; otherwise all is drawn by one
    int renderThreads = 0;    ///< 0: one per core
    /// Of viewScene: frames per second that are held while something moves, by rendering less accurately (FramePace), 5
    /// to 60; what rests is refined. None: every frame is rendered as the settings say.
    std::optional<double> fps;
    /// Of viewScene: where the data are placed (roomFromWorld) so many seconds after the start, until it says nothing
    /// more; then they rest there. None: only the user moves them.
    std::function<std::optional<mat4d>(double seconds)> flight;
    bool preview = false; ///< one window that shows the whole room from outside (RoomPreview), named "preview"
};

/// Opens the windows of the rig and shows the data in them until the user quits; docs/viewer.md has the controls. All
/// views are rendered beside drawing and event handling, again whenever data, heads or window sizes have changed; what
/// is drawn is always a set of frames of one moment, seen from where the heads are by now (reprojected until there are
/// frames for that). A view that cannot be shown (an eye behind its screen) stays black, which is noted once on
/// `progress`.
///
/// A window that is resized keeps the rig's proportions, the rest stays black. Throws Error if a display or window
/// cannot be had (place "DISPLAY" or the window), what `makeFrames` throws, and Cancelled. Uses the calling thread for
/// the windows.
void runRigViewer(const Rig& rig, const Box3d& worldBounds, const FrameMaker& makeFrames, const ViewerOptions& options,
                  Progress& progress);

/// The same for a scene and the Renderer.
void viewScene(const Scene& scene, const Rig& rig, const RenderSettings& settings, const ViewerOptions& options,
               Progress& progress);

/// The box around the scene's cells, world space. Throws Error for a scene without bricks.
Box3d worldBounds(const Scene& scene);

} // namespace brickwall
