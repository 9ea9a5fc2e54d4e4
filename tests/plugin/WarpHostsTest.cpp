// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestDisplay.h"
#include "WarpTesting.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/plugin/DrawerShaders.h"
#include "brickwall/plugin/GraphicsWindows.h"
#include "brickwall/plugin/OsgConversions.h"

#include <gtest/gtest.h>

#include <osgUtil/CullVisitor>

/// Which views a channel shows, and hosts with several windows, draw threads, and windows that come and go.
namespace brickwall::test {
namespace {

constexpr int width = 64, height = 48;
const vec3f background = deskRig(1, 1).background;
const vec4f green{0.0f, 1.0f, 0.0f, 1.0f}, blue{0.0f, 0.0f, 1.0f, 1.0f};

/// The left eye in the left half of the window. View 0 is of the left eye and has something on the left, view 1 of the
/// right eye and empty, view 2 for the left eye too, and has something on the right.
struct ThreeViews : WarpedRig
{
    ThreeViews() : WarpedRig(deskRig(2 * width, height, StereoMode::horizontalSplit))
    {
        drawer->setNumViews(3);
        drawer->setViewEye(2, Eye::left);
        Card left = plainCard(2.0, green), right = plainCard(2.0, blue);
        left.upperX = right.lowerX = 0.0;
        const View seen = views.views[0].view;
        drawer->updateMatrices(2, drawer->modelMatrix(0), drawer->viewMatrix(0), drawer->projectionMatrix(0));
        frames.resize(3);
        publish(0, test::frameOf(seen, {left}));
        publish(1, test::frameOf(views.views[1].view, {}));
        publish(2, test::frameOf(seen, {right}));
    }

