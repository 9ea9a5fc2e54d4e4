// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestDisplay.h"
#include "WarpTesting.h"

#include <gtest/gtest.h>

/// Images and the scene's own geometry, in every mode, in a host that rewrites near and far while it culls.
namespace brickwall::test {
namespace {

constexpr int width = 64, height = 48;
constexpr PixelRect whole{0, 0, width, height};
const Rgb red{255, 0, 0}, green{0, 255, 0};
const vec4f opaqueGreen{0.0f, 1.0f, 0.0f, 1.0f};

std::vector<NamedMode> allModes()
{
    std::vector<NamedMode> modes = warpingModes;
    modes.push_back({"AsIs", MultiChannelDrawer::AsIs});
    return modes;
}

/// A green card 3 m away, moved a bit, with a red wall in the scene.
struct CardAndWall : WarpedRig
{
    CardAndWall(const NamedMode& mode, const osg::ref_ptr<osg::Geometry>& wall, const Card& card)
        : WarpedRig(deskRig(width, height))
    {
        computeNearAndFar();
        drawer->setMode(mode.mode);
        windows.worldScene().addChild(wall);
        render({card});
        move({0.05, 0.02, 0.0});
    }
    explicit CardAndWall(const NamedMode& mode, const osg::ref_ptr<osg::Geometry>& wall)
        : CardAndWall(mode, wall, plainCard(3.0, opaqueGreen))
    {
    }
};

/// Points leave cracks where an image is magnified; everything else has to be right.
void expectOnly(const osg::Image& picture, const PixelRect& rect, const Rgb& color, const Rgb& behind,
                const NamedMode& mode)
{
    int wrong = 0, cracks = 0;
    for (int y = rect.y; y < rect.y + rect.height; ++y) {
        for (int x = rect.x + 2; x < rect.x + rect.width - 2; ++x) {
            const Rgb found = pixel(picture, x, y);
            wrong += found != color && found != behind;
            cracks += found != color;
        }
    }
    EXPECT_EQ(wrong, 0);
    EXPECT_LE(cracks, mode.mode == MultiChannelDrawer::Reproject ? rect.width * rect.height / 10 : 0);
}

TEST(WarpScene, OpaqueGeometryInFrontHidesTheImage)
{
    BRICKWALL_NEEDS_DISPLAY();
    for (const NamedMode& mode : allModes()) {
        SCOPED_TRACE(mode.name);
        CardAndWall desk(mode, redWall(2.5, 2.5));
        expectPicture(
            *desk.drawOne(), whole, [](int, int) { return red; }, 0);
    }
}

// With near and far drawn to the wall, the image's own depth would put the card far behind it, or cut it off.
TEST(WarpScene, OpaqueGeometryBehindIsHidden)
{
    BRICKWALL_NEEDS_DISPLAY();
    for (const NamedMode& mode : allModes()) {
        for (const double distance : {3.3, 9.0, 200.0}) {
            SCOPED_TRACE(std::string(mode.name) + " " + std::to_string(distance));
            CardAndWall desk(mode, redWall(distance, distance));
            expectOnly(*desk.drawOne(), {0, 2, width, height - 4}, green, red, mode);
        }
    }
}

TEST(WarpScene, OpaqueGeometryBehindIsSeenThroughSemiTransparentPixels)
{
    BRICKWALL_NEEDS_DISPLAY();
    for (const NamedMode& mode : allModes()) {
        SCOPED_TRACE(mode.name);
        CardAndWall desk(mode, redWall(3.5, 3.5), plainCard(3.0, {0.0f, 0.0f, 0.0f, 0.5f}));
        const Rgb seenThrough = pixel(*desk.drawOne(), 32, 24);
        EXPECT_NEAR(seenThrough[0], 128, 12);
        EXPECT_LT(seenThrough[1], 64);
    }
}

TEST(WarpScene, GeometryThroughTheImageIsCutWhereTheDepthsMeet)
{
    BRICKWALL_NEEDS_DISPLAY();
    for (const NamedMode& mode : allModes()) {
        SCOPED_TRACE(mode.name);
        // The wall leans: its distance is 3 at the height of the eye, less below, more above.
        CardAndWall desk(mode, redWall(1.0, 5.0));
        desk.move({0.05, 0.0, 0.0});
        const osg::ref_ptr<osg::Image> picture = desk.drawOne();
        expectOnly(*picture, {0, 0, width, 23}, red, red, {"", MultiChannelDrawer::Reproject});
        expectOnly(*picture, {0, 25, width, 21}, green, red, mode);
    }
}

// Only the wall has bounds, so that only it counts when near and far are computed.
TEST(WarpScene, WhatIsBeforeOrBeyondTheComputedPlanesIsNotCutOff)
{
    BRICKWALL_NEEDS_DISPLAY();
    const Rgb background = pixel(*ShownRig(deskRig(width, height)).drawOne(), width - 1, 0);
    for (const NamedMode& mode : allModes()) {
        SCOPED_TRACE(mode.name);
        osg::ref_ptr<osg::Geometry> small =
            osg::createTexturedQuadGeometry(osg::Vec3(-0.1, 2.0, -0.1), osg::Vec3(0.2, 0, 0), osg::Vec3(0, 0, 0.2));
        osg::ref_ptr<osg::Vec4Array> color = new osg::Vec4Array(osg::Array::BIND_OVERALL);
        color->push_back(osg::Vec4(1, 0, 0, 1));
        small->setColorArray(color);
        small->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
        CardAndWall beyond(mode, small);
        expectOnly(*beyond.drawOne(), {2, 2, 20, height - 4}, green, background, mode);
        EXPECT_EQ(pixel(*beyond.drawOne(), 31, 23), red);
        CardAndWall before(mode, small, plainCard(1.2, opaqueGreen));
        expectOnly(*before.drawOne(), {2, 2, width - 4, height - 4}, green, background, mode);
    }
}

TEST(WarpScene, TransparentGeometryIsBlendedBeforeAndHiddenBehindTheImage)
{
    BRICKWALL_NEEDS_DISPLAY();
    for (const NamedMode& mode : allModes()) {
        for (const double distance : {2.5, 3.5}) {
            SCOPED_TRACE(std::string(mode.name) + " " + std::to_string(distance));
            const osg::ref_ptr<osg::Geometry> wall = redWall(distance, distance);
            wall->getStateSet()->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
            CardAndWall desk(mode, wall);
            const Rgb expected = distance < 3.0 ? red : green;
            expectOnly(*desk.drawOne(), {0, 2, width, height - 4}, expected, red, mode);
        }
    }
}

TEST(WarpScene, AViewWithoutDepthIsDrawnOverTheSceneAndHidesNothingThatFollows)
{
    BRICKWALL_NEEDS_DISPLAY();
    for (const MultiChannelDrawer::Mode mode : {MultiChannelDrawer::AsIs, MultiChannelDrawer::ReprojectMesh}) {
        WarpedRig desk(deskRig(width, height));
        desk.drawer->setMode(mode);
        desk.windows.worldScene().addChild(redWall(0.5, 0.5));
        const auto publishWithoutDepth = [&] {
            desk.drawer->resizeView(0, width, height, 0);
            EXPECT_EQ(desk.drawer->depth(0), nullptr);
            desk.drawer->clearDepth(0);
            std::fill_n(desk.drawer->rgba(0), width * height, opaqueGreen);
            desk.drawer->swapFrame();
        };
        publishWithoutDepth();
        expectPicture(
            *desk.drawOne(), whole, [](int, int) { return green; }, 0);
        const osg::ref_ptr<osg::Geometry> farther = redWall(9.0, 9.0);
        farther->getStateSet()->setRenderingHint(osg::StateSet::TRANSPARENT_BIN);
        desk.windows.worldScene().removeChildren(0, 1);
        desk.windows.worldScene().addChild(farther);
        expectPicture(
            *desk.drawOne(), whole, [](int, int) { return red; }, 0);
        desk.render({plainCard(3.0, opaqueGreen)}); // with depth again
        expectPicture(
            *desk.drawOne(), whole, [](int, int) { return green; }, 0);
    }
}

} // namespace
} // namespace brickwall::test
