// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestDisplay.h"
#include "TestRigs.h"

#include "brickwall/plugin/RigShow.h"
#include "brickwall/plugin/RigViewer.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <thread>

namespace brickwall::test {
namespace {

using namespace std::chrono_literals;

/// An opaque ball: each pixel has one depth, so that reprojection has what it needs.
Scene ball()
{
    const auto bricks = cubeOfBricks(vec3i(0), 32, 8);
    const auto distance = [](const vec3d& voxel) { return glm::length(voxel - vec3d(16.0)); };
    TransferFunction nothing = colorful({0.0f, 28.0f});
    nothing.opacityScale = 0.0f;
    Scene scene = sceneOf(numbered(bricks), fieldOf(bricks, distance), nothing);
    scene.surfaces = {{12.0f, vec3f(1.0f, 0.8f, 0.3f), 1.0f}};
    return scene;
}

/// A renderer that is let do its work when the test says so.
struct HeldRenderer
{
    Scene scene = ball();
    std::atomic<bool> held = false;
    FrameMaker makeFrames = [this](std::span<const View> views, Progress& progress) {
        while (held) {
            progress.check();
            std::this_thread::sleep_for(1ms);
        }
        std::vector<Frame> frames;
        for (const View& view : views)
            frames.push_back(renderOne(scene, view, RenderSettings{}));
        return frames;
    };
};

osg::ref_ptr<osg::Image> pictureOf(RigShow& show)
{
    return show.pictures().at(0).left;
}

/// Root of the mean square over all pixels and components, in steps of 1/255.
double rootMeanSquare(const osg::Image& a, const osg::Image& b)
{
    double sum = 0.0;
    for (int y = 0; y < a.t(); ++y)
        for (int x = 0; x < a.s(); ++x) {
            const Rgb p = pixel(a, x, y), q = pixel(b, x, y);
            for (int c = 0; c < 3; ++c)
                sum += double(p[c] - q[c]) * (p[c] - q[c]);
        }
    return std::sqrt(sum / (3.0 * a.s() * a.t()));
}

TEST(RigShow, AMovedHeadIsSeenWhileTheRendererIsBusy)
{
    BRICKWALL_NEEDS_DISPLAY();
    HeldRenderer renderer;
    Rig rig = deskRig(96, 96);
    rig.sceneSize = 1.0;      // all of the ball stays in sight
    rig.sceneCenter.y += 1.0; // beyond the screen, on which it moves by 7 pixels with the head
    Progress progress;
    RigShow show(rig, worldBounds(renderer.scene), renderer.makeFrames, 1.0, false, progress);
    show.drawCompleted();
    const auto before = pictureOf(show);

    renderer.held = true;
    show.navigation().moveHeads(vec3d(0.3, 0.0, 0.0));
    EXPECT_TRUE(show.step());
    const auto reprojected = pictureOf(show);
    renderer.held = false;
    show.drawCompleted();
    const auto rendered = pictureOf(show);

    const double unmoved = rootMeanSquare(*before, *rendered), moved = rootMeanSquare(*reprojected, *rendered);
    RecordProperty("unmoved", std::to_string(unmoved));
    RecordProperty("moved", std::to_string(moved));
    EXPECT_GT(unmoved, 1.0);
    EXPECT_LT(moved, 0.5 * unmoved);
}

TEST(RigShow, ATurnedHeadChangesNothingOnAFixedScreen)
{
    BRICKWALL_NEEDS_DISPLAY();
    HeldRenderer renderer;
    const Rig rig = deskRig(64, 64); // mono: the eye is where the head turns
    Progress progress;
    RigShow show(rig, worldBounds(renderer.scene), renderer.makeFrames, 1.0, false, progress);
    show.drawCompleted();
    const auto before = pictureOf(show);
    renderer.held = true;
    show.navigation().turnHeads(0.5, 0.2);
    show.step();
    EXPECT_LE(rootMeanSquare(*before, *pictureOf(show)), 0.1);
    renderer.held = false;
}

TEST(RigShow, DrawsNothingWhileNothingChanges)
{
    BRICKWALL_NEEDS_DISPLAY();
    HeldRenderer renderer;
    const Rig rig = deskRig(32, 32);
    Progress progress;
    RigShow show(rig, worldBounds(renderer.scene), renderer.makeFrames, 1.0, false, progress);
    show.drawCompleted();
    int drawn = 0;
    for (int i = 0; i < 100; ++i) {
        drawn += show.step() ? 1 : 0;
        std::this_thread::sleep_for(5ms);
    }
    EXPECT_LE(drawn, 5) << "a window that appears may ask for some";
}

} // namespace
} // namespace brickwall::test
