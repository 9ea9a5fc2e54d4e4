// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/Rig.h"

#include "brickwall/core/base/Error.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <numbers>
#include <set>

namespace brickwall {
namespace {

constexpr StereoMode allModes[] = {StereoMode::mono,
                                   StereoMode::left,
                                   StereoMode::right,
                                   StereoMode::horizontalSplit,
                                   StereoMode::verticalSplit,
                                   StereoMode::anaglyphic,
                                   StereoMode::quadBuffer,
                                   StereoMode::horizontalInterlace,
                                   StereoMode::verticalInterlace,
                                   StereoMode::checkerboard};

mat4d pose(const vec3d& position, double degreesAboutUp)
{
    return glm::rotate(glm::translate(mat4d(1.0), position), degreesAboutUp * std::numbers::pi / 180.0,
                       vec3d(0.0, 0.0, 1.0));
}

TEST(RigEyes, AreLeftAndRightOfTheHeadsForwardDirection)
{
    for (const double degrees : {0.0, 30.0, 90.0, 180.0, -90.0, 271.0}) {
        Viewer viewer;
        viewer.roomFromHead = pose({0.3, -0.2, 0.1}, degrees);
        const double a = degrees * std::numbers::pi / 180.0;
        const vec3d forward(-std::sin(a), std::cos(a), 0.0), left(-std::cos(a), -std::sin(a), 0.0);
        const vec3d apart = eyePoint(viewer, Eye::left) - eyePoint(viewer, Eye::right);
        EXPECT_NEAR(glm::dot(apart, left), 0.064, 1e-15) << degrees;
        EXPECT_NEAR(glm::dot(apart, forward), 0.0, 1e-15) << degrees;
        EXPECT_LT(glm::length(eyePoint(viewer, Eye::middle) - vec3d(0.3, -0.2, 0.1)), 1e-15);
    }
}

TEST(RigEyes, AreBothTurnedByANoddingAndATiltedHead)
{
    Viewer viewer;
    viewer.leftEye = {-0.03, 0.07, 0.01};
    viewer.rightEye = {0.03, 0.07, 0.01};
    // Looking up by 90 degrees: forward becomes up, up becomes backwards.
    viewer.roomFromHead = glm::rotate(mat4d(1.0), 0.5 * std::numbers::pi, vec3d(1.0, 0.0, 0.0));
    EXPECT_LT(glm::length(eyePoint(viewer, Eye::left) - vec3d(-0.03, -0.01, 0.07)), 1e-15);
    // Tilted to the right by 90 degrees: the left eye is above the right one.
    viewer.roomFromHead = glm::rotate(mat4d(1.0), 0.5 * std::numbers::pi, vec3d(0.0, 1.0, 0.0));
    EXPECT_LT(glm::length(eyePoint(viewer, Eye::left) - vec3d(0.01, 0.07, 0.03)), 1e-15);
    EXPECT_LT(glm::length(eyePoint(viewer, Eye::right) - vec3d(0.01, 0.07, -0.03)), 1e-15);
}

TEST(RigEyes, OfCovisesTestVector)
{
    // Head at (300, -200, 100) mm, 64 mm apart: the left eye is at (268, -200, 100).
    Viewer viewer;
    viewer.roomFromHead = pose({0.3, -0.2, 0.1}, 0.0);
    EXPECT_LT(glm::length(eyePoint(viewer, Eye::left) - vec3d(0.268, -0.2, 0.1)), 1e-15);
    EXPECT_LT(glm::length(eyePoint(viewer, Eye::right, 0.05) - vec3d(0.382, -0.2, 0.1)), 1e-15);
}

TEST(RigEyes, MoveSidewaysWithTheHeadByTheLateralOffset)
{
    Viewer viewer;
    viewer.roomFromHead = pose({0.0, 0.0, 0.0}, 90.0); // looking at the left wall, head's x = room's y
    EXPECT_LT(glm::length(eyePoint(viewer, Eye::middle, 0.5) - vec3d(0.0, 0.5, 0.0)), 1e-15);
}

TEST(RigWords, AreDifferentForEveryModeAndEye)
{
    std::set<std::string> names;
    for (const StereoMode mode : allModes)
        names.insert(toString(mode));
    EXPECT_EQ(names.size(), std::size(allModes));
    EXPECT_EQ(names.count("unknown"), 0u);
    EXPECT_EQ(toString(StereoMode::horizontalSplit), "horizontal_split");
    EXPECT_EQ(toString(Eye::left) + toString(Eye::right) + toString(Eye::middle), "leftrightmiddle");
}

TEST(RigWords, TwoEyesAreNeededByAllModesThatShowTwo)
{
    for (const StereoMode mode : allModes)
        EXPECT_EQ(needsTwoEyes(mode),
                  mode != StereoMode::mono && mode != StereoMode::left && mode != StereoMode::right);
}

TEST(RigScene, StandsInTheRoomWithItsUpUpAndItsZTowardsTheViewer)
{
    Rig rig;
    rig.sceneCenter = {0.1, 0.5, -0.2};
    rig.sceneSize = 1.5;
    const vec3d lower(10, 20, 30), upper(14, 50, 40); // y is the longest
    const mat4d m = worldFromRoom(rig, lower, upper);
    EXPECT_LT(glm::length(transformPoint(m, rig.sceneCenter) - vec3d(12, 35, 35)), 1e-12);
    const double scale = 30.0 / 1.5;
    EXPECT_LT(glm::length(transformVector(m, {1, 0, 0}) - vec3d(scale, 0, 0)), 1e-12);
    EXPECT_LT(glm::length(transformVector(m, {0, 0, 1}) - vec3d(0, scale, 0)), 1e-12);
    EXPECT_LT(glm::length(transformVector(m, {0, 1, 0}) - vec3d(0, 0, -scale)), 1e-12);
    EXPECT_LT(glm::length(transformPoint(m, rig.sceneCenter + vec3d(0, 0, 0.75)) - vec3d(12, 50, 35)), 1e-12);
}

TEST(RigScene, NeedsDataWithAnExtent)
{
    Rig rig;
    EXPECT_NO_THROW(worldFromRoom(rig, {0, 0, 0}, {1, 0, 0}));
    EXPECT_THROW(worldFromRoom(rig, {0, 0, 0}, {0, 0, 0}), Error);
    EXPECT_THROW(worldFromRoom(rig, {1, 1, 1}, {0, 0, 0}), Error);
    EXPECT_THROW(worldFromRoom(rig, {0, 0, 0}, {1, std::numeric_limits<double>::quiet_NaN(), 1}), Error);
    rig.sceneSize = 0.0;
    EXPECT_THROW(worldFromRoom(rig, {0, 0, 0}, {1, 1, 1}), Error);
}

} // namespace
} // namespace brickwall
