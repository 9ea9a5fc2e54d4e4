// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "RigFilesTesting.h"

using namespace brickwall;
using namespace brickwall::testing_rigs;

namespace {

/// A file with this under COCONFIG.
std::string config(const std::string& sections)
{
    return "<COCONFIG version=\"1\">\n" + sections + "\n</COCONFIG>\n";
}

std::string cover(const std::string& elements)
{
    return config("<GLOBAL><COVER>\n" + elements + "\n</COVER></GLOBAL>");
}

const std::string window = "<WindowConfig><Window name=\"0\" width=\"800\" height=\"600\"/></WindowConfig>";

std::string screen(const std::string& attributes)
{
    return "<ScreenConfig><Screen name=\"0\" " + attributes + "/></ScreenConfig>";
}

} // namespace

TEST(CoviseScoping, LocalComesBeforeClusterBeforeGlobalForEachAttribute)
{
    const std::string text =
        config("<GLOBAL><COVER>" + window + screen("width=\"1000\" height=\"1100\" originX=\"1\"") +
               "</COVER></GLOBAL>" + "<CLUSTER MASTER=\"m\"><COVER>" + screen("height=\"1200\" originX=\"2\"") +
               "</COVER></CLUSTER>" + "<LOCAL HOST=\"a,B\"><COVER>" + screen("originX=\"3\"") + "</COVER></LOCAL>");
    const Rig b = rigOf(text, {.host = "b"}), other = rigOf(text, {.host = "c"});
    expectNear(b.screens[0].lowerLeft, {0.003 - 0.5, 0.0, -0.6});
    expectNear(other.screens[0].lowerLeft, {0.002 - 0.5, 0.0, -0.6});
    const Rig elsewhere = rigOf(text, {.host = "c", .master = "another"});
    expectNear(elsewhere.screens[0].lowerLeft, {0.001 - 0.5, 0.0, -0.55});
}

TEST(CoviseScoping, TheFirstDefinitionOfAnAttributeCounts)
{
    const Rig rig =
        rigOf(config("<GLOBAL><COVER>" + window + screen("width=\"1000\"") + "</COVER></GLOBAL><GLOBAL><COVER>" +
                     screen("width=\"3000\" height=\"500\"") + "</COVER></GLOBAL>"));
    expectNear(rig.screens[0].lowerLeft, {-0.5, 0.0, -0.25});
}

TEST(CoviseScoping, HostNamesAreComparedWithoutCaseAndDomain)
{
    const std::string text = config("<LOCAL HOST=\"Vis1.example.org\"><COVER>" + window + "</COVER></LOCAL>");
    EXPECT_EQ(rigOf(text, {.host = "VIS1"}).windows[0].width, 800);
}

TEST(CoviseScoping, FiltersWorkOnAnyElement)
{
    const std::string text =
        cover("<NumWindows value=\"1\"/><WindowConfig><Window name=\"0\" ARCH=\"windows\" width=\"1\"/>"
              "<Window name=\"0\" RANK=\"1-3\" width=\"200\"/><Window name=\"0\" HOST=\"a\" height=\"77\"/>"
              "<Window name=\"0\" ARCH=\"mac,x11\" width=\"300\" height=\"30\"/></WindowConfig>");
    const Rig second = rigOf(text, {.host = "a", .rank = 2}), first = rigOf(text, {.host = "b", .rank = 0});
    EXPECT_EQ(second.windows[0].width, 200);
    EXPECT_EQ(second.windows[0].height, 77);
    EXPECT_EQ(first.windows[0].width, 300);
    EXPECT_EQ(first.windows[0].height, 30);
}

TEST(CoviseScoping, IncludedFilesAreDefaultsAndMissingOnesANote)
{
    const std::string included = fileOf(cover(window + screen("width=\"1000\" height=\"900\"")), ".included.xml");
    const std::string name = std::filesystem::path(included).filename().string();
    const Rig rig = rigOf(config("<GLOBAL><COVER>" + screen("width=\"2000\"") + "</COVER></GLOBAL>\n<INCLUDE> " + name +
                                 " </INCLUDE><INCLUDE>" + name +
                                 "</INCLUDE><INCLUDE>nowhere.xml</INCLUDE><TRYINCLUDE>no.xml"
                                 "</TRYINCLUDE>"));
    expectNear(rig.screens[0].lowerLeft, {-1.0, 0.0, -0.45});
    EXPECT_TRUE(anyContains(rig.notes, "nowhere.xml"));
    EXPECT_FALSE(anyContains(rig.notes, " no.xml"));
}

TEST(CoviseXml, DefaultsAreThoseOfCovise)
{
    const Rig rig = rigOf(cover(""));
    expectNear(rig.screens[0].lowerLeft, {-1.0, 0.0, -0.75});
    expectNear(vec3d(rig.viewers[0].roomFromHead[3]), {0.0, -2.0, 0.03});
    expectNear(rig.viewers[0].rightEye, {0.032, 0.0, 0.0});
    EXPECT_EQ(rig.windows[0].width, 1024);
    EXPECT_EQ(rig.windows[0].height, 768);
    EXPECT_EQ(rig.channels[0].stereo, StereoMode::left);
    EXPECT_DOUBLE_EQ(rig.near, 0.01);
    EXPECT_DOUBLE_EQ(rig.far, 10000.0);
    EXPECT_DOUBLE_EQ(rig.sceneSize, 2.0);
}

