// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestDisplay.h"
#include "TestRigs.h"

#include "brickwall/core/base/Error.h"

#include <gtest/gtest.h>

#include <string>
#include <utility>

namespace brickwall::test {
namespace {

constexpr int width = 70, height = 50;

/// Expects every pixel of a window of this mode to be that of the left or the right eye's frame.
void expectInterlaced(StereoMode mode, const std::function<bool(int x, int y)>& isLeft)
{
    Rig rig = deskRig(width, height, mode);
    rig.channels[0].viewport = {3, 5, width - 4, height - 6}; // odd offsets: the pattern is the window's
    ShownRig shown(rig);
    expectPicture(*shown.drawOne(), rig.channels[0].viewport, [&](int x, int y) {
        const Eye eye = isLeft(x + 3, y + 5) ? Eye::left : Eye::right;
        return composed(shown.frameOf(0, eye), x, y, rig.background);
    });
}

TEST(Stereo, HorizontalInterlaceHasTheLeftEyeInEvenRows)
{
    BRICKWALL_NEEDS_DISPLAY();
    expectInterlaced(StereoMode::horizontalInterlace, [](int, int y) { return y % 2 == 0; });
}

TEST(Stereo, VerticalInterlaceHasTheLeftEyeInEvenColumns)
{
    BRICKWALL_NEEDS_DISPLAY();
    expectInterlaced(StereoMode::verticalInterlace, [](int x, int) { return x % 2 == 0; });
}

TEST(Stereo, CheckerboardHasTheLeftEyeWhereColumnPlusRowIsEven)
{
    BRICKWALL_NEEDS_DISPLAY();
    expectInterlaced(StereoMode::checkerboard, [](int x, int y) { return (x + y) % 2 == 0; });
}

TEST(Stereo, AnaglyphHasTheLeftEyeRedAndTheRightEyeGreenAndBlue)
{
    BRICKWALL_NEEDS_DISPLAY();
    const Rig rig = deskRig(width, height, StereoMode::anaglyphic);
    ShownRig shown(rig);
    expectPicture(*shown.drawOne(), {0, 0, width, height}, [&](int x, int y) {
        const Rgb left = composed(shown.frameOf(0, Eye::left), x, y, rig.background);
        const Rgb right = composed(shown.frameOf(0, Eye::right), x, y, rig.background);
        return Rgb{left[0], right[1], right[2]};
    });
}

void expectSplit(StereoMode mode, const PixelRect& leftHalf, const PixelRect& rightHalf)
{
    const Rig rig = deskRig(width, height, mode);
    ShownRig shown(rig);
    const osg::ref_ptr<osg::Image> picture = shown.drawOne();
    expectPicture(*picture, leftHalf,
                  [&](int x, int y) { return composed(shown.frameOf(0, Eye::left), x, y, rig.background); });
    expectPicture(*picture, rightHalf,
                  [&](int x, int y) { return composed(shown.frameOf(0, Eye::right), x, y, rig.background); });
}

TEST(Stereo, HorizontalSplitHasTheLeftEyeInTheLeftHalf)
{
    BRICKWALL_NEEDS_DISPLAY();
    expectSplit(StereoMode::horizontalSplit, {0, 0, width / 2, height}, {width / 2, 0, width / 2, height});
}

TEST(Stereo, VerticalSplitHasTheLeftEyeInTheUpperHalf)
{
    BRICKWALL_NEEDS_DISPLAY();
    expectSplit(StereoMode::verticalSplit, {0, height / 2, width, height / 2}, {0, 0, width, height / 2});
}

TEST(Stereo, PassiveModesShowTheirEye)
{
    BRICKWALL_NEEDS_DISPLAY();
    for (const Eye eye : {Eye::left, Eye::right}) {
        const Rig rig = deskRig(width, height, eye == Eye::left ? StereoMode::left : StereoMode::right);
        ShownRig shown(rig);
        EXPECT_NEAR(shown.frameOf(0, eye).view.eye.x, eye == Eye::left ? -0.032 : 0.032, 1e-12);
        expectPicture(*shown.drawOne(), {0, 0, width, height},
                      [&](int x, int y) { return composed(shown.frameOf(0, eye), x, y, rig.background); });
    }
}

TEST(Stereo, QuadBufferShowsBothEyesOrSaysThatTheDisplayHasNone)
{
    BRICKWALL_NEEDS_DISPLAY();
    const Rig rig = deskRig(width, height, StereoMode::quadBuffer);
    try {
        ShownRig shown(rig);
        const WindowCapture::Picture picture = shown.draw().at(0);
        expectPicture(*picture.left, {0, 0, width, height},
                      [&](int x, int y) { return composed(shown.frameOf(0, Eye::left), x, y, rig.background); });
        expectPicture(*picture.right, {0, 0, width, height},
                      [&](int x, int y) { return composed(shown.frameOf(0, Eye::right), x, y, rig.background); });
    } catch (const Error& error) {
        EXPECT_NE(
            std::string(error.what()).find("window 'main': this display has no visual with left and right buffers"),
            std::string::npos)
            << error.what();
    }
}

// An eye behind its screen must leave the other channels alone and its own black.
TEST(Stereo, ARefusedEyeIsBlackAndTheOtherEyeIsShown)
{
    BRICKWALL_NEEDS_DISPLAY();
    Rig rig = deskRig(width, height, StereoMode::horizontalSplit);
    rig.viewers[0].rightEye = {0.032, 2.0, 0.0};
    ShownRig shown(rig);
    ASSERT_EQ(shown.views.refused.size(), 1u);
    const osg::ref_ptr<osg::Image> picture = shown.drawOne();
    expectPicture(*picture, {0, 0, width / 2, height},
                  [&](int x, int y) { return composed(shown.frameOf(0, Eye::left), x, y, rig.background); });
    expectPicture(
        *picture, {width / 2, 0, width / 2, height},
        [](int, int) {
            return Rgb{0, 0, 0};
        },
        0);
}

} // namespace
} // namespace brickwall::test
