// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestRigs.h"

#include "brickwall/plugin/RigLayout.h"

#include <gtest/gtest.h>

namespace brickwall::test {
namespace {

TEST(RigLayout, OfTheRigsOwnSizesIsTheRig)
{
    const Rig rig = cornerRig(64, 48);
    const Rig same = layoutOf(rig, windowSizes(rig, 1.0));
    EXPECT_EQ(same.channels[1].viewport, rig.channels[1].viewport);
    EXPECT_EQ(same.screens.size(), rig.screens.size());
    EXPECT_EQ(same.viewers.size(), rig.viewers.size());
}

TEST(RigLayout, KeepsProportionsAndCentresInAWindowOfAnotherShape)
{
    const Rig rig = deskRig(100, 50);
    const Rig wide = layoutOf(rig, std::vector<WindowSize>{{400, 100}});
    EXPECT_EQ(wide.channels[0].viewport, (PixelRect{100, 0, 200, 100}));
    EXPECT_EQ(wide.windows[0].width, 400);
}

TEST(RigLayout, NeighboursStayNeighboursAtEveryScale)
{
    Rig rig = deskRig(99, 50);
    rig.channels[0].viewport = {0, 0, 33, 50};
    rig.channels.push_back(rig.channels[0]);
    rig.channels[1].viewport = {33, 0, 66, 50};
    for (const double scale : {0.1, 0.37, 0.5, 1.25, 3.3}) {
        const Rig scaled = layoutOf(rig, windowSizes(rig, scale));
        EXPECT_EQ(scaled.channels[0].viewport.x + scaled.channels[0].viewport.width, scaled.channels[1].viewport.x)
            << scale;
    }
}

TEST(RigLayout, ScalesTheScreensPixelsWithTheChannelThatShowsAPart)
{
    Rig rig = deskRig(100, 50);
    rig.screens[0].pixelWidth = 200;
    rig.screens[0].pixelHeight = 50;
    rig.channels[0].part = {100, 0, 100, 50};
    const Rig half = layoutOf(rig, windowSizes(rig, 0.5));
    const Screen& screen = half.screens[half.channels[0].screen];
    EXPECT_EQ(screen.pixelWidth, 100);
    EXPECT_EQ(screen.pixelHeight, 25);
    EXPECT_EQ(half.channels[0].part, (PixelRect{50, 0, 50, 25}));
    EXPECT_EQ(rig.screens[0].pixelWidth, half.screens[0].pixelWidth) << "other channels may show this screen";
}

TEST(RigLayout, GivesChannelsWithoutHeadTrackingAViewerOfTheirOwn)
{
    Rig rig = cornerRig(64, 48);
    rig.channels[1].fixedViewer = true;
    const Rig result = layoutOf(rig, windowSizes(rig, 1.0));
    EXPECT_EQ(result.channels[0].viewer, 0);
    EXPECT_EQ(result.channels[1].viewer, 1);
    EXPECT_EQ(result.viewers.size(), 2u);
}

} // namespace
} // namespace brickwall::test
