// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "RigFilesTesting.h"

using namespace brickwall;
using namespace brickwall::testing_rigs;

namespace {

const std::string corners = "LowerLeft=\"-1 -1 -2\" LowerRight=\"1 -1 -2\" UpperRight=\"1 1 -2\"";

std::string machines(const std::string& text)
{
    return "<?xml version=\"1.0\" ?>\n<pvx>\n" + text + "\n</pvx>\n";
}

} // namespace

TEST(ParaviewPvx, ItsFrameIsYUpAndMinusZIntoTheScreen)
{
    const Rig rig = rigOf(machines("<Machine LowerLeft=\"-1.13 -0.635 1.04\" LowerRight=\"-1.13 -0.635 -1.22\" "
                                   "UpperRight=\"-1.13 0.635 -1.22\"/>"));
    expectNear(rig.screens[0].lowerLeft, {-1.13, -1.04, -0.635});
    expectNear(rig.screens[0].lowerRight, {-1.13, 1.22, -0.635});
    expectNear(rig.screens[0].upperRight, {-1.13, 1.22, 0.635});
    expectNear(rig.viewers[0].rightEye, {0.0325, 0.0, 0.0});
}

TEST(ParaviewPvx, GeometryIsThatOfX11)
{
    const auto windowOf = [](const std::string& geometry) {
        return rigOf(machines("<Machine " + corners + " Geometry=\"" + geometry + "\" Environment=\"DISPLAY=:0.1\"/>"))
            .windows[0];
    };
    const Window window = windowOf("1920x1200+10-20");
    EXPECT_EQ(window.width, 1920);
    EXPECT_EQ(window.height, 1200);
    EXPECT_EQ(window.x, 10);
    EXPECT_EQ(window.y, -20);
    EXPECT_EQ(window.display, ":0.1");
    EXPECT_EQ(windowOf("640x480").height, 480);
    for (const char* bad : {"640", "640x", "0x5", "640x480+1", "640x480+1+2+3", "axb"})
        EXPECT_THROW(windowOf(bad), Error) << bad;
}

TEST(ParaviewPvx, UpperLeftStandsForUpperRight)
{
    const Rig rig = rigOf(machines("<Machine LowerLeft=\"-1 -1 -2\" LowerRight=\"1 -1 -2\" UpperLeft=\"-1 1 -2\"/>"));
    expectNear(rig.screens[0].upperRight, {1.0, 2.0, 1.0});
}

TEST(ParaviewPvx, StereoTypesAndViewers)
{
    const Rig rig =
        rigOf(machines("<EyeSeparation Value=\"0.07\"/><IndependentViewers><Viewer Id=\"1\" EyeSeparation=\"0.05\"/>"
                       "</IndependentViewers>\n<Machine " +
                       corners + " StereoType=\"Crystal Eyes\" ViewerId=\"0\"/><Machine " + corners +
                       " StereoType=\"Left\" ViewerId=\"1\" Coverable=\"0\"/>"));
    EXPECT_EQ(rig.channels[0].stereo, StereoMode::quadBuffer);
    EXPECT_TRUE(rig.windows[0].quadBuffer);
    EXPECT_EQ(rig.channels[1].stereo, StereoMode::left);
    expectNear(rig.viewers[0].rightEye, {0.035, 0.0, 0.0});
    expectNear(rig.viewers[1].rightEye, {0.025, 0.0, 0.0});
    EXPECT_TRUE(anyContains(rig.notes, ":4: attribute Coverable is not read"));
}

TEST(ParaviewPvx, AMachineWithoutCornersHasParaviewsDefaultScreen)
{
    const Rig rig = rigOf(machines("<Machine Name=\"A\" Geometry=\"10x10+0+0\"/>"));
    expectNear(rig.screens[0].lowerLeft, {-0.5, 0.5, -0.5});
    EXPECT_TRUE(anyContains(rig.notes, "no corners"));
}

TEST(ParaviewPvx, EveryErrorNamesFileLineAndAttribute)
{
    EXPECT_NE(errorOf(machines("<Machine\n LowerLeft=\"0 0\" LowerRight=\"1 0 0\" UpperRight=\"1 1 0\"/>"))
                  .find(":4: machine \"\", attribute LowerLeft: expected three numbers, found 2"),
              std::string::npos);
    EXPECT_NE(errorOf(machines("<Machine Name=\"A\" LowerLeft=\"0 0 0\"/>"))
                  .find(":3: <Machine Name=\"A\"> has no attribute"),
              std::string::npos);
    EXPECT_NE(errorOf(machines("<Machine " + corners + "\nViewerId=\"2\"/>")).find(":4: expected viewer ids"),
              std::string::npos);
    EXPECT_NE(errorOf(machines("<EyeSeparation Value=\"6,5\"/>")).find(":3: <EyeSeparation>, attribute Value"),
              std::string::npos);
    std::string deep; // a call within a call for each of these needs more than a stack
    for (int i = 0; i < 500000; ++i)
        deep += "<Process>";
    for (int i = 0; i < 500000; ++i)
        deep += "</Process>";
    EXPECT_NE(errorOf("<pvx>" + deep + "</pvx>").find(":1: expected no <Process> within another"), std::string::npos);
    EXPECT_NE(errorOf("<pvx/>").find(":1: expected at least one <Machine>"), std::string::npos);
    EXPECT_NE(errorOf("<html/>").find(":1: expected the root element"), std::string::npos);
}
