// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/RigWindows.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/plugin/GraphicsWindows.h"
#include "brickwall/plugin/OsgConversions.h"
#include "brickwall/plugin/StereoState.h"

#include <algorithm>

namespace brickwall {
namespace {

constexpr int overlayOrder = 1000000;

osg::ref_ptr<osg::Camera> makeWindowCamera(osgViewer::GraphicsWindow* window, int order, GLbitfield clearMask)
{
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setGraphicsContext(window);
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    camera->setProjectionResizePolicy(osg::Camera::FIXED);
    camera->setRenderOrder(osg::Camera::POST_RENDER, order);
    camera->setAllowEventFocus(false);
    camera->setClearMask(clearMask);
    camera->setClearColor(osg::Vec4(0, 0, 0, 1));
    restrictToEye(*camera, StereoMode::mono, Eye::middle);
    return camera;
}

} // namespace

RigWindows::RigWindows(const Rig& rig, const std::vector<WindowSize>& sizes, double scale, bool drawThreads)
    : near_(rig.near),
      far_(rig.far),
      viewer_(new osgViewer::Viewer),
      channels_(new RigChannels(rig)),
      drawer_(new MultiChannelDrawer(channels_)),
      worldScene_(new osg::MatrixTransform)
{
    const auto connections = connectDisplays(rig);
    drawer_->setBackground(rig.background);
    osg::ref_ptr<osg::Group> room = new osg::Group;
    room->getOrCreateStateSet()->setMode(GL_NORMALIZE, osg::StateAttribute::ON);
    room->addChild(worldScene_);
    room->addChild(drawer_);

    viewer_->setThreadingModel(drawThreads ? osgViewer::ViewerBase::DrawThreadPerContext
                                           : osgViewer::ViewerBase::SingleThreaded);
    viewer_->setDisplaySettings(withoutStereo());
    viewer_->setSceneData(room);
    for (int i = 0; i < int(rig.windows.size()); ++i)
        open(rig, i, sizes[i], scale);
    addChannelCameras(rig);
    viewer_->realize();
}

RigWindows::~RigWindows()
{
    viewer_->stopThreading();
}

void RigWindows::open(const Rig& rig, int window, const WindowSize& size, double scale)
{
    OpenWindow result;
    result.graphics = openWindow(rig, window, size, scale);
    result.base =
        makeWindowCamera(result.graphics, 0, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT | GL_STENCIL_BUFFER_BIT);
    if (result.graphics->getTraits()->stencil > 0)
        result.base->addChild(makeInterlacePatterns());
    result.overlay = makeWindowCamera(result.graphics, overlayOrder, 0);
    result.overlay->addChild(result.text.node());
    result.capture = new WindowCapture(result.graphics->getTraits()->quadBufferStereo);
    result.overlay->setFinalDrawCallback(result.capture);
    viewer_->addSlave(result.base, false);
    viewer_->addSlave(result.overlay, false);
    windows_.push_back(result);
}

void RigWindows::addChannelCameras(const Rig& rig)
{
    for (int i = 0; i < channels_->numChannels(); ++i) {
        osg::Camera& camera = channels_->camera(i);
        camera.setGraphicsContext(windows_[rig.channels[channels_->rigChannel(i)].window].graphics);
        camera.setRenderOrder(osg::Camera::POST_RENDER, i + 1);
        viewer_->addSlave(&camera, true);
    }
}

std::vector<WindowSize> RigWindows::sizes() const
{
    std::vector<WindowSize> sizes;
    for (const OpenWindow& window : windows_)
        sizes.push_back({window.graphics->getTraits()->width, window.graphics->getTraits()->height});
    return sizes;
}

int RigWindows::windowOf(const osg::GraphicsContext* context) const
{
    const auto found = std::find_if(windows_.begin(), windows_.end(),
                                    [&](const OpenWindow& window) { return window.graphics.get() == context; });
    return found == windows_.end() ? -1 : int(found - windows_.begin());
}

void RigWindows::show(const RigViews& views, const mat4d& roomFromWorld)
{
    for (OpenWindow& window : windows_) {
        const osg::GraphicsContext::Traits& traits = *window.graphics->getTraits();
        window.base->setViewport(0, 0, traits.width, traits.height);
        window.overlay->setViewport(0, 0, traits.width, traits.height);
        window.text.setWindowHeight(traits.height);
    }
    worldScene_->setMatrix(toOsg(roomFromWorld));
    channels_->show(views, roomFromWorld, near_, far_);
    drawer_->update();
}

std::vector<RequestedView> RigWindows::requestOf(const RigViews& views, const mat4d& roomFromWorld) const
{
    std::vector<RequestedView> request;
    for (const ChannelView& view : views.views) {
        const OutputChannel output = RigChannels::outputOf(view, roomFromWorld, near_, far_);
        request.push_back(
            {channels_->indexOf(view.channel, view.eye), view.view, output.model, output.view, output.projection});
    }
    return request;
}

void RigWindows::setText(const std::string& text)
{
    for (OpenWindow& window : windows_)
        window.text.setText(text);
}

void RigWindows::toggleFullScreen(int index)
{
    OpenWindow& window = windows_.at(index);
    const osg::GraphicsContext::Traits& traits = *window.graphics->getTraits();
    PixelRect target = window.normalRect;
    if (!window.fullScreen) {
        window.normalRect = {traits.x, traits.y, traits.width, traits.height};
        unsigned width = 0, height = 0;
        osg::GraphicsContext::getWindowingSystemInterface()->getScreenResolution(traits, width, height);
        target = {0, 0, int(width), int(height)};
    }
    window.fullScreen = !window.fullScreen;
    window.graphics->setWindowDecoration(!window.fullScreen);
    window.graphics->setWindowRectangle(target.x, target.y, target.width, target.height);
}

void RigWindows::requestPictures()
{
    for (OpenWindow& window : windows_)
        window.capture->request();
}

std::vector<WindowCapture::Picture> RigWindows::takePictures()
{
    std::vector<WindowCapture::Picture> pictures;
    for (OpenWindow& window : windows_)
        pictures.push_back(window.capture->take());
    return pictures;
}

} // namespace brickwall
