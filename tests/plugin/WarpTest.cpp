// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestDisplay.h"
#include "WarpTesting.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <random>

namespace brickwall::test {
namespace {

constexpr int width = 64, height = 48;
const vec3f background = deskRig(1, 1).background;
const vec4f half(0.5f); ///< white with opacity 1/2

Rgb shown(const vec4f& color)
{
    Frame one;
    one.width = one.height = 1;
    one.color = {color};
    return composed(one, 0, 0, background);
}

bool near(const Rgb& a, const Rgb& b, int tolerance = 2)
{
    for (int i = 0; i < 3; ++i) {
        if (std::abs(a[i] - b[i]) > tolerance)
            return false;
    }
    return true;
}

Frame withRandomDepth(Frame frame)
{
    std::mt19937 random(1);
    for (std::size_t i = 0; i < frame.depth.size(); ++i)
        frame.depth[i] = frame.color[i].a > 0.0f ? std::uniform_real_distribution(0.3f, 0.99f)(random) : 1.0f;
    return frame;
}

// COVISE's drawer shows images whose row 0 is at the bottom upside down and one row off when it reprojects.
TEST(Warp, WithoutMotionEveryModeShowsWhatAsIsShowsInBothOrientations)
{
    BRICKWALL_NEEDS_DISPLAY();
    for (const bool flipped : {false, true}) {
        WarpedRig desk(deskRig(width, height), flipped);
        desk.drawer->setViewsToRender(MultiChannelDrawer::MatchingEye); // a view alone would be drawn as is
        desk.publish(0, withRandomDepth(patternFrame(desk.views.views[0].view, 0)));
        desk.drawer->setMode(MultiChannelDrawer::AsIs);
        const osg::ref_ptr<osg::Image> asIs = desk.drawOne();
        expectPicture(*asIs, {0, 0, width, height},
                      [&](int x, int y) { return composed(desk.frames[0], x, y, background); });
        for (const auto& [name, mode] : warpingModes) {
            SCOPED_TRACE(name);
            desk.drawer->setMode(mode);
            expectPicture(
                *desk.drawOne(), {0, 0, width, height}, [&](int x, int y) { return pixel(*asIs, x, y); }, 1);
        }
    }
}

TEST(Warp, AMovedEyeSeesASmoothSurfaceWhereItIs)
{
    BRICKWALL_NEEDS_DISPLAY();
    for (const bool flipped : {false, true}) {
        WarpedRig desk(deskRig(width, height), flipped);
        for (const auto& [name, mode] : warpingModes) {
            for (const vec3d& head : {vec3d(0.2, 0.0, 0.0), vec3d(0.0, 0.0, -0.15), vec3d(0.1, 0.1, 0.05)}) {
                SCOPED_TRACE(std::string(name) + " " + std::to_string(head.x) + " " + std::to_string(head.z));
                desk.move(vec3d(0.0));
                desk.render({gradientCard(2.0)});
                desk.drawer->setMode(mode);
                desk.move(head);
                const Frame truth = frameOf(desk.views.views[0].view, {gradientCard(2.0)});
                const Difference d = differenceOf(
                    *desk.drawOne(), [&](int x, int y) { return composed(truth, x, y, background); }, 8);
                EXPECT_LT(std::abs(d.meanSigned), 1.5) << "one pixel off would be 4 to 5";
                EXPECT_LT(d.mean, 3.0);
            }
        }
    }
}

TEST(Warp, FollowsDataThatMove)
{
    BRICKWALL_NEEDS_DISPLAY();
    WarpedRig desk(deskRig(width, height));
    desk.drawer->setMode(MultiChannelDrawer::ReprojectMesh);
    desk.move(vec3d(0.05, 0.0, 0.0), vec3d(0.0, 0.1, 0.0));
    desk.render({gradientCard(2.0)});
    desk.move(vec3d(0.05, 0.0, 0.0), vec3d(0.3, 0.2, -0.1));
    const Frame truth = frameOf(desk.views.views[0].view, {gradientCard(2.0)});
    const Difference d = differenceOf(
        *desk.drawOne(), [&](int x, int y) { return composed(truth, x, y, background); }, 12);
    EXPECT_LT(std::abs(d.meanSigned), 1.0);
    EXPECT_LT(d.mean, 2.0);
}

TEST(Warp, TakesThePoseOfTheDrawAndNotThatOfUpdate)
{
    BRICKWALL_NEEDS_DISPLAY();
    WarpedRig desk(deskRig(width, height));
    desk.drawer->setMode(MultiChannelDrawer::ReprojectMesh);
    desk.render({gradientCard(2.0)});
    desk.rig.viewers[0].roomFromHead[3] = vec4d(0.2, 0.0, 0.0, 1.0);
    desk.windows.show(viewsOfRig(desk.rig, mat4d(1.0)), mat4d(1.0)); // without an update() of the drawer
    const Frame truth = frameOf(viewsOfRig(desk.rig, mat4d(1.0)).views[0].view, {gradientCard(2.0)});
    const Difference d = differenceOf(
        *desk.drawOne(), [&](int x, int y) { return composed(truth, x, y, background); }, 8);
    EXPECT_LT(std::abs(d.meanSigned), 1.0);
}

// On a fixed screen only the place of the eye matters.
TEST(Warp, TurningTheHeadAboutTheEyeChangesNothingInAnyMode)
{
    BRICKWALL_NEEDS_DISPLAY();
    Rig rig = deskRig(width, height, StereoMode::left);
    const vec3d eye = rig.viewers[0].leftEye;
    WarpedRig desk(rig);
    desk.publish(0, withRandomDepth(patternFrame(desk.views.views[0].view, 0)));
    std::vector<NamedMode> modes = warpingModes;
    modes.push_back({"AsIs", MultiChannelDrawer::AsIs});
    for (const auto& [name, mode] : modes) {
        SCOPED_TRACE(name);
        desk.drawer->setMode(mode);
        desk.rig.viewers[0].roomFromHead = mat4d(1.0);
        desk.move(vec3d(0.0));
        const osg::ref_ptr<osg::Image> before = desk.drawOne();
        const mat4d turn = glm::rotate(mat4d(1.0), 0.7, vec3d(0.3, 0.2, 1.0));
        desk.rig.viewers[0].roomFromHead = turn;
        desk.move(eye - vec3d(turn * vec4d(eye, 0.0)));
        expectPicture(
            *desk.drawOne(), {0, 0, width, height}, [&](int x, int y) { return pixel(*before, x, y); }, 1);
    }
}

TEST(Warp, BackgroundIsNeverDrawnOverTheScene)
{
    BRICKWALL_NEEDS_DISPLAY();
    WarpedRig desk(deskRig(width, height));
    for (const auto& [name, mode] : warpingModes) {
        SCOPED_TRACE(name);
        desk.drawer->setMode(mode);
        desk.move(vec3d(0.0));
        desk.render({});
        Frame invisible = desk.frames[0];
        std::fill(invisible.depth.begin(), invisible.depth.end(), 0.5f); // whatever its depth
        for (const Frame& frame : {desk.frames[0], invisible}) {
            desk.move(vec3d(0.0));
            desk.publish(0, frame);
            desk.move(vec3d(0.2, 0.3, -0.1));
            EXPECT_EQ(shareOf(*desk.drawOne(), [](const Rgb& c) { return near(c, shown(vec4f(0.0f)), 0); }), 1.0);
        }
    }
}

TEST(Warp, OfPixelsThatLandOnOneTheNearestIsSeen)
{
    BRICKWALL_NEEDS_DISPLAY();
    Card front = plainCard(1.5, {0.0f, 1.0f, 0.0f, 1.0f});
    front.upperX = 0.0;
    const Card back = plainCard(4.0, {1.0f, 0.0f, 0.0f, 1.0f});
    WarpedRig desk(deskRig(width, height));
    for (const auto& [name, mode] : warpingModes) {
        for (const double x : {-0.3, 0.3}) {
            SCOPED_TRACE(std::string(name) + (x < 0.0 ? ", to the left" : ", to the right"));
            desk.drawer->setMode(mode);
            desk.move(vec3d(0.0));
            desk.render({front, back});
            desk.move(vec3d(x, 0.0, 0.0));
            const Frame truth = frameOf(desk.views.views[0].view, {front, back});
            const osg::ref_ptr<osg::Image> picture = desk.drawOne();
            int wrong = 0, ofFront = 0;
            for (int row = 4; row < height - 4; ++row) {
                for (int column = 4; column < width - 8; ++column) {
                    if (truth.color[truth.index(column, row)].g < 0.5f ||
                        truth.color[truth.index(column + 1, row)].g < 0.5f)
                        continue; // the edge itself
                    ++ofFront;
                    wrong += pixel(*picture, column, row)[1] < 250;
                }
            }
            EXPECT_GT(ofFront, 500);
            EXPECT_LE(wrong, mode == MultiChannelDrawer::Reproject ? ofFront / 20 : 0);
        }
    }
}

// Blending both would make them too bright. Cards of one depth meet in the same bits of depth.
TEST(Warp, SemiTransparentPixelsThatLandOnOneAreNotAddedUp)
{
    BRICKWALL_NEEDS_DISPLAY();
    const Rgb once = shown(half), nothing = shown(vec4f(0.0f));
    Card front = plainCard(1.5, half);
    front.upperX = 0.0;
    WarpedRig desk(deskRig(width, height));
    for (const auto& [name, mode] : warpingModes) {
        for (const vec3d& head : {vec3d(-0.3, 0.0, 0.0), vec3d(0.3, 0.0, 0.0), vec3d(0.0, -0.5, 0.0),
                                  vec3d(0.0, 0.3, 0.0), vec3d(0.11, -0.2, 0.07)}) {
            for (const bool onlyOne : {false, true}) {
                SCOPED_TRACE(std::string(name) + (onlyOne ? ", one card, " : ", two cards, ") + std::to_string(head.x) +
                             " " + std::to_string(head.y));
                desk.drawer->setMode(mode);
                desk.move(vec3d(0.0));
                const Card back = plainCard(3.0, half);
                desk.render(onlyOne ? std::vector{back} : std::vector{front, back});
                desk.move(head);
                const osg::ref_ptr<osg::Image> picture = desk.drawOne();
                EXPECT_EQ(shareOf(*picture, [&](const Rgb& c) { return near(c, once) || near(c, nothing); }), 1.0);
                EXPECT_GT(shareOf(
                              *picture, [&](const Rgb& c) { return near(c, once); }, 12),
                          mode == MultiChannelDrawer::Reproject ? 0.5
                          : onlyOne                             ? 1.0 - 1e-9
                                                                : 0.85);
            }
        }
    }
}

TEST(Warp, AViewOfAnotherSizeThanItsViewportHasNoHoles)
{
    BRICKWALL_NEEDS_DISPLAY();
    WarpedRig desk(deskRig(width, height));
    desk.drawer->setViewsToRender(MultiChannelDrawer::MatchingEye);
    for (const PixelRect& size : {PixelRect{0, 0, 32, 24}, {0, 0, 21, 17}, {0, 0, 96, 64}}) {
        View view = desk.views.views[0].view;
        view.window = size;
        view.screenWidth = size.width;
        view.screenHeight = size.height;
        for (const auto& [name, mode] : warpingModes) {
            SCOPED_TRACE(std::string(name) + " " + std::to_string(size.width));
            desk.drawer->setMode(mode);
            desk.move(vec3d(0.0));
            desk.publish(0, frameOf(view, {plainCard(2.0, half)}));
            EXPECT_EQ(shareOf(*desk.drawOne(), [](const Rgb& c) { return near(c, shown(half)); }), 1.0);
            desk.publish(0, frameOf(view, {gradientCard(2.0)}));
            desk.move(vec3d(0.1, 0.0, 0.05));
            const Frame truth = frameOf(desk.views.views[0].view, {gradientCard(2.0)});
            const Difference d = differenceOf(
                *desk.drawOne(), [&](int x, int y) { return composed(truth, x, y, background); }, 6);
            EXPECT_LT(std::abs(d.meanSigned), 3.0) << "of this view's pixels, 12 apart";
        }
    }
}

TEST(Warp, StretchedPartsAreHolesOnlyInTheModeForThat)
{
    BRICKWALL_NEEDS_DISPLAY();
    Card front = plainCard(0.6, {0.0f, 1.0f, 0.0f, 1.0f});
    front.upperX = 0.0;
    const Card back = plainCard(8.0, {1.0f, 0.0f, 0.0f, 1.0f});
    WarpedRig desk(deskRig(width, height));
    desk.render({front, back});
    desk.move(vec3d(0.5, 0.0, 0.0)); // the front card's edge moves by 22 pixels against the back one
    const auto isBackground = [](const Rgb& c) { return near(c, shown(vec4f(0.0f)), 0); };
    const auto holes = [&](MultiChannelDrawer::Mode mode) {
        desk.drawer->setMode(mode);
        return shareOf(*desk.drawOne(), isBackground);
    };
    const double filled = holes(MultiChannelDrawer::ReprojectMesh);
    EXPECT_GT(holes(MultiChannelDrawer::ReprojectMeshWithHoles), filled + 0.15);
    EXPECT_GT(holes(MultiChannelDrawer::Reproject), filled + 0.15);
}

// An image without matrices has nothing to be reprojected from.
TEST(Warp, AnImageWhoseMatricesWereNeverGivenIsShownAsIs)
{
    BRICKWALL_NEEDS_DISPLAY();
    ShownRig shown(deskRig(width, height)); // gives none
    shown.windows.drawer().setMode(MultiChannelDrawer::ReprojectMesh);
    expectPicture(*shown.drawOne(), {0, 0, width, height},
                  [&](int x, int y) { return composed(shown.frames[0], x, y, background); });
}

} // namespace
} // namespace brickwall::test
