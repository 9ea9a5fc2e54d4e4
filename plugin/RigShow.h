// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/plugin/FramePace.h"
#include "brickwall/plugin/PosedViews.h"
#include "brickwall/plugin/RigControls.h"
#include "brickwall/plugin/RigWindows.h"
#include "brickwall/plugin/ViewRendering.h"

#include <chrono>
#include <optional>
#include <vector>

namespace brickwall {

/// Data shown in the windows of a rig, moved by the user: what runRigViewer repeats. Every frame that is drawn shows
/// the newest pose of heads and data: with the frames rendered for it as soon as they are there, until then with the
/// last ones, reprojected (MultiChannelDrawer). All functions belong to the thread that draws.
class RigShow
{
public:
    /// The rig, the maker and the progress have to outlive this. Throws Error if a display or window cannot be had.
    RigShow(const Rig& rig, const Box3d& worldBounds, const FrameMaker& makeFrames, double windowScale,
            bool drawThreads, Progress& progress);
    /// The same with a frame rate that is held: what moves is rendered as the pace says, what rests is refined, step by
    /// step, and the windows say what that costs. A movement breaks a refinement off.
    RigShow(const Rig& rig, const Box3d& worldBounds, FramePace& pace, double windowScale, bool drawThreads,
            Progress& progress);

    /// Draws one frame if there is something new to be seen, and asks for new frames if something has changed. Says
    /// whether it has drawn. Throws what the maker has thrown, and Cancelled.
    bool step();

    /// Draws one frame, after the rendering of what it shows has been completed, as accurate as the user wants it.
    void drawCompleted();

    /// Until frames are there to be drawn, or the time is over.
    void wait(std::chrono::milliseconds time) const;

    /// Draws one frame and returns what the windows show.
    std::vector<WindowCapture::Picture> pictures();

    bool done() { return windows_.viewer().done(); }
    RigNavigation& navigation() { return navigation_; }

private:
    RigShow(const Rig& rig, const Box3d& worldBounds, const FrameMaker& moving, const FrameMaker& finished,
            FramePace* pace, double windowScale, bool drawThreads, Progress& progress);
    bool followPose(const FrameMaker& makeFrames);
    void refine();

    const Rig& rig_;
    const FrameMaker moving_;
    const FrameMaker finished_;
    FramePace* pace_; ///< null: nothing is held
    Progress& progress_;
    RigNavigation navigation_;
    RigWindows windows_;
    Rig layout_;
    std::optional<unsigned> shownStamp_; ///< of the navigation
    std::vector<WindowSize> shownSizes_;
    PosedViews views_;
    osg::ref_ptr<RigControls> controls_;
    std::vector<RequestedView> requested_; ///< last
    unsigned request_ = 0;                 ///< its number
    bool finishing_ = false;               ///< it is as accurate as the user wants it
    ViewRendering rendering_;              ///< last: it ends before what it writes to does
};

} // namespace brickwall
