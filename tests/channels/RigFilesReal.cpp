// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "RigFilesTesting.h"

#include <set>

using namespace brickwall;
using namespace brickwall::testing_rigs;

namespace {

/// Installations that exist.
class RealDisplays : public testing::Test
{
protected:
    void SetUp() override
    {
        if (!std::filesystem::exists(displays))
            GTEST_SKIP() << "the display configurations of real installations are not here";
    }

    static Rig load(const std::string& file, const RigScope& scope = {})
    {
        return loadRig((displays / file).string(), scope);
    }
};

} // namespace

TEST_F(RealDisplays, TheCologneCaveHasFiveWallsAndTenChannels)
{
    const Rig rig = load("config.caverrzk.xml");
    ASSERT_EQ(rig.screens.size(), 5u);
    ASSERT_EQ(rig.channels.size(), 10u);
    const double a = 1.5;
    const struct
    {
        const char* name;
        vec3d lowerLeft, lowerRight, upperRight;
    } walls[] = {{"front", {-a, a, -a}, {a, a, -a}, {a, a, a}},
                 {"left", {-a, -a, -a}, {-a, a, -a}, {-a, a, a}},
                 {"right", {a, a, -a}, {a, -a, -a}, {a, -a, a}},
                 {"bottom", {-a, -a, -a}, {a, -a, -a}, {a, a, -a}},
                 {"ceiling", {-a, a, a}, {a, a, a}, {a, -a, a}}};
    for (const auto& wall : walls) {
        const Screen& screen = screenNamed(rig, wall.name);
        expectNear(screen.lowerLeft, wall.lowerLeft);
        expectNear(screen.lowerRight, wall.lowerRight);
        expectNear(screen.upperRight, wall.upperRight);
    }
    expectNear(rig.viewers[0].leftEye, {-0.030, 0.0, 0.0});
    EXPECT_EQ(rig.viewers.size(), 1u);
    EXPECT_TRUE(anyContains(rig.notes, "config-colormaps.xml"));
    EXPECT_TRUE(anyContains(rig.notes, "master vismaster"));
}

TEST_F(RealDisplays, TheViewsOfTheCologneCaveAreNamedByWallAndEye)
{
    const Rig rig = load("config.caverrzk.xml");
    const RigViews views = viewsOfRig(rig, mat4d(1.0));
    std::set<std::string> names;
    for (const ChannelView& view : views.views)
        names.insert(view.name);
    EXPECT_EQ(names,
              (std::set<std::string>{"front-left", "front-right", "left-left", "left-right", "right-left",
                                     "right-right", "bottom-left", "bottom-right", "ceiling-left", "ceiling-right"}));
    EXPECT_TRUE(views.refused.empty());
}

TEST_F(RealDisplays, AHostOfTheCologneCaveShowsItsWallToItsEye)
{
    const Rig rig = load("config.caverrzk.xml", {.host = "visslave03"});
    ASSERT_EQ(rig.channels.size(), 1u);
    EXPECT_EQ(rig.screens[0].name, "left");
    EXPECT_EQ(rig.channels[0].stereo, StereoMode::right);
    EXPECT_EQ(rig.channels[0].viewport, (PixelRect{0, 0, 1600, 1600}));
    EXPECT_EQ(rig.windows[0].display, ":0.0");
    EXPECT_EQ(rig.windows[0].x, 480);
    expectNear(rig.screens[0].lowerLeft, {-1.5, -1.5, -1.5});
    const Rig master = load("config.caverrzk.xml", {.host = "VisMaster"});
    EXPECT_EQ(master.windows[0].width, 3738);
    EXPECT_EQ(master.windows[0].display, "");
    EXPECT_EQ(master.channels[0].viewport, (PixelRect{0, 0, 1280, 800}));
    EXPECT_THROW(load("config.caverrzk.xml", {.host = "elsewhere"}), Error);
}

TEST_F(RealDisplays, FullHdStereoIsOneWindowSplitInHalves)
{
    const Rig rig = load("config-fullhd-stereo.xml");
    ASSERT_EQ(rig.channels.size(), 1u);
    EXPECT_EQ(rig.channels[0].stereo, StereoMode::horizontalSplit);
    EXPECT_EQ(rig.channels[0].viewport, (PixelRect{0, 0, 1920, 1080}));
    EXPECT_DOUBLE_EQ(rig.sceneSize, 1.0);
    expectNear(rig.screens[0].lowerLeft, {-0.96, 0.0, -0.54});
}

TEST_F(RealDisplays, TheQuadBufferedProjectionHasItsViewportInTheChannel)
{
    const Rig rig = load("config.projectionOneScreenQuadbufferStereo1280x720.xml");
    ASSERT_EQ(rig.channels.size(), 1u);
    EXPECT_EQ(rig.channels[0].stereo, StereoMode::quadBuffer);
    EXPECT_EQ(rig.channels[0].viewport, (PixelRect{0, 0, 1111, 620}));
    EXPECT_TRUE(rig.windows[0].quadBuffer);
    EXPECT_EQ(rig.windows[0].display, ":0.0");
}

TEST_F(RealDisplays, KitwaresWallHasSixTiles)
{
    const Rig rig = load("kitware.pvx");
    ASSERT_EQ(rig.channels.size(), 6u);
    expectNear(rig.screens[0].lowerLeft, {-0.5588, 0.0762, -0.3048});
    expectNear(rig.screens[0].upperRight, {-0.186266667, 0.0762, 0.0});
    EXPECT_EQ(rig.windows[0].display, ":0");
    EXPECT_EQ(rig.windows[0].width, 1024);
    EXPECT_EQ(rig.windows[0].height, 838);
    EXPECT_EQ(rig.channels[5].name, "amber6");
}

// ParaView ships this example and reads "0/05" as 0 without a word, which makes the floor skewed.
TEST_F(RealDisplays, ParaviewsExampleWithATypingErrorIsRefusedWithItsLine)
{
    try {
        load("left_right_floor.pvx");
        FAIL() << "0/05 is no number";
    } catch (const Error& error) {
        EXPECT_EQ(std::string(error.what()),
                  (displays / "left_right_floor.pvx").string() +
                      ":25: machine \"Floor\", attribute LowerRight: expected three numbers, found \"0/05\" in \"1.13 "
                      "-0.635  0/05\"");
    }
}
