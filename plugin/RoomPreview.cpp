// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/RoomPreview.h"

#include "brickwall/plugin/GraphicsWindows.h"
#include "brickwall/plugin/RigControls.h"
#include "brickwall/plugin/RigLayout.h"

#include <osgGA/TrackballManipulator>

#include <algorithm>
#include <chrono>

namespace brickwall {
namespace {

using namespace std::chrono_literals;
using Event = osgGA::GUIEventAdapter;

constexpr int windowWidth = 1024, windowHeight = 768;
constexpr int largestPicture = 512;
constexpr const char* helpText = "left drag: turn the room\n"
                                 "right drag, wheel: nearer, farther\n"
                                 "middle drag: move the room\n"
                                 "arrows, page up, down: move the head\n"
                                 "shift + arrows: turn the head\n"
                                 "r: head and data as at the start\n"
                                 "space: the room as at the start\n"
                                 "escape: quit";

/// Every channel's viewport, and the screen it is a part of, by one factor.
Rig withSmallPictures(Rig rig)
{
    int largest = 1;
    for (Channel& channel : rig.channels) {
        largest = std::max({largest, channel.viewport.width, channel.viewport.height});
        channel.window = 0; // sizes are all that is used of windows
    }
    const double factor = std::min(1.0, double(largestPicture) / largest);
    Window window;
    window.width = window.height = 1 << 20; // rounds factors to that
    rig.windows = {window};
    return layoutOf(rig, windowSizes(rig, factor));
}

/// From behind and above whoever stands in the room, all screens in sight.
osg::ref_ptr<osgGA::CameraManipulator> walkAround(const Rig& rig)
{
    Box3d room;
    for (const Screen& screen : rig.screens)
        for (const vec3d& corner : {screen.lowerLeft, screen.lowerRight, screen.upperRight})
            room.extend({corner, corner});
    for (const Viewer& viewer : rig.viewers)
        room.extend({vec3d(viewer.roomFromHead[3]), vec3d(viewer.roomFromHead[3])});
    const vec3d center = 0.5 * (room.lower + room.upper);
    const double distance = 1.6 * std::max(glm::length(room.upper - room.lower), 1.0);
    const vec3d eye = center + distance * glm::normalize(vec3d(0.35, -1.0, 0.45));
    osg::ref_ptr<osgGA::TrackballManipulator> manipulator = new osgGA::TrackballManipulator;
    manipulator->setAutoComputeHomePosition(false);
    manipulator->setHomePosition(osg::Vec3d(eye.x, eye.y, eye.z), osg::Vec3d(center.x, center.y, center.z),
                                 osg::Z_AXIS);
    manipulator->setAllowThrow(false); // or it would never come to rest
    return manipulator;
}

} // namespace

/// Keys for the heads; the manipulator has the mouse.
struct RoomPreview::Controls : osgGA::GUIEventHandler
{
    RoomPreview& preview;

    explicit Controls(RoomPreview& p) : preview(p) {}

    using osgGA::GUIEventHandler::handle;
    bool handle(const Event& event, osgGA::GUIActionAdapter&) override
    {
        if (event.getEventType() == Event::RESIZE)
            preview.text_.setWindowHeight(event.getWindowHeight());
        if (event.getEventType() == Event::CLOSE_WINDOW)
            preview.viewer_->setDone(true);
        if (event.getEventType() != Event::KEYDOWN)
            return false;
        if (event.getKey() != 'r')
            return moveHeadsByKey(preview.navigation_, event.getKey(), event.getModKeyMask() & Event::MODKEY_SHIFT);
        preview.navigation_.reset();
        return true;
    }
};

RoomPreview::RoomPreview(const Rig& rig, const Box3d& worldBounds, const FrameMaker& makeFrames, Progress& progress)
    : rig_(withSmallPictures(rig)),
      makeFrames_(makeFrames),
      progress_(progress),
      navigation_(rig, worldBounds),
      posed_(progress),
      room_(rig_),
      viewer_(new osgViewer::Viewer)
{
    openWindow();
}

RoomPreview::~RoomPreview()
{
    rendering_.cancel();
}

void RoomPreview::openWindow()
{
    Rig desktop;
    Window& onDesktop = desktop.windows.emplace_back();
    onDesktop.name = "preview";
    onDesktop.width = windowWidth;
    onDesktop.height = windowHeight;
    const auto connections = connectDisplays(desktop);
    const WindowSize size{windowWidth, windowHeight};
    osg::ref_ptr<osgViewer::GraphicsWindow> window = brickwall::openWindow(desktop, 0, size, 1.0);
    window->setResizedCallback(nullptr); // OSG's own way: the camera follows
    osg::Camera& camera = *viewer_->getCamera();
    camera.setGraphicsContext(window);
    camera.setViewport(0, 0, size.width, size.height);
    camera.setClearColor(osg::Vec4(0.12f, 0.12f, 0.14f, 1));
    camera.setProjectionMatrixAsPerspective(40.0, double(size.width) / size.height, 0.1, 100.0);
    capture_ = new WindowCapture(false);
    camera.setFinalDrawCallback(capture_);
    viewer_->setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
    viewer_->setDisplaySettings(withoutStereo());
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(room_.node());
    scene->addChild(text_.node());
    text_.setText(helpText);
    text_.setWindowHeight(size.height);
    viewer_->setSceneData(scene);
    viewer_->setCameraManipulator(walkAround(rig_));
    viewer_->addEventHandler(new Controls(*this));
    viewer_->realize();
}

bool RoomPreview::followPose()
{
    if (shownStamp_ == navigation_.stamp())
        return false;
    shownStamp_ = navigation_.stamp();
    views_ = posed_.of(rig_, navigation_);
    room_.setPose(views_, navigation_.roomFromWorld(), navigation_.roomFromHeads());
    return true;
}

void RoomPreview::startRendering()
{
    if (pictures_.valid() || renderedStamp_ == shownStamp_)
        return;
    renderedStamp_ = shownStamp_;
    pictures_ = std::async(std::launch::async, [this, views = views_] {
        std::vector<View> asked;
        for (const ChannelView& view : views.views)
            asked.push_back(view.view);
        return Rendered{views, makeFrames_(asked, rendering_)};
    });
}

bool RoomPreview::takePictures()
{
    if (!pictures_.valid() || pictures_.wait_for(0s) != std::future_status::ready)
        return false;
    const Rendered rendered = pictures_.get();
    room_.setPictures(rendered.views, rendered.frames);
    return true;
}

bool RoomPreview::step()
{
    progress_.check();
    const bool moved = followPose(), pictured = takePictures();
    startRendering();
    if (!moved && !pictured && !viewer_->checkNeedToDoFrame())
        return false;
    viewer_->frame();
    return true;
}

void RoomPreview::drawCompleted()
{
    followPose();
    startRendering();
    while (pictures_.valid()) {
        progress_.check();
        pictures_.wait_for(20ms);
        takePictures();
        startRendering();
    }
    viewer_->frame();
}

WindowCapture::Picture RoomPreview::picture()
{
    capture_->request();
    viewer_->frame();
    return capture_->take();
}

} // namespace brickwall