    /// Whether there is something at the left and right of the left eye's half, and of the right eye's.
    std::array<bool, 4> draws()
    {
        const osg::ref_ptr<osg::Image> picture = drawOne();
        const Rgb nothing = composed(frames[1], 0, 0, background);
        std::array<bool, 4> result;
        for (int i = 0; i < 4; ++i)
            result[i] = pixel(*picture, i * width / 2 + width / 4, height / 2) != nothing;
        return result;
    }
};

TEST(WarpHosts, ViewsToRenderSaysWhichViewsAChannelShows)
{
    BRICKWALL_NEEDS_DISPLAY();
    ThreeViews shown;
    for (const auto& [name, mode] : warpingModes) {
        SCOPED_TRACE(name);
        shown.drawer->setMode(mode);
        shown.drawer->setViewsToRender(MultiChannelDrawer::Same);
        EXPECT_EQ(shown.draws(), (std::array{true, false, false, false}));
        shown.drawer->setViewsToRender(MultiChannelDrawer::MatchingEye);
        EXPECT_EQ(shown.draws(), (std::array{true, true, false, false}));
        shown.drawer->setViewsToRender(MultiChannelDrawer::All);
        EXPECT_EQ(shown.draws(), (std::array{true, true, true, true}));
        shown.drawer->setViewEye(2, Eye::right);
        shown.drawer->setViewsToRender(MultiChannelDrawer::MatchingEye);
        EXPECT_EQ(shown.draws(), (std::array{true, false, false, true}));
        shown.drawer->setViewEye(2, Eye::left);
    }
}

TEST(WarpHosts, AsIsShowsAViewInItsOwnChannelOnly)
{
    BRICKWALL_NEEDS_DISPLAY();
    ThreeViews shown;
    shown.drawer->setMode(MultiChannelDrawer::AsIs);
    for (const auto selection : {MultiChannelDrawer::Same, MultiChannelDrawer::MatchingEye, MultiChannelDrawer::All}) {
        shown.drawer->setViewsToRender(selection);
        EXPECT_EQ(shown.draws(), (std::array{true, false, false, false}));
    }
}

TEST(WarpHosts, ChannelsWithoutAViewShowNothingAndEyesAreThoseOfTheChannels)
{
    BRICKWALL_NEEDS_DISPLAY();
    ThreeViews shown;
    MultiChannelDrawer& drawer = *shown.drawer;
    EXPECT_EQ(drawer.viewEye(0), Eye::left);
    EXPECT_EQ(drawer.viewEye(1), Eye::right);
    drawer.setNumViews(0);
    EXPECT_EQ(shown.draws(), (std::array{false, false, false, false}));
    EXPECT_THROW(drawer.setViewEye(0, Eye::left), Error);
    drawer.setNumViews(3);
    EXPECT_EQ(drawer.viewEye(2), Eye::middle);
    EXPECT_THROW(drawer.viewEye(3), Error);
}

// Of two views that see the same surface, one is blended, in whatever order they come.
TEST(WarpHosts, ViewsOfOneChannelAreNotAddedUp)
{
    BRICKWALL_NEEDS_DISPLAY();
    ThreeViews shown;
    const Card card = plainCard(2.0, vec4f(0.5f));
    const Frame frame = frameOf(shown.views.views[0].view, {card});
    shown.publish(0, frame);
    shown.publish(2, frame);
    shown.drawer->setViewsToRender(MultiChannelDrawer::MatchingEye);
    for (const auto& [name, mode] : warpingModes) {
        SCOPED_TRACE(name);
        shown.drawer->setMode(mode);
        expectPicture(*shown.drawOne(), {0, 0, width, height},
                      [&](int x, int y) { return composed(frame, x, y, background); });
    }
}

TEST(WarpHosts, EveryThreadingModelOfOsgViewerShowsEveryWindowRight)
{
    BRICKWALL_NEEDS_DISPLAY();
    using Viewer = osgViewer::ViewerBase;
    for (const auto model : {Viewer::SingleThreaded, Viewer::CullDrawThreadPerContext, Viewer::DrawThreadPerContext,
                             Viewer::CullThreadPerCameraDrawThreadPerContext}) {
        WarpedRig corner(cornerRig(width, height));
        corner.windows.viewer().setThreadingModel(model);
        corner.drawer->setViewsToRender(MultiChannelDrawer::All);
        for (int round = 0; round < 10; ++round) {
            SCOPED_TRACE("threading model " + std::to_string(model) + ", round " + std::to_string(round));
            corner.drawer->setMode(warpingModes[round % warpingModes.size()].mode);
            corner.move({0.01 * round, 0.0, 0.0});
            corner.render({gradientCard(2.0 + round)});
            const auto pictures = corner.draw();
            for (int i = 0; i < 2; ++i)
                expectPicture(*pictures[i].left, {1, 1, width - 2, height - 2},
                              [&](int x, int y) { return composed(corner.frames[i], x + 1, y + 1, background); });
        }
    }
}

/// An image of so many times fewer columns and rows than the window has.
void publishReduced(WarpedRig& desk, int factor)
{
    View view = desk.views.views[0].view;
    view.window = {0, 0, width / factor, height / factor};
    desk.publish(0, patternFrame(view, factor));
}

void expectReduced(WarpedRig& desk, int factor)
{
    expectPicture(*desk.drawOne(), {0, 0, width, height},
                  [&](int x, int y) { return composed(desk.frames[0], x / factor, y / factor, background); });
}

TEST(WarpHosts, AViewThatChangesItsSizeIsShownRight)
{
    BRICKWALL_NEEDS_DISPLAY();
    WarpedRig desk(deskRig(width, height));
    desk.drawer->setViewsToRender(MultiChannelDrawer::MatchingEye);
    for (const int factor : {2, 1, 4, 1}) {
        publishReduced(desk, factor);
        for (const auto& [name, mode] : warpingModes) {
            SCOPED_TRACE(std::string(name) + " " + std::to_string(factor));
            if (isMesh(mode) && factor > 1)
                continue; // it is smooth between pixels
            desk.drawer->setMode(mode);
            expectReduced(desk, factor);
        }
    }
}

// OpenSceneGraph takes an array for the one drawn last if it is at the same address and was modified as often. The
// vertices of the first size leave their place in memory to those of the third: then those of the first were drawn
// again, outside the window, and nothing was seen.
TEST(WarpHosts, AViewThatChangesItsSizeTwiceBetweenDrawsIsShownRight)
{
    BRICKWALL_NEEDS_DISPLAY();
    WarpedRig desk(deskRig(width, height));
    desk.drawer->setViewsToRender(MultiChannelDrawer::MatchingEye);
    desk.drawer->setMode(MultiChannelDrawer::Reproject);
    for (int round = 0; round < 20; ++round) {
        SCOPED_TRACE(round);
        publishReduced(desk, 1);
        desk.drawOne();
        publishReduced(desk, 2);
        publishReduced(desk, 4);
        expectReduced(desk, 4);
    }
}

/// A host with a single camera, which it may exchange.
struct OneCamera : ChannelSource
{
    osg::ref_ptr<osg::Camera> camera;

