// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestDisplay.h"
#include "TestRigs.h"
#include "WarpTesting.h"

#include "brickwall/core/base/Error.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace brickwall::test {
namespace {

constexpr PixelRect whole{0, 0, 64, 48};
const vec3f background = deskRig(1, 1).background;

struct DrawnDesk : ShownRig
{
    DrawnDesk() : ShownRig(deskRig(64, 48)) {}

    void show(const Frame& frame)
    {
        frames[0] = frame;
        write(views.views[0], frame);
        windows.drawer().swapFrame();
    }
    Frame flatFrame(const vec4f& color, float depth) const
    {
        Frame frame = frames[0];
        std::fill(frame.color.begin(), frame.color.end(), color);
        std::fill(frame.depth.begin(), frame.depth.end(), depth);
        return frame;
    }
};

TEST(Drawer, ShowsAFrameAsItsPictureFileUprightOverTheBackground)
{
    BRICKWALL_NEEDS_DISPLAY();
    DrawnDesk desk;
    expectPicture(*desk.drawOne(), whole, [&](int x, int y) { return composed(desk.frames[0], x, y, background); });
}

TEST(Drawer, WorksWithADrawThreadPerWindow)
{
    BRICKWALL_NEEDS_DISPLAY();
    ShownRig corner(cornerRig(64, 48), true);
    for (int round = 0; round < 3; ++round) {
        const auto pictures = corner.draw();
        for (int i = 0; i < 2; ++i)
            expectPicture(*pictures[i].left, whole,
                          [&](int x, int y) { return composed(corner.frames[i], x, y, background); });
        for (int i = 0; i < 2; ++i) {
            corner.frames[i] = patternFrame(corner.views.views[i].view, round + i);
            corner.write(corner.views.views[i], corner.frames[i]);
        }
        corner.windows.drawer().swapFrame();
    }
}

TEST(Drawer, EveryWindowShowsItsOwnView)
{
    BRICKWALL_NEEDS_DISPLAY();
    ShownRig corner(cornerRig(64, 48));
    const auto pictures = corner.draw();
    for (int i = 0; i < 2; ++i)
        expectPicture(*pictures[i].left, whole,
                      [&](int x, int y) { return composed(corner.frames[i], x, y, background); });
    EXPECT_NE(corner.windows.drawer().viewMatrix(0), corner.windows.drawer().viewMatrix(1));
}

TEST(Drawer, OpaqueGeometryInFrontHidesTheImage)
{
    BRICKWALL_NEEDS_DISPLAY();
    DrawnDesk desk;
    desk.show(desk.flatFrame({0.0f, 1.0f, 0.0f, 1.0f}, depthAt(3.0)));
    desk.windows.worldScene().addChild(redWall(2.5, 2.5));
    expectPicture(*desk.drawOne(), whole, [](int, int) { return Rgb{255, 0, 0}; });
}

TEST(Drawer, OpaqueGeometryBehindIsHiddenByOpaqueAndSeenThroughSemiTransparentPixels)
{
    BRICKWALL_NEEDS_DISPLAY();
    DrawnDesk desk;
    desk.windows.worldScene().addChild(redWall(3.5, 3.5));
    desk.show(desk.flatFrame({0.0f, 1.0f, 0.0f, 1.0f}, depthAt(3.0)));
    expectPicture(*desk.drawOne(), whole, [](int, int) { return Rgb{0, 255, 0}; });
    desk.show(desk.flatFrame({0.0f, 0.0f, 0.0f, 0.5f}, depthAt(3.0)));
    const Rgb seenThrough = pixel(*desk.drawOne(), 32, 24);
    EXPECT_NEAR(seenThrough[0], 128, 12);
    EXPECT_LT(seenThrough[1], 64);
}

TEST(Drawer, GeometryThroughTheImageIsCutWhereTheDepthsMeet)
{
    BRICKWALL_NEEDS_DISPLAY();
    DrawnDesk desk;
    // The wall leans: its distance is 3 at the height of the eye, less below, more above.
    desk.windows.worldScene().addChild(redWall(1.0, 5.0));
    desk.show(desk.flatFrame({0.0f, 1.0f, 0.0f, 1.0f}, depthAt(3.0)));
    const osg::ref_ptr<osg::Image> picture = desk.drawOne();
    expectPicture(*picture, {0, 0, 64, 23}, [](int, int) { return Rgb{255, 0, 0}; });
    expectPicture(*picture, {0, 25, 64, 23}, [](int, int) { return Rgb{0, 255, 0}; });
}

TEST(Drawer, EmptyPixelsLeaveTheSceneAlone)
{
    BRICKWALL_NEEDS_DISPLAY();
    DrawnDesk desk;
    desk.windows.worldScene().addChild(redWall(9.0, 9.0));
    MultiChannelDrawer& drawer = desk.windows.drawer();
    drawer.clearColor(0);
    drawer.clearDepth(0);
    EXPECT_TRUE(std::all_of(drawer.depth(0), drawer.depth(0) + 64 * 48, [](float d) { return d == 1.0f; }));
    drawer.swapFrame();
    expectPicture(
        *desk.drawOne(), whole,
        [](int, int) {
            return Rgb{255, 0, 0};
        },
        0);
}

TEST(Drawer, PixelsWithoutColourHideNothingWhateverTheirDepth)
{
    BRICKWALL_NEEDS_DISPLAY();
    DrawnDesk desk;
    desk.show(desk.flatFrame(vec4f(0.0f), depthAt(0.5)));
    const osg::ref_ptr<osg::Geometry> wall = redWall(2.5, 2.5);
    wall->getStateSet()->setRenderingHint(osg::StateSet::TRANSPARENT_BIN); // drawn after the image
    desk.windows.worldScene().addChild(wall);
    expectPicture(*desk.drawOne(), whole, [](int, int) { return Rgb{255, 0, 0}; });
}

// COVISE's drawer has one image per view, so that writing between swapFrame and drawing tears.
TEST(Drawer, WritingAfterSwapFrameDoesNotChangeWhatIsDrawn)
{
    BRICKWALL_NEEDS_DISPLAY();
    DrawnDesk desk;
    const Frame shown = desk.frames[0]; // swapped, but nothing has been drawn yet
    desk.write(desk.views.views[0], desk.flatFrame({1.0f, 0.0f, 1.0f, 1.0f}, 0.2f));
    expectPicture(*desk.drawOne(), whole, [&](int x, int y) { return composed(shown, x, y, background); });
    desk.windows.drawer().swapFrame();
    expectPicture(*desk.drawOne(), whole, [](int, int) { return Rgb{255, 0, 255}; });
}

TEST(Drawer, AViewThatNobodyWroteToKeepsItsImage)
{
    BRICKWALL_NEEDS_DISPLAY();
    ShownRig corner(cornerRig(64, 48));
    corner.draw();
    for (int round = 0; round < 3; ++round) {
        corner.frames[1] = patternFrame(corner.views.views[1].view, round);
        corner.write(corner.views.views[1], corner.frames[1]);
        corner.windows.drawer().swapFrame();
    }
    const auto pictures = corner.draw();
    for (int i = 0; i < 2; ++i)
        expectPicture(*pictures[i].left, whole,
                      [&](int x, int y) { return composed(corner.frames[i], x, y, background); });
}

TEST(Drawer, AResizedViewIsStretchedOverItsViewport)
{
    BRICKWALL_NEEDS_DISPLAY();
    DrawnDesk desk;
    for (const int factor : {2, 1, 4}) {
        View view = desk.views.views[0].view;
        view.window = {0, 0, 64 / factor, 48 / factor};
        desk.show(patternFrame(view, factor));
        expectPicture(*desk.drawOne(), whole,
                      [&](int x, int y) { return composed(desk.frames[0], x / factor, y / factor, background); });
    }
}

TEST(Drawer, AViewWithoutPixelsShowsNothing)
{
    BRICKWALL_NEEDS_DISPLAY();
    DrawnDesk desk;
    desk.drawOne();
    desk.windows.drawer().resizeView(0, 0, 0);
    EXPECT_EQ(desk.windows.drawer().rgba(0), nullptr);
    desk.windows.drawer().swapFrame();
    const Frame nothing = desk.flatFrame(vec4f(0.0f), 1.0f);
    expectPicture(*desk.drawOne(), whole, [&](int x, int y) { return composed(nothing, x, y, background); });
}

TEST(Drawer, HasAViewPerChannelAndEyeAndRefusesOthers)
{
    BRICKWALL_NEEDS_DISPLAY();
    ShownRig stereo(deskRig(64, 48, StereoMode::anaglyphic));
    MultiChannelDrawer& drawer = stereo.windows.drawer();
    EXPECT_EQ(drawer.numViews(), 2);
    EXPECT_THROW(drawer.rgba(2), Error);
    EXPECT_THROW(drawer.resizeView(0, -1, 5), Error);
    EXPECT_THROW(drawer.setNumViews(-2), Error);
    drawer.setNumViews(1);
    EXPECT_EQ(drawer.numViews(), 1);
    drawer.setNumViews(-1);
    EXPECT_EQ(drawer.numViews(), 2);
}

} // namespace
} // namespace brickwall::test
