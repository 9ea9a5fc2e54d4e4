// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Several cameras, windows and screens of OpenSceneGraph's stock viewer.
#include "HostScene.h"
#include "TestDisplay.h"

#include "brickwall/tests/common/ScratchFolder.h"

#include <gtest/gtest.h>

#include <fstream>

namespace brickwall::test {
namespace {

/// Pixels of a part of a picture that are not the viewer's background.
int seen(const osg::Image& picture, const PixelRect& part)
{
    int count = 0;
    for (int y = part.y; y < part.y + part.height; ++y)
        for (int x = part.x; x < part.x + part.width; ++x) {
            const Rgb color = pixel(picture, x, y);
            count += color != Rgb{51, 51, 102} && color != Rgb{0, 0, 0};
        }
    return count;
}

TEST(OsgScreens, AViewAcrossAllScreensOfAServer)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    const HostScene scene("");
    const XServer server({"160x120", "160x120"});
    ASSERT_NE(server.display(), "");
    OsgHost host("osgviewer " + cameraPathAt(scene.eye) + " " + scene.file, {"DISPLAY=" + server.display()});
    // The screens stand side by side, the data in the middle.
    const PixelRect rightHalf{80, 0, 80, 120}, leftHalf{0, 0, 80, 120};
    const auto some = [](const PixelRect& part) {
        return [part](const osg::Image& picture) { return seen(picture, part) > 50; };
    };
    const auto first = waitForPicture(160, 120, host, some(rightHalf), server.display() + ".0");
    const auto second = waitForPicture(160, 120, host, some(leftHalf), server.display() + ".1");
    EXPECT_GT(seen(*first, rightHalf), 50) << host.output();
    EXPECT_GT(seen(*second, leftHalf), 50) << host.output();
    EXPECT_LT(seen(*first, leftHalf), seen(*first, rightHalf));
    EXPECT_LT(seen(*second, rightHalf), seen(*second, leftHalf));
}

TEST(OsgScreens, AWindowOnTheSecondScreen)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    const HostScene scene("");
    const XServer server({"64x64", "160x120"});
    ASSERT_NE(server.display(), "");
    OsgHost host("osgviewer " + cameraPathAt(scene.eye) + " " + scene.file,
                 {"DISPLAY=" + server.display(), "OSG_SCREEN=1", "OSG_WINDOW=0 0 160 120"});
    scene.expectWindow(
        host, [&, frame = scene.frame(0)](int x, int y) { return scene.expected(frame, x, y); },
        server.display() + ".1");
}

TEST(OsgScreens, TheCamerasOfAConfigurationFile)
{
    BRICKWALL_NEEDS_OSGVIEWER();
    const HostScene scene("");
    const std::string file = scratchFile("two.cfg");
    std::ofstream(file) << R"(Visual "plain" { SetSimple }
RenderSurface "window" { Visual "plain"; Screen 0; WindowRect 0 0 160 120; Border off; }
Camera "left" {
  RenderSurface "window";
  Lens { Perspective 30.0 40.0 1.0 10000.0; }
  ProjectionRect 0.0 0.5 0.0 1.0;
  Offset { Shear 0.5 0.0; }
}
Camera "right" {
  RenderSurface "window";
  Lens { Perspective 30.0 40.0 1.0 10000.0; }
  ProjectionRect 0.5 1.0 0.0 1.0;
  Offset { Shear -0.5 0.0; }
}
)";
    OsgHost host("osgviewer -c " + file + " " + cameraPathAt(scene.eye) + " " + scene.file);
    const PixelRect left{0, 0, 80, 120}, right{80, 0, 80, 120};
    const auto picture = waitForPicture(
        160, 120, host, [&](const osg::Image& shown) { return seen(shown, left) > 50 && seen(shown, right) > 50; });
    EXPECT_GT(seen(*picture, left), 50) << host.output();
    EXPECT_GT(seen(*picture, right), 50) << host.output();
}

} // namespace
} // namespace brickwall::test