    int numChannels() const override { return 1; }
    OutputChannel channel(int) const override
    {
        OutputChannel result;
        if (camera) {
            result.view = camera->getViewMatrix();
            result.projection = camera->getProjectionMatrix();
        }
        return result;
    }
    bool isDrawnBy(int, osgUtil::CullVisitor& visitor) const override { return visitor.getCurrentCamera() == camera; }
};

TEST(WarpHosts, WindowsMayBeClosedAndOpenedAgain)
{
    BRICKWALL_NEEDS_DISPLAY();
    const Rig rig = deskRig(width, height);
    const View seen = viewsOfRig(rig, mat4d(1.0)).views[0].view;
    const Frame frame = patternFrame(seen, 0);
    const auto connections = connectDisplays(rig);
    const osg::ref_ptr<OneCamera> host = new OneCamera;
    const osg::ref_ptr<MultiChannelDrawer> drawer = new MultiChannelDrawer(host);
    drawer->setViewsToRender(MultiChannelDrawer::MatchingEye); // a view alone would be drawn as is
    for (int round = 0; round < 4; ++round) {
        SCOPED_TRACE(round);
        osgViewer::Viewer viewer;
        viewer.setThreadingModel(osgViewer::ViewerBase::SingleThreaded);
        host->camera = viewer.getCamera();
        host->camera->setGraphicsContext(openWindow(rig, 0, {width, height}, 1.0));
        host->camera->setViewport(0, 0, width, height);
        host->camera->setViewMatrix(
            toOsg(modelviewOfScreen(seen.eye, seen.lowerLeft, seen.lowerRight, seen.upperRight)));
        host->camera->setProjectionMatrix(
            toOsg(projectionOfScreen(seen.eye, seen.lowerLeft, seen.lowerRight, seen.upperRight, rig.near, rig.far)));
        host->camera->setClearColor(osg::Vec4(0, 0, 0, 1));
        const osg::ref_ptr<WindowCapture> capture = new WindowCapture(false);
        host->camera->setFinalDrawCallback(capture);
        viewer.setSceneData(drawer);
        viewer.realize();
        drawer->setBackground(vec3f(0.0f));
        drawer->update();
        if (round != 1) { // also a window that opens on images that were published for another one
            drawer->resizeView(0, width, height);
            std::copy(frame.color.begin(), frame.color.end(), drawer->rgba(0));
            std::copy(frame.depth.begin(), frame.depth.end(), drawer->depth(0));
            drawer->updateMatrices(0, drawer->modelMatrix(0), drawer->viewMatrix(0), drawer->projectionMatrix(0));
            drawer->swapFrame();
        }
        for (const auto& [name, mode] : warpingModes) {
            SCOPED_TRACE(name);
            drawer->setMode(mode);
            capture->request();
            viewer.frame();
            expectPicture(*capture->take().left, {0, 0, width, height},
                          [&](int x, int y) { return composed(frame, x, y, vec3f(0.0f)); });
        }
        host->camera = nullptr;
    }
}

} // namespace
} // namespace brickwall::test
