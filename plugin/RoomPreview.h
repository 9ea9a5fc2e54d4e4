// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/plugin/PosedViews.h"
#include "brickwall/plugin/RigNavigation.h"
#include "brickwall/plugin/RoomModel.h"
#include "brickwall/plugin/TextOverlay.h"
#include "brickwall/plugin/ViewRendering.h"
#include "brickwall/plugin/WindowCapture.h"

#include <osgGA/GUIEventHandler>
#include <osgViewer/Viewer>

#include <future>
#include <optional>

namespace brickwall {

/// A window on the desktop in which a rig is seen from outside, with what its screens show (RoomModel): the mouse moves
/// whoever looks, the keyboard the heads. Meant for checking a configuration where its displays are not, so it needs
/// none of them, and shows channels without a window as well. All functions belong to the thread that draws.
class RoomPreview
{
public:
    /// Pictures on screens have at most 512 pixels a side. The maker and the progress have to outlive this. Throws
    /// Error if no window can be had.
    RoomPreview(const Rig& rig, const Box3d& worldBounds, const FrameMaker& makeFrames, Progress& progress);
    ~RoomPreview();

    /// Draws one frame if there is something new to be seen; says whether it has. Throws what the maker has thrown, and
    /// Cancelled.
    bool step();
    /// Draws one frame, after the rendering of what it shows has been completed.
    void drawCompleted();
    WindowCapture::Picture picture();

    bool done() { return viewer_->done(); }
    RigNavigation& navigation() { return navigation_; }

private:
    struct Controls;
    struct Rendered
    {
        RigViews views;
        std::vector<Frame> frames;
    };

    void openWindow();
    bool followPose();
    bool takePictures();
    void startRendering();

    Rig rig_; ///< with smaller pictures
    const FrameMaker& makeFrames_;
    Progress& progress_;
    RigNavigation navigation_;
    PosedViews posed_;
    RoomModel room_;
    osg::ref_ptr<osgViewer::Viewer> viewer_;
    osg::ref_ptr<WindowCapture> capture_;
    TextOverlay text_;
    std::optional<unsigned> shownStamp_;    ///< of the navigation
    std::optional<unsigned> renderedStamp_; ///< that pictures were last asked for
    RigViews views_;                        ///< of the pose shown
    Progress rendering_;
    std::future<Rendered> pictures_; ///< last: it ends before what it uses does
};

} // namespace brickwall
