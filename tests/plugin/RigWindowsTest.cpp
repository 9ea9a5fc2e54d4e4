// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestDisplay.h"
#include "TestRigs.h"

#include <gtest/gtest.h>

#include <osg/Geometry>

#include <chrono>
#include <thread>

namespace brickwall::test {
namespace {

/// On the desk rig's screen, from its middle to its right edge, white and unlit.
osg::ref_ptr<osg::Geometry> rightHalfOfTheScreen()
{
    osg::ref_ptr<osg::Geometry> quad =
        osg::createTexturedQuadGeometry(osg::Vec3(0, 1, -1), osg::Vec3(1, 0, 0), osg::Vec3(0, 0, 2));
    osg::ref_ptr<osg::Vec4Array> color = new osg::Vec4Array(osg::Array::BIND_OVERALL);
    color->push_back(osg::Vec4(1, 1, 1, 1));
    quad->setColorArray(color);
    quad->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    return quad;
}

void clearViews(ShownRig& shown)
{
    MultiChannelDrawer& drawer = shown.windows.drawer();
    for (int i = 0; i < drawer.numViews(); ++i) {
        drawer.clearColor(i);
        drawer.clearDepth(i);
    }
    drawer.swapFrame();
}

TEST(RigWindows, DrawTheScenesGeometryWhereTheChannelsPartOfTheScreenHasIt)
{
    BRICKWALL_NEEDS_DISPLAY();
    Rig rig = deskRig(96, 64);
    rig.background = vec3f(0.0f);
    rig.screens[0].pixelWidth = 96;
    rig.screens[0].pixelHeight = 64;
    rig.channels.push_back(rig.channels[0]);
    rig.channels[0].viewport = rig.channels[0].part = {0, 0, 32, 64};
    rig.channels[1].viewport = rig.channels[1].part = {32, 0, 64, 64};
    ShownRig shown(rig);
    clearViews(shown);
    shown.windows.worldScene().addChild(rightHalfOfTheScreen());
    expectPicture(
        *shown.drawOne(), {0, 0, 96, 64},
        [](int x, int) {
            return x < 48 ? Rgb{0, 0, 0} : Rgb{255, 255, 255};
        },
        0);
}

TEST(RigWindows, DrawTheScenesGeometryForEachEyeOfAStereoChannel)
{
    BRICKWALL_NEEDS_DISPLAY();
    for (const StereoMode mode : {StereoMode::horizontalInterlace, StereoMode::verticalInterlace,
                                  StereoMode::checkerboard, StereoMode::anaglyphic}) {
        ShownRig shown(deskRig(64, 64, mode));
        clearViews(shown);
        shown.windows.worldScene().addChild(rightHalfOfTheScreen()); // no parallax on the screen itself
        expectPicture(
            *shown.drawOne(), {32, 0, 32, 64},
            [](int, int) {
                return Rgb{255, 255, 255};
            },
            0);
    }
}

TEST(RigWindows, KnowTheirSizeAfterTheyWereResized)
{
    BRICKWALL_NEEDS_DISPLAY();
    ShownRig shown(deskRig(64, 48));
    const auto sizeIs = [&](const WindowSize& size) {
        for (int i = 0; i < 100 && shown.windows.sizes()[0] != size; ++i) {
            shown.draw();
            std::this_thread::sleep_for(std::chrono::milliseconds(10));
        }
        return shown.windows.sizes()[0] == size;
    };
    EXPECT_TRUE(sizeIs({64, 48}));
    shown.windows.toggleFullScreen(0);
    EXPECT_TRUE(sizeIs({1600, 1200}));
    shown.windows.toggleFullScreen(0);
    EXPECT_TRUE(sizeIs({64, 48}));
}

// The matrices of the drawer are those that put geometry on the screen: model, then view, then projection.
TEST(RigWindows, GiveTheDrawerTheMatricesOfTheViews)
{
    BRICKWALL_NEEDS_DISPLAY();
    ShownRig shown(cornerRig(32, 32));
    const MultiChannelDrawer& drawer = shown.windows.drawer();
    for (int i = 0; i < 2; ++i) {
        const osg::Matrixd clipFromModel = drawer.modelMatrix(i) * drawer.viewMatrix(i) * drawer.projectionMatrix(i);
        const View& view = shown.views.views[i].view;
        const vec4d expected = view.clipFromWorld * vec4d(0.3, 2.0, 0.4, 1.0);
        const osg::Vec4d found = osg::Vec4d(0.3, 2.0, 0.4, 1.0) * clipFromModel;
        for (int c = 0; c < 3; ++c)
            EXPECT_NEAR(found[c] / found.w(), expected[c] / expected.w, 1e-12);
    }
}

} // namespace
} // namespace brickwall::test
