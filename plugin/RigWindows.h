// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/plugin/MultiChannelDrawer.h"
#include "brickwall/plugin/RigChannels.h"
#include "brickwall/plugin/RigLayout.h"
#include "brickwall/plugin/TextOverlay.h"
#include "brickwall/plugin/ViewRendering.h"
#include "brickwall/plugin/WindowCapture.h"

#include <osg/MatrixTransform>
#include <osgViewer/GraphicsWindow>
#include <osgViewer/Viewer>

#include <string>
#include <vector>

namespace brickwall {

/// The open windows of a rig, one osgViewer with a slave camera per channel and eye, and in its scene a
/// MultiChannelDrawer with a view for each of them. What is drawn, and when, is the caller's: everything here belongs
/// to the update phase.
class RigWindows
{
public:
    /// Sizes and `scale` (of the windows' positions) as in RigLayout. Throws Error if a display or window cannot be
    /// had.
    RigWindows(const Rig& rig, const std::vector<WindowSize>& sizes, double scale, bool drawThreads);
    ~RigWindows();

    osgViewer::Viewer& viewer() { return *viewer_; }
    MultiChannelDrawer& drawer() { return *drawer_; }
    const RigChannels& channels() const { return *channels_; }
    /// Geometry in world space that is drawn with the images, hidden by them and hiding them.
    osg::Group& worldScene() { return *worldScene_; }

    /// As they are now, after the user has resized them.
    std::vector<WindowSize> sizes() const;
    int windowOf(const osg::GraphicsContext* context) const;

    /// Cameras and scene for these views; RigChannels::show says how.
    void show(const RigViews& views, const mat4d& roomFromWorld);

    /// The views with the matrices that `show` would draw them with, for the drawer's images.
    std::vector<RequestedView> requestOf(const RigViews& views, const mat4d& roomFromWorld) const;

    /// Text over the upper left corner of every window; empty: none.
    void setText(const std::string& text);
    void toggleFullScreen(int window);

    /// Pictures of all windows as drawn by the next frame of the viewer: ask, draw, take.
    void requestPictures();
    std::vector<WindowCapture::Picture> takePictures();

private:
    struct OpenWindow
    {
        osg::ref_ptr<osgViewer::GraphicsWindow> graphics;
        osg::ref_ptr<osg::Camera> base;    ///< drawn first: clears the window, sets interlace patterns
        osg::ref_ptr<osg::Camera> overlay; ///< drawn last: text, capture
        TextOverlay text;
        osg::ref_ptr<WindowCapture> capture;
        bool fullScreen = false;
        PixelRect normalRect; ///< to return to from full screen; y downwards
    };

    void open(const Rig& rig, int window, const WindowSize& size, double scale);
    void addChannelCameras(const Rig& rig);

    double near_;
    double far_;
    osg::ref_ptr<osgViewer::Viewer> viewer_;
    osg::ref_ptr<RigChannels> channels_;
    osg::ref_ptr<MultiChannelDrawer> drawer_;
    osg::ref_ptr<osg::MatrixTransform> worldScene_;
    std::vector<OpenWindow> windows_;
};

} // namespace brickwall
