// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/channels/RigRooms.h"

#include "brickwall/core/base/Error.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <utility>

namespace brickwall {
namespace {

using namespace test;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

/// What checkRig says to a room in which something was changed; empty if it is content.
std::string complaint(const std::function<void(Rig&)>& change)
{
    Rig rig = cubeRoom();
    change(rig);
    try {
        checkRig(rig, "room.toml");
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

bool has(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

/// The warnings about a changed room, as one text.
std::string warnings(const std::function<void(Rig&)>& change)
{
    Rig rig = cubeRoom();
    change(rig);
    std::string text;
    for (const std::string& line : warningsOf(rig))
        text += line + "\n";
    return text;
}

TEST(RigChecks, ASoundRoomIsFineAndSilent)
{
    EXPECT_EQ(complaint([](Rig&) {}), "");
    EXPECT_EQ(warnings([](Rig&) {}), "");
    EXPECT_NO_THROW(checkRig(Rig{}, "empty"));
    EXPECT_TRUE(warningsOf(Rig{}).empty());
}

TEST(RigChecks, NameThePlaceAndTheIndexOutOfRange)
{
    const std::string screen = complaint([](Rig& r) { r.channels[2].screen = 4; });
    EXPECT_TRUE(has(screen, "room.toml") && has(screen, "channel 2 'right'") && has(screen, "4")) << screen;
    EXPECT_NE(complaint([](Rig& r) { r.channels[0].screen = -1; }), "");
    EXPECT_NE(complaint([](Rig& r) { r.channels[0].viewer = 1; }), "");
    EXPECT_NE(complaint([](Rig& r) { r.channels[0].viewer = -1; }), "");
    EXPECT_NE(complaint([](Rig& r) { r.channels[0].window = 1; }), "");
    EXPECT_NE(complaint([](Rig& r) { r.channels[0].window = -2; }), "");
}

TEST(RigChecks, RefuseEmptyViewports)
{
    EXPECT_NE(complaint([](Rig& r) { r.channels[0].viewport.width = 0; }), "");
    EXPECT_NE(complaint([](Rig& r) { r.channels[0].viewport.height = -5; }), "");
    EXPECT_EQ(complaint([](Rig& r) { r.channels[0].viewport.width = 1; }), "");
    EXPECT_NE(complaint([](Rig& r) { r.channels[0].viewport.x = 2147483647; }), ""); // no int is where it ends
    EXPECT_NE(complaint([](Rig& r) {
                  r.channels[0].viewport.width = 1; // no column for the right eye
                  r.channels[0].stereo = StereoMode::horizontalSplit;
              }),
              "");
}

TEST(RigChecks, RefuseScreensWithoutAnArea)
{
    EXPECT_TRUE(has(complaint([](Rig& r) { r.screens[1].lowerRight = r.screens[1].lowerLeft; }), "screen 1 'left'"));
    EXPECT_NE(complaint([](Rig& r) {
                  r.screens[1].upperRight = 3.0 * r.screens[1].lowerRight - 2.0 * r.screens[1].lowerLeft;
              }),
              "");
    EXPECT_NE(complaint([](Rig& r) { r.screens[1].upperRight.z = nan; }), "");
}

TEST(RigChecks, RefusePartsThatAreNotOnTheScreen)
{
    const auto part = [](const PixelRect& p, int width, int height) {
        return complaint([&](Rig& r) {
            r.screens[0].pixelWidth = width;
            r.screens[0].pixelHeight = height;
            r.channels[0].part = p;
        });
    };
    EXPECT_EQ(part({10, 20, 100, 100}, 200, 120), "");
    EXPECT_NE(part({10, 21, 100, 100}, 200, 120), "");
    EXPECT_NE(part({-1, 0, 100, 100}, 200, 120), "");
    EXPECT_NE(part({10, 20, 100, 0}, 200, 120), "");
    EXPECT_NE(part({0, 0, 100, 100}, 0, 0), "");
    EXPECT_NE(part({}, 200, 0), "");
}

TEST(RigChecks, RefuseNumbersThatMeanNothing)
{
    EXPECT_NE(complaint([](Rig& r) { r.near = 0.0; }), "");
    EXPECT_NE(complaint([](Rig& r) { r.far = r.near; }), "");
    EXPECT_NE(complaint([](Rig& r) { r.near = nan; }), "");
    EXPECT_EQ(complaint([](Rig& r) { r.far = std::numeric_limits<double>::infinity(); }), "");
    EXPECT_NE(complaint([](Rig& r) { r.viewers[0].leftEye.x = nan; }), "");
    EXPECT_NE(complaint([](Rig& r) { r.viewers[0].roomFromHead[3][1] = nan; }), "");
    EXPECT_NE(complaint([](Rig& r) { r.channels[3].lateralOffset = nan; }), "");
}

TEST(RigWarnings, FindTheTypingErrorInAnExampleFloor)
{
    // A shipped example of another program says "0/05" and means 1.05: the floor is a parallelogram.
    const std::string text = warnings([](Rig& r) { r.screens[3].lowerRight.y = 0.0; });
    EXPECT_TRUE(has(text, "screen 3 'floor'") && has(text, "no rectangle")) << text;
}

TEST(RigWarnings, NameUnusedScreensAndChannelsWithoutAWindow)
{
    EXPECT_TRUE(has(warnings([](Rig& r) { r.channels.pop_back(); }), "screen 3 'floor' is not used"));
    EXPECT_TRUE(has(warnings([](Rig& r) { r.channels[1].window = -1; }), "channel 1 'left' has no window"));
}

TEST(RigWarnings, NameViewportsThatLeaveTheirWindow)
{
    EXPECT_TRUE(has(warnings([](Rig& r) { r.channels[3].viewport.x = 301; }), "channel 3 'floor'"));
    EXPECT_TRUE(has(warnings([](Rig& r) { r.channels[0].viewport.y = -1; }), "leaves"));
    EXPECT_TRUE(has(warnings([](Rig& r) { r.windows[0].width = 0; }), "no pixels"));
}

TEST(RigWarnings, NameOverlappingViewports)
{
    EXPECT_TRUE(has(warnings([](Rig& r) { r.channels[1].viewport.x = 99; }), "overlap"));
    const auto passive = [](bool quadBuffer) {
        return warnings([=](Rig& r) {
            r.windows[0].quadBuffer = quadBuffer;
            r.channels[1].screen = r.channels[0].screen;
            r.channels[1].viewport = r.channels[0].viewport;
            r.channels[0].stereo = StereoMode::left;
            r.channels[1].stereo = StereoMode::right;
        });
    };
    EXPECT_TRUE(has(passive(false), "overlap"));
    EXPECT_FALSE(has(passive(true), "overlap")) << "each eye has its own buffer";
}

TEST(RigWarnings, NameEyesBehindScreens)
{
    const std::string text = warnings([](Rig& r) {
        r.viewers[0].roomFromHead = glm::translate(mat4d(1.0), {0.0, 1.5, 0.0});
    });
    EXPECT_TRUE(has(text, "front") && has(text, "behind")) << text;
    // Lower left and lower right swapped in the file: mirrored, hence seen from behind.
    const std::string swapped = warnings([](Rig& r) { std::swap(r.screens[0].lowerLeft, r.screens[0].lowerRight); });
    EXPECT_TRUE(has(swapped, "front") && has(swapped, "behind")) << swapped;
}

} // namespace
} // namespace brickwall
