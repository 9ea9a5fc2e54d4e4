// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "RigFilesTesting.h"

#include <glm/gtc/matrix_transform.hpp>

#include <limits>
#include <utility>

using namespace brickwall;
using namespace brickwall::testing_rigs;

namespace {

/// A rig in which every value differs from its default and from its neighbours, with numbers that no short decimal
/// says.
Rig strangeRig()
{
    Rig rig;
    rig.name = "strange \"rig\"";
    rig.near = 1.0 / 3.0;
    rig.far = std::numeric_limits<double>::infinity();
    rig.sceneCenter = {0.1, -1e-300, 2.0 / 7.0};
    rig.sceneSize = 1e22;
    rig.background = {0.1f, 1.0f / 3.0f, 0.0f};
    rig.notes = {"first\tnote", "second\x7f"};
    rig.screens = {{"wall", {-1.0 / 3.0, 1.0, 0.1}, {1.1, 1.0, 0.2}, {1.1, 1.7, 3.3}, 300, 200},
                   {"wall", {}, {1, 0, 0}, {1, 0, 1}}};
    rig.viewers.resize(2);
    rig.viewers[0].name = "guide";
    rig.viewers[0].roomFromHead =
        glm::rotate(glm::translate(mat4d(1.0), vec3d(0.1, 0.2, 0.3)), 0.3, vec3d(1.0, 2.0, 3.0));
    rig.viewers[1].name = "guest";
    rig.viewers[1].leftEye = {-0.03, 0.01, 0.1 / 3.0};
    rig.windows = {{"w", "host:0.1", -5, 7, 640, 480, false, true}, {"", "", 0, 0, 30, 20, true, false}};
    rig.channels.resize(3);
    rig.channels[0] = {"left", 0, 1, 0, {1, 2, 30, 40}, {10, 20, 30, 40}, StereoMode::checkerboard, true, 0.01 / 3.0};
    rig.channels[1] = {"left", 1, 0, 1, {0, 0, 3, 4}, {}, StereoMode::verticalSplit, false, 0.0};
    rig.channels[2] = {"unseen", 1, 0, -1, {0, 0, 3, 4}, {}, StereoMode::right, false, 0.0};
    return rig;
}

void expectSame(const Rig& a, const Rig& b)
{
    EXPECT_EQ(a.name, b.name);
    EXPECT_EQ(a.notes, b.notes);
    EXPECT_TRUE(a.near == b.near && a.far == b.far && a.sceneCenter == b.sceneCenter && a.sceneSize == b.sceneSize);
    EXPECT_TRUE(a.background == b.background);
    ASSERT_EQ(a.screens.size(), b.screens.size());
    for (std::size_t i = 0; i < a.screens.size(); ++i) {
        const Screen &s = a.screens[i], &t = b.screens[i];
        EXPECT_TRUE(s.name == t.name && s.lowerLeft == t.lowerLeft && s.lowerRight == t.lowerRight &&
                    s.upperRight == t.upperRight && s.pixelWidth == t.pixelWidth && s.pixelHeight == t.pixelHeight)
            << "screen " << i;
    }
    ASSERT_EQ(a.viewers.size(), b.viewers.size());
    for (std::size_t i = 0; i < a.viewers.size(); ++i) {
        const Viewer &v = a.viewers[i], &w = b.viewers[i];
        EXPECT_TRUE(v.name == w.name && v.roomFromHead == w.roomFromHead && v.leftEye == w.leftEye &&
                    v.rightEye == w.rightEye)
            << "viewer " << i;
    }
    ASSERT_EQ(a.windows.size(), b.windows.size());
    for (std::size_t i = 0; i < a.windows.size(); ++i) {
        const Window &v = a.windows[i], &w = b.windows[i];
        EXPECT_TRUE(v.name == w.name && v.display == w.display && v.x == w.x && v.y == w.y && v.width == w.width &&
                    v.height == w.height && v.decoration == w.decoration && v.quadBuffer == w.quadBuffer)
            << "window " << i;
    }
    ASSERT_EQ(a.channels.size(), b.channels.size());
    for (std::size_t i = 0; i < a.channels.size(); ++i) {
        const Channel &c = a.channels[i], &d = b.channels[i];
        EXPECT_TRUE(c.name == d.name && c.screen == d.screen && c.viewer == d.viewer && c.window == d.window &&
                    c.viewport == d.viewport && c.part == d.part && c.stereo == d.stereo &&
                    c.fixedViewer == d.fixedViewer && c.lateralOffset == d.lateralOffset)
            << "channel " << i;
    }
}

Rig throughFormat(const Rig& rig, RigFormat format, std::vector<std::string>& lost)
{
    return rigOf(writeRig(rig, format, lost));
}

const std::string minimal =
    "[[screen]]\nname = \"a\"\ncenter = [0, 1, 0]\nsize = [2, 1]\n[[window]]\nsize = [20, 10]\n";

} // namespace

TEST(RigRecords, TomlAndJsonRoundTripEveryBit)
{
    std::vector<std::string> lost;
    expectSame(throughFormat(strangeRig(), RigFormat::toml, lost), strangeRig());
    expectSame(throughFormat(strangeRig(), RigFormat::json, lost), strangeRig());
    EXPECT_TRUE(lost.empty());
    for (const std::string& name : builtInRigs())
        expectSame(throughFormat(loadRig(name), RigFormat::toml, lost), loadRig(name));
}

