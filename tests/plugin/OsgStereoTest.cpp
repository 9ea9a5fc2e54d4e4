// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The stereo modes of OpenSceneGraph, in its stock viewer: one camera draws both eyes.
#include "HostScene.h"
#include "TestDisplay.h"

#include <gtest/gtest.h>

namespace brickwall::test {
namespace {

constexpr int width = HostScene::width, height = HostScene::height;

std::vector<std::string> stereo(const std::string& mode)
{
    return {"OSG_STEREO=ON", "OSG_STEREO_MODE=" + mode};
}

/// Of both eyes, with as many pixels as the mode gives each.
struct Eyes
{
    HostScene scene{""};
    Frame left, right;

    explicit Eyes(int viewWidth = width, int viewHeight = height)
        : left(scene.frame(-1, viewWidth, viewHeight)), right(scene.frame(1, viewWidth, viewHeight))
    {
        double difference = 0.0;
        for (std::size_t i = 0; i < left.color.size(); ++i)
            difference = std::max(difference, double(std::abs(left.color[i].a - right.color[i].a)));
        EXPECT_GT(difference, 0.1) << "the eyes see the same";
    }
    Rgb of(bool isLeft, int x, int y) const { return scene.expected(isLeft ? left : right, x, y); }
};

TEST(OsgStereo, HorizontalSplit)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    const Eyes eyes(width / 2, height);
    OsgHost host(eyes.scene.viewer(eyes.scene.file), stereo("HORIZONTAL_SPLIT"));
    eyes.scene.expectWindow(host, [&](int x, int y) { return eyes.of(x < width / 2, x % (width / 2), y); });
}

TEST(OsgStereo, VerticalSplit)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    const Eyes eyes(width, height / 2);
    OsgHost host(eyes.scene.viewer(eyes.scene.file), stereo("VERTICAL_SPLIT"));
    eyes.scene.expectWindow(host, [&](int x, int y) { return eyes.of(y >= height / 2, x, y % (height / 2)); });
}

TEST(OsgStereo, Anaglyphic)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    const Eyes eyes;
    OsgHost host(eyes.scene.viewer(eyes.scene.file), stereo("ANAGLYPHIC"));
    eyes.scene.expectWindow(host, [&](int x, int y) {
        const Rgb left = eyes.of(true, x, y), right = eyes.of(false, x, y);
        return Rgb{left[0], right[1], right[2]};
    });
}

TEST(OsgStereo, OneEyeAlone)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    const Eyes eyes;
    for (const bool isLeft : {true, false}) {
        OsgHost host(eyes.scene.viewer(eyes.scene.file), stereo(isLeft ? "LEFT_EYE" : "RIGHT_EYE"));
        eyes.scene.expectWindow(host, [&](int x, int y) { return eyes.of(isLeft, x, y); });
    }
}

/// Which parity is the left eye's is OSG's affair (it draws a stipple pattern): the first picture tells.
void expectInterlaced(const std::string& mode, const std::function<int(int x, int y)>& parity)
{
    const Eyes eyes;
    OsgHost host(eyes.scene.viewer(eyes.scene.file), stereo(mode));
    int leftParity = 0;
    const auto wrongWith = [&](const osg::Image& picture, int left) {
        int wrong = 0;
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < width; ++x)
                wrong += !eyes.scene.isClose(picture, parity(x, y) == left ? eyes.left : eyes.right, x, y);
        return wrong;
    };
    waitForPicture(width, height, host, [&](const osg::Image& picture) {
        for (const int left : {0, 1}) {
            if (wrongWith(picture, left) == 0) {
                leftParity = left;
                return true;
            }
        }
        return false;
    });
    eyes.scene.expectWindow(host, [&](int x, int y) { return eyes.of(parity(x, y) == leftParity, x, y); });
}

TEST(OsgStereo, HorizontalInterlace)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    expectInterlaced("HORIZONTAL_INTERLACE", [](int, int y) { return y % 2; });
}

TEST(OsgStereo, VerticalInterlace)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    expectInterlaced("VERTICAL_INTERLACE", [](int x, int) { return x % 2; });
}

// Mesa's software renderer has no left and right buffers; then this is the host's affair, and it says so and ends.
TEST(OsgStereo, QuadBufferShowsTheLeftEyeInTheWindowOrTheHostHasNoVisual)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    const Eyes eyes;
    OsgHost host(eyes.scene.viewer(eyes.scene.file), stereo("QUAD_BUFFER"));
    waitForPicture(width, height, host, [&](const osg::Image& picture) {
        return eyes.scene.isClose(picture, eyes.left, 0, 0) &&
               eyes.scene.isClose(picture, eyes.left, width / 2, height / 2);
    });
    if (host.running())
        eyes.scene.expectWindow(host, [&](int x, int y) { return eyes.of(true, x, y); });
    else
        EXPECT_NE(host.output().find("Not able to create requested visual"), std::string::npos) << host.output();
}

TEST(OsgStereo, Checkerboard)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    expectInterlaced("CHECKERBOARD", [](int x, int y) { return (x + y) % 2; });
}

} // namespace
} // namespace brickwall::test
