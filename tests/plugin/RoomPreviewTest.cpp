// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestDisplay.h"
#include "TestRigs.h"

#include "brickwall/plugin/RoomPreview.h"

#include <gtest/gtest.h>

#include <osgViewer/GraphicsWindow>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

namespace brickwall::test {
namespace {

using namespace std::chrono_literals;
const Box3d unitBox{vec3d(-1.0), vec3d(1.0)};

/// Where the middle of what is yellow is, as heads are, in pixels; (-1, -1): nowhere.
vec3d headIn(const osg::Image& picture)
{
    vec3d sum(0.0);
    int count = 0;
    for (int y = 0; y < picture.t(); ++y)
        for (int x = 0; x < picture.s(); ++x) {
            const Rgb p = pixel(picture, x, y);
            if (p[0] > p[2] + 60 && p[1] > p[2] + 40) {
                sum += vec3d(x, y, 0);
                ++count;
            }
        }
    return count < 20 ? vec3d(-1.0) : sum / double(count);
}

TEST(RoomModel, ScreensSeenByTheViewerShowTheirFrames)
{
    BRICKWALL_NEEDS_DISPLAY();
    const Rig rig = cornerRig(64, 48);
    ShownRig shown(rig);
    const auto expected = shown.frames;
    shown.windows.drawer().setNumViews(0);
    RoomModel model(rig);
    model.setPictures(shown.views, expected);
    shown.windows.worldScene().addChild(model.node());
    const auto pictures = shown.draw();
    for (int i = 0; i < 2; ++i)
        expectPicture(*pictures[i].left, {1, 1, 62, 46},
                      [&](int x, int y) { return composed(expected[i], x + 1, y + 1, rig.background); });
}

TEST(RoomPreview, ShowsTheHeadMoveWhileTheRendererIsBusy)
{
    BRICKWALL_NEEDS_DISPLAY();
    std::atomic<bool> held = false;
    const FrameMaker make = [&](std::span<const View> views, Progress& progress) {
        while (held) {
            progress.check();
            std::this_thread::sleep_for(1ms);
        }
        return patternFrames(views, progress);
    };
    Progress progress;
    const Rig rig = cornerRig(64, 48);
    RoomPreview preview(rig, unitBox, make, progress);
    preview.drawCompleted();
    const auto before = preview.picture().left;
    ASSERT_GT(headIn(*before).x, 0.0);
    held = true;
    preview.navigation().moveHeads(vec3d(0.0, 0.0, 0.3));
    EXPECT_TRUE(preview.step());
    const vec3d way = headIn(*preview.picture().left) - headIn(*before);
    EXPECT_GT(way.y, 10.0) << "upwards";
    EXPECT_LT(std::abs(way.x), 3.0);
    held = false;
}

TEST(RoomPreview, ShowsChannelsWithoutAWindowAndRendersSmallPictures)
{
    BRICKWALL_NEEDS_DISPLAY();
    Rig rig = cornerRig(2048, 1024);
    for (Channel& channel : rig.channels)
        channel.window = -1;
    rig.windows.clear();
    std::vector<PixelRect> sizes;
    const FrameMaker make = [&](std::span<const View> views, Progress& progress) {
        for (const View& view : views)
            sizes.push_back(view.window);
        return patternFrames(views, progress);
    };
    Progress progress;
    RoomPreview preview(rig, unitBox, make, progress);
    preview.drawCompleted();
    ASSERT_EQ(sizes.size(), 2u);
    for (const PixelRect& size : sizes)
        EXPECT_EQ(size, (PixelRect{0, 0, 512, 256}));
    for (int i = 0; i < 20; ++i) { // at rest
        preview.step();
        std::this_thread::sleep_for(1ms);
    }
    EXPECT_EQ(sizes.size(), 2u);
}

TEST(RoomPreview, FillsItsWindowWhenThatIsResized)
{
    BRICKWALL_NEEDS_DISPLAY();
    Progress progress;
    const FrameMaker make = patternFrames;
    RoomPreview preview(cornerRig(64, 48), unitBox, make, progress);
    preview.drawCompleted();
    const vec3d before = headIn(*preview.picture().left);
    // Its window, as a window manager would do it; those of other tests are closed.
    for (osg::GraphicsContext* context : osg::GraphicsContext::getAllRegisteredGraphicsContexts())
        if (auto* window = dynamic_cast<osgViewer::GraphicsWindow*>(context))
            window->setWindowRectangle(0, 0, 500, 384);
    osg::ref_ptr<osg::Image> picture;
    for (int i = 0; i < 100 && (!picture || picture->s() != 500); ++i)
        picture = preview.picture().left;
    ASSERT_EQ(picture->s(), 500);
    ASSERT_EQ(picture->t(), 384);
    // Half as high, half as large, and in the middle still.
    const vec3d after = headIn(*picture);
    EXPECT_NEAR(after.x - 250.0, 0.5 * (before.x - 512.0), 4.0);
    EXPECT_NEAR(after.y, 0.5 * before.y, 4.0);
}

TEST(RoomPreview, HandsOnWhatRenderingThrowsAndEndsWhenItIsCancelled)
{
    BRICKWALL_NEEDS_DISPLAY();
    Progress progress;
    const FrameMaker fails = [](std::span<const View>, Progress&) -> std::vector<Frame> {
        throw std::runtime_error("no");
    };
    RoomPreview failing(deskRig(32, 32), unitBox, fails, progress);
    EXPECT_THROW(failing.drawCompleted(), std::runtime_error);

    const FrameMaker neverDone = [&](std::span<const View>, Progress& rendering) -> std::vector<Frame> {
        progress.cancel();
        for (;;) {
            rendering.check();
            std::this_thread::sleep_for(1ms);
        }
    };
    RoomPreview endless(deskRig(32, 32), unitBox, neverDone, progress);
    EXPECT_THROW(endless.drawCompleted(), Cancelled);
}

} // namespace
} // namespace brickwall::test
