// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/channels/RigRooms.h"

#include "brickwall/core/base/Error.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brickwall {
namespace {

using namespace test;

const mat4d identity(1.0);

std::vector<std::string> namesOf(const RigViews& views)
{
    std::vector<std::string> names;
    for (const ChannelView& v : views.views)
        names.push_back(v.name);
    return names;
}

using Names = std::vector<std::string>;

TEST(ViewsOfRig, MonoUsesTheMiddleEye)
{
    Rig rig = cubeRoom();
    rig.viewers[0].leftEye = {-0.05, 0.02, 0.01};
    rig.viewers[0].rightEye = {0.03, 0.02, 0.03};
    const RigViews views = viewsOfRig(rig, identity);
    EXPECT_EQ(namesOf(views), (Names{"front", "left", "right", "floor"}));
    EXPECT_TRUE(views.refused.empty());
    for (int i = 0; i < 4; ++i) {
        EXPECT_EQ(views.views[i].channel, i);
        EXPECT_EQ(views.views[i].eye, Eye::middle);
        EXPECT_EQ(views.views[i].viewport, rig.channels[i].viewport);
        EXPECT_EQ(views.views[i].view.window, (PixelRect{0, 0, 100, 100}));
        EXPECT_LT(glm::length(views.views[i].view.eye - vec3d(-0.01, 0.02, 0.02)), 1e-15);
    }
}

TEST(ViewsOfRig, SplitModesGiveEachEyeItsHalf)
{
    const RigViews across = viewsOfRig(oneWall(StereoMode::horizontalSplit), identity);
    ASSERT_EQ(namesOf(across), (Names{"front-left", "front-right"}));
    EXPECT_EQ(across.views[0].viewport, (PixelRect{10, 20, 100, 80}));
    EXPECT_EQ(across.views[1].viewport, (PixelRect{110, 20, 100, 80}));
    const RigViews upwards = viewsOfRig(oneWall(StereoMode::verticalSplit), identity);
    EXPECT_EQ(upwards.views[0].viewport, (PixelRect{10, 60, 200, 40})) << "the left eye has the upper half";
    EXPECT_EQ(upwards.views[1].viewport, (PixelRect{10, 20, 200, 40}));
    for (const RigViews& views : {across, upwards})
        for (const ChannelView& v : views.views) { // all of the screen, with the pixels of the half
            EXPECT_EQ(v.view.window, (PixelRect{0, 0, v.viewport.width, v.viewport.height}));
            EXPECT_EQ(v.view.lowerLeft, vec3d(-1, 1, -1));
            EXPECT_EQ(v.view.upperRight, vec3d(1, 1, 1));
        }
}

TEST(ViewsOfRig, HalvesOfAnOddViewportAreEquallyLargeAndApart)
{
    Rig rig = oneWall(StereoMode::horizontalSplit);
    rig.channels[0].viewport = {0, 0, 201, 81};
    const RigViews across = viewsOfRig(rig, identity);
    EXPECT_EQ(across.views[0].viewport, (PixelRect{0, 0, 100, 81}));
    EXPECT_EQ(across.views[1].viewport, (PixelRect{101, 0, 100, 81}));
    rig.channels[0].stereo = StereoMode::verticalSplit;
    const RigViews upwards = viewsOfRig(rig, identity);
    EXPECT_EQ(upwards.views[0].viewport, (PixelRect{0, 41, 201, 40}));
    EXPECT_EQ(upwards.views[1].viewport, (PixelRect{0, 0, 201, 40}));
}

TEST(ViewsOfRig, OtherTwoEyeModesUseTheFullViewportTwice)
{
    for (const StereoMode mode : {StereoMode::anaglyphic, StereoMode::quadBuffer, StereoMode::horizontalInterlace,
                                  StereoMode::verticalInterlace, StereoMode::checkerboard}) {
        const RigViews views = viewsOfRig(oneWall(mode), identity);
        ASSERT_EQ(namesOf(views), (Names{"front-left", "front-right"})) << toString(mode);
        EXPECT_EQ(views.views[0].viewport, (PixelRect{10, 20, 200, 80}));
        EXPECT_EQ(views.views[1].viewport, (PixelRect{10, 20, 200, 80}));
    }
}

TEST(ViewsOfRig, EyesAreNotSwappedAndTurnWithTheHead)
{
    for (const StereoMode mode : {StereoMode::quadBuffer, StereoMode::horizontalSplit, StereoMode::verticalSplit}) {
        Rig rig = oneWall(mode);
        const RigViews ahead = viewsOfRig(rig, identity);
        EXPECT_EQ(ahead.views[0].eye, Eye::left);
        EXPECT_LT(ahead.views[0].view.eye.x, ahead.views[1].view.eye.x);
        // Looking at the left wall: the left eye is now behind, in the room's -y.
        rig.viewers[0].roomFromHead = glm::rotate(identity, 0.5 * std::numbers::pi, vec3d(0, 0, 1));
        const RigViews aside = viewsOfRig(rig, identity);
        EXPECT_NEAR(aside.views[0].view.eye.x, 0.0, 1e-15);
        EXPECT_NEAR(aside.views[0].view.eye.y, -0.032, 1e-15);
        EXPECT_NEAR(aside.views[1].view.eye.y, 0.032, 1e-15);
    }
    const RigViews left = viewsOfRig(oneWall(StereoMode::left), identity);
    const RigViews right = viewsOfRig(oneWall(StereoMode::right), identity);
    EXPECT_EQ(namesOf(left), Names{"front-left"});
    EXPECT_EQ(namesOf(right), Names{"front-right"});
    EXPECT_NEAR(left.views[0].view.eye.x, -0.032, 1e-15);
    EXPECT_NEAR(right.views[0].view.eye.x, 0.032, 1e-15);
}

TEST(ViewsOfRig, NamesAreUnique)
{
    Rig rig = cubeRoom();
    rig.channels[0].name = rig.channels[1].name = "wall";
    rig.channels[0].stereo = StereoMode::left;
    rig.channels[1].stereo = StereoMode::right;
    rig.channels[2].name = rig.channels[3].name = "";
    EXPECT_EQ(namesOf(viewsOfRig(rig, identity)), (Names{"wall-left", "wall-right", "channel2", "channel3"}));
    for (Channel& c : rig.channels) {
        c.name = "wall";
        c.stereo = StereoMode::mono;
    }
    EXPECT_EQ(namesOf(viewsOfRig(rig, identity)), (Names{"wall", "wall-2", "wall-3", "wall-4"}));
    rig.channels[1].name = "wall-3";
    EXPECT_EQ(namesOf(viewsOfRig(rig, identity)), (Names{"wall", "wall-3", "wall-2", "wall-4"}));
}

TEST(ViewsOfRig, AnEyeBehindAScreenIsRefusedAndTheOthersGoOn)
{
    Rig rig = cubeRoom();
    rig.viewers[0].roomFromHead = glm::translate(identity, {-1.25, 0.0, 0.0}); // outside, left of the left wall
    const RigViews views = viewsOfRig(rig, identity);
    EXPECT_EQ(namesOf(views), (Names{"front", "right", "floor"}));
    ASSERT_EQ(views.refused.size(), 1u);
    EXPECT_EQ(views.refused[0].name, "left");
    EXPECT_NE(views.refused[0].reason.find("-0.25"), std::string::npos) << views.refused[0].reason;
}

TEST(ViewsOfRig, OneEyeMayBeBehindWhileTheOtherSees)
{
    Rig rig = cubeRoom();
    for (Channel& c : rig.channels)
        c.stereo = StereoMode::quadBuffer;
    rig.viewers[0].roomFromHead = glm::translate(identity, {-1.0, 0.0, 0.0});
    const RigViews views = viewsOfRig(rig, identity);
    EXPECT_EQ(views.views.size(), 7u);
    ASSERT_EQ(views.refused.size(), 1u);
    EXPECT_EQ(views.refused[0].name, "left-left");
}

TEST(ViewsOfRig, PartsOfAScreenHaveTheRaysOfTheWholeBitForBit)
{
    Rig rig = oneWall(StereoMode::mono);
    rig.screens[0].pixelWidth = 150;
    rig.screens[0].pixelHeight = 90;
    rig.viewers[0].roomFromHead = glm::translate(identity, {0.123, -0.456, 0.321});
    rig.channels[0].viewport = {0, 0, 150, 90};
    Channel part = rig.channels[0];
    for (const PixelRect& p : {PixelRect{0, 0, 70, 50}, PixelRect{70, 0, 80, 50}, PixelRect{0, 50, 150, 40}}) {
        part.part = p;
        part.viewport = {7, 3, p.width, p.height};
        rig.channels.push_back(part);
    }
    const RigViews views = viewsOfRig(rig, glm::rotate(glm::scale(identity, vec3d(3.0)), 0.7, {0.6, 0.0, 0.8}));
    const View& whole = views.views[0].view;
    for (int k = 1; k <= 3; ++k) {
        const View& tile = views.views[k].view;
        ASSERT_EQ(tile.window, rig.channels[k].part);
        for (int y = tile.window.y; y < tile.window.y + tile.window.height; ++y)
            for (int x = tile.window.x; x < tile.window.x + tile.window.width; ++x)
                ASSERT_EQ(rayDirection(tile, x, y), rayDirection(whole, x, y));
    }
}

TEST(ViewsOfRig, APartWithOtherPixelsCoversTheSamePiece)
{
    Rig rig = oneWall(StereoMode::horizontalSplit);
    rig.screens[0].pixelWidth = 400;
    rig.screens[0].pixelHeight = 100;
    rig.channels[0].part = {100, 50, 200, 50};
    const RigViews views = viewsOfRig(rig, identity);
    for (const ChannelView& v : views.views) {
        EXPECT_EQ(v.view.window, (PixelRect{0, 0, 100, 80}));
        EXPECT_LT(glm::length(v.view.lowerLeft - vec3d(-0.5, 1, 0)), 1e-15);
        EXPECT_LT(glm::length(v.view.lowerRight - vec3d(0.5, 1, 0)), 1e-15);
        EXPECT_LT(glm::length(v.view.upperRight - vec3d(0.5, 1, 1)), 1e-15);
    }
}

TEST(ViewsOfRig, FollowAWorldOfAnySizeAndPlace)
{
    Rig rig = cubeRoom();
    rig.near = 0.1;
    rig.far = 20.0;
    rig.viewers[0].roomFromHead = glm::translate(identity, {0.2, 0.1, 0.3});
    const double scale = 250.0;
    const mat4d turn = glm::rotate(identity, 1.1, glm::normalize(vec3d(1, 2, -1)));
    const mat4d world = glm::translate(identity, {500, -100, 30}) * turn * glm::scale(identity, vec3d(scale));
    const RigViews here = viewsOfRig(rig, identity), there = viewsOfRig(rig, world);
    for (int k = 0; k < 4; ++k) {
        const View &a = here.views[k].view, &b = there.views[k].view;
        EXPECT_LT(glm::length(b.eye - transformPoint(world, a.eye)), 1e-12);
        const vec3d ray = rayDirection(a, 30, 70), moved = transformVector(world, ray);
        EXPECT_LT(glm::length(rayDirection(b, 30, 70) - moved) / glm::length(moved), 1e-14);
        // The same point has the same depth: near and far are carried over.
        const vec3d p = a.eye + 0.8 * ray;
        EXPECT_NEAR(transformPoint(b.clipFromWorld, transformPoint(world, p)).z, transformPoint(a.clipFromWorld, p).z,
                    1e-11);
    }
}

TEST(ViewsOfRig, HaveTheRaysOfTheMatricesForEveryHeadPose)
{
    Rig rig = cubeRoom();
    for (Channel& c : rig.channels)
        c.stereo = StereoMode::quadBuffer;
    double largest = 0.0;
    for (int i = 0; i < 100; ++i) {
        const vec3d position(0.8 * std::sin(1.0 * i), 0.8 * std::sin(2.3 * i), 0.8 * std::sin(3.7 * i));
        const vec3d axis = glm::normalize(vec3d(std::sin(5.0 * i), std::cos(7.0 * i), 0.1));
        rig.viewers[0].roomFromHead = glm::rotate(glm::translate(identity, position), 0.3 * i, axis);
        const RigViews views = viewsOfRig(rig, identity);
        ASSERT_EQ(views.views.size(), 8u);
        for (const ChannelView& v : views.views) {
            const View& a = v.view;
            const View b = viewOfMatrices(
                v.name, modelviewOfScreen(a.eye, a.lowerLeft, a.lowerRight, a.upperRight),
                projectionOfScreen(a.eye, a.lowerLeft, a.lowerRight, a.upperRight, rig.near, rig.far), 100, 100);
            for (const double x : {0.0, 50.0, 99.0})
                largest = std::max(largest, glm::length(glm::normalize(rayDirection(a, x, 20.0)) -
                                                        glm::normalize(rayDirection(b, x, 20.0))));
        }
    }
    EXPECT_LT(largest, 1e-14);
}

TEST(ViewsOfRig, NeedASimilarity)
{
    const Rig rig = cubeRoom();
    for (const vec3d& bad : {vec3d(1, 1, 2), vec3d(-1, 1, 1), vec3d(0, 1, 1), vec3d(0, 0, 0), vec3d(-1, -1, -1)})
        EXPECT_THROW(viewsOfRig(rig, glm::scale(identity, bad)), Error);
    mat4d sheared(1.0);
    sheared[1][0] = 0.1;
    EXPECT_THROW(viewsOfRig(rig, sheared), Error);
    EXPECT_NO_THROW(viewsOfRig(rig, glm::scale(identity, vec3d(1e-20))));
}

TEST(ViewsOfRig, UseEachChannelsOwnViewer)
{
    Rig rig = cubeRoom();
    rig.viewers.push_back(rig.viewers[0]);
    rig.viewers[1].roomFromHead = glm::translate(identity, {0.5, 0.0, 0.0});
    rig.channels[2].viewer = 1;
    rig.channels[3].lateralOffset = 0.25;
    const RigViews views = viewsOfRig(rig, identity);
    EXPECT_EQ(views.views[0].view.eye, vec3d(0.0));
    EXPECT_EQ(views.views[2].view.eye, vec3d(0.5, 0.0, 0.0));
    EXPECT_EQ(views.views[3].view.eye, vec3d(0.25, 0.0, 0.0));
}

} // namespace
} // namespace brickwall