TEST(RigRecords, CoviseRoundTripsToAMillimetre)
{
    for (const std::string& name : builtInRigs()) {
        std::vector<std::string> lost;
        const Rig rig = loadRig(name), back = throughFormat(rig, RigFormat::covise, lost);
        ASSERT_EQ(back.channels.size(), rig.channels.size()) << name;
        const RigViews a = viewsOfRig(rig, mat4d(1.0)), b = viewsOfRig(back, mat4d(1.0));
        ASSERT_EQ(a.views.size(), b.views.size());
        for (std::size_t i = 0; i < a.views.size(); ++i) {
            expectNear(b.views[i].view.eye, a.views[i].view.eye, 1e-9);
            EXPECT_EQ(b.views[i].viewport, a.views[i].viewport);
            const View &v = a.views[i].view, &w = b.views[i].view;
            for (const auto& [x, y] : {std::pair(0, 0), std::pair(v.window.width, v.window.height)}) {
                const vec3d p = v.eye + rayDirection(v, v.window.x + x - 0.5, v.window.y + y - 0.5);
                const vec3d q = w.eye + rayDirection(w, w.window.x + x - 0.5, w.window.y + y - 0.5);
                expectNear(q, p, 1e-3);
            }
        }
    }
}

TEST(RigRecords, WhatAFormatCannotSayIsListed)
{
    std::vector<std::string> covise, pvx;
    writeRig(strangeRig(), RigFormat::covise, covise);
    writeRig(strangeRig(), RigFormat::pvx, pvx);
    EXPECT_TRUE(anyContains(covise, "infinite far"));
    EXPECT_TRUE(anyContains(covise, "whole millimetres"));
    EXPECT_TRUE(anyContains(covise, "has no window"));
    EXPECT_TRUE(anyContains(pvx, "verticalSplit"));
    EXPECT_TRUE(anyContains(pvx, "viewer \"guide\": its pose"));
}

TEST(RigRecords, PvxKeepsCornersAndWindows)
{
    std::vector<std::string> lost;
    const Rig rig = loadRig("cave5"), back = throughFormat(rig, RigFormat::pvx, lost);
    ASSERT_EQ(back.channels.size(), rig.channels.size());
    for (std::size_t i = 0; i < rig.channels.size(); ++i) {
        EXPECT_TRUE(back.screens[i].lowerLeft == rig.screens[rig.channels[i].screen].lowerLeft);
        EXPECT_TRUE(back.screens[i].upperRight == rig.screens[rig.channels[i].screen].upperRight);
        EXPECT_EQ(back.windows[i].x, rig.windows[rig.channels[i].window].x);
        EXPECT_EQ(back.channels[i].stereo, rig.channels[i].stereo);
    }
    EXPECT_EQ(back.viewers[0].leftEye, rig.viewers[0].leftEye);
}

TEST(RigRecords, LeavingOutTheObviousIsAllowed)
{
    const Rig rig = rigOf(minimal + "[[channel]]\n");
    EXPECT_EQ(rig.channels[0].name, "a");
    EXPECT_EQ(rig.channels[0].viewport, (PixelRect{0, 0, 20, 10}));
    EXPECT_EQ(rig.viewers.size(), 1u);
    expectNear(rig.screens[0].upperRight, {1.0, 1.0, 0.5});
}

TEST(RigRecords, EveryErrorNamesFileLineAndKey)
{
    EXPECT_NE(errorOf(minimal + "[[channel]]\nstero = \"left\"\n").find(":8: unknown key stero; expected"),
              std::string::npos);
    EXPECT_NE(errorOf(minimal + "[[channel]]\nscreen = \"b\"\n")
                  .find(":8: screen: expected the name of a [[screen]] (\"a\")"),
              std::string::npos);
    EXPECT_NE(errorOf(minimal + "[[channel]]\nstereo = \"both\"\n").find(":8: stereo: expected mono, left"),
              std::string::npos);
    EXPECT_NE(
        errorOf(minimal + "[[channel]]\nviewport = [0, 0, 1.5, 2]\n").find(":8: viewport: expected a whole number"),
        std::string::npos);
    EXPECT_NE(errorOf(minimal + "[chanel]\n").find(":7: unknown key chanel"), std::string::npos);
    EXPECT_NE(errorOf("[[screen]]\ncenter = [0, 1]\nsize = [2, 1]\n").find(":2: center: expected 3 numbers"),
              std::string::npos);
    EXPECT_NE(errorOf("[[screen]]\nlower_left = [0, 1, 2]\n").find(":1: lower_right is missing"), std::string::npos);
    EXPECT_NE(errorOf("[rig]\nname = \n").find(":2: expected well-formed TOML"), std::string::npos);
    EXPECT_NE(errorOf("{\n\"screen\": [\n{\"center\": 3}]}").find(":3: "), std::string::npos);
    EXPECT_NE(errorOf("{\n\"screen\": [{\n\"size\": [1, \"x\"],\n \"center\": [0, 0, 0]}]}")
                  .find(":3: size: expected a number"),
              std::string::npos);
    EXPECT_NE(errorOf("{\"screen\": 1e999}").find("number overflow"), std::string::npos);
    EXPECT_NE(errorOf("{\n\"screen\": oops}").find(":2: expected well-formed JSON"), std::string::npos);
    EXPECT_NE(errorOf(" \n").find("empty file"), std::string::npos);
}

TEST(RigRecords, BuiltInRigsAreFoundByNameAndAreSound)
{
    EXPECT_EQ(builtInRigs(), (std::vector<std::string>{"cave5", "desktop", "stereo-wall", "tiled-wall"}));
    for (const std::string& name : builtInRigs()) {
        EXPECT_TRUE(warningsOf(loadRig(name)).empty()) << name << ": " << warningsOf(loadRig(name))[0];
        EXPECT_EQ(loadRig(name).name, name);
    }
    try {
        loadRig("cave6");
        FAIL() << "there is no cave6";
    } catch (const Error& error) {
        EXPECT_NE(std::string(error.what()).find("cave5, desktop, stereo-wall and tiled-wall"), std::string::npos)
            << error.what();
    }
}