TEST(CoviseXml, FractionsOfMillimetresAreCutAsInCoviseAndNoted)
{
    const Rig rig = rigOf(cover(screen("width=\"2700.5\" height=\"2700\"")));
    EXPECT_NEAR(rig.screens[0].lowerRight.x, 1.35, 1e-12);
    EXPECT_TRUE(
        anyContains(rig.notes, ":3: ScreenConfig.Screen:0, attribute width: COVISE reads whole numbers, 2700.5"));
}

TEST(CoviseXml, AFrustumIsAScreenAtItsRadius)
{
    const Rig rig = rigOf(cover(screen("frustum=\"0;0;100;90;0;0;-45;45;-45;45\" radius=\"1000\"")));
    expectNear(rig.screens[0].lowerLeft, {-1.0, -1.0, -0.9}, 2e-3);
    expectNear(rig.screens[0].upperRight, {-1.0, 1.0, 1.1}, 2e-3);
}

TEST(CoviseXml, ViewportsAreFractionsUpToOneAndPixelsAbove)
{
    const std::string port =
        "<ViewportConfig><Viewport name=\"0\" windowIndex=\"0\" left=\"0.25\" bottom=\"60\" right=\"1\" "
        "height=\"0.5\"/></ViewportConfig>";
    EXPECT_EQ(rigOf(cover(window + port)).channels[0].viewport, (PixelRect{200, 60, 600, 300}));
    const std::string old =
        "<ChannelConfig><Channel name=\"0\" windowIndex=\"0\" left=\"10\" width=\"100\"/></ChannelConfig>";
    EXPECT_EQ(rigOf(cover(window + old)).channels[0].viewport, (PixelRect{10, 0, 100, 600}));
}

TEST(CoviseXml, TwoScreensOfOneNameArePassiveStereo)
{
    const Rig rig = rigOf(cover("<NumScreens value=\"2\"/><ScreenConfig><Screen name=\"0\" comment=\"WALL\"/>"
                                "<Screen name=\"1\" comment=\"WALL\"/></ScreenConfig>"));
    ASSERT_EQ(rig.channels.size(), 2u);
    EXPECT_EQ(rig.screens.size(), 1u);
    EXPECT_EQ(rig.channels[0].stereo, StereoMode::left);
    EXPECT_EQ(rig.channels[1].stereo, StereoMode::right);
    EXPECT_EQ(rig.channels[0].name, "wall");
    EXPECT_EQ(rig.channels[1].name, "wall");
}

TEST(CoviseXml, ANegativeSeparationSwapsTheEyesAndSwitchedOffStereoHasNone)
{
    expectNear(rigOf(cover("<Stereo separation=\"-50\"/>")).viewers[0].leftEye, {0.025, 0.0, 0.0});
    expectNear(rigOf(cover("<Stereo separation=\"AUTO\"/>")).viewers[0].rightEye, {0.5, 0.0, 0.0});
    expectNear(rigOf(cover("<Stereo value=\"OFF\" separation=\"60\"/>")).viewers[0].rightEye, {0.0, 0.0, 0.0});
}

TEST(CoviseXml, PipesNameTheDisplay)
{
    const auto displayOf = [](const std::string& pipe) {
        return rigOf(cover("<PipeConfig><Pipe name=\"0\" " + pipe + "/></PipeConfig>")).windows[0].display;
    };
    EXPECT_EQ(displayOf("server=\"1\" screen=\"2\""), ":1.2");
    EXPECT_EQ(displayOf("server=\"1\" useDISPLAY=\"on\""), "");
    EXPECT_EQ(displayOf("host=\"vis2\""), "vis2:0.0");
}

TEST(CoviseXml, EveryErrorNamesFileLineElementAndAttribute)
{
    EXPECT_EQ(errorOf(cover("\n" + screen("\n  width=\"3OOO\""))),
              ":5: ScreenConfig.Screen:0, attribute width: expected a number, found \"3OOO\"");
    EXPECT_EQ(errorOf(cover("<NumScreens value=\"51\"/>")), ":3: NumScreens: expected 0 to 50, found 51");
    EXPECT_EQ(
        errorOf(cover("<ChannelConfig><Channel name=\"0\"\nscreenIndex=\"4\"/></ChannelConfig>")),
        ":4: ChannelConfig.Channel:0, attribute screenIndex: expected one of the 1 screens (NumScreens), found 4");
    EXPECT_NE(errorOf(cover("<StereoMode value=\"DOUBLE\"/>")).find(":3: "), std::string::npos);
    EXPECT_NE(errorOf(cover(screen("frustum=\"1;2;3\""))).find(":3: ScreenConfig.Screen:0, attribute frustum"),
              std::string::npos);
    EXPECT_NE(errorOf(config("<LOCAL><COVER/></LOCAL>")).find(":2: <LOCAL> has no attribute HOST"), std::string::npos);
    EXPECT_NE(errorOf("<COCONFIG>\n<GLOBAL>\n</COCONFIG>").find(":3: expected well-formed XML"), std::string::npos);
    EXPECT_NE(errorOf(cover("<NumScreens value=\"0\"/>"), {.host = "vis"}).find("host \"vis\" shows no channels"),
              std::string::npos);
    std::string deep;
    for (int i = 0; i < 5000; ++i)
        deep += "<a>";
    for (int i = 0; i < 5000; ++i)
        deep += "</a>";
    EXPECT_NE(errorOf(cover(deep)).find("nested more than 64 deep"), std::string::npos);
}
