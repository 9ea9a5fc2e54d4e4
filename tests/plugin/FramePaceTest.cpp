// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestDisplay.h"
#include "TestRigs.h"

#include "brickwall/channels/LeveredViews.h"
#include "brickwall/core/shade/Srgb.h"
#include "brickwall/plugin/FramePace.h"
#include "brickwall/plugin/RigShow.h"
#include "brickwall/plugin/RigViewer.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cmath>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace brickwall::test {
namespace {

using namespace std::chrono_literals;
using Clock = std::chrono::steady_clock;

constexpr int samplesPerPixel = 3;
const Box3d unitBox{vec3d(-1.0), vec3d(1.0)};

/// A renderer that takes its time: so long at the finest setting, less as the levers say.
struct SlowRenderer
{
    std::atomic<double> finestSeconds = 0.4;
    std::atomic<double> endlessAbove = 1.0; ///< logarithm of the levers' factor
    FrameCost cost{leversForTolerance(1.0 / 255.0)};
    std::mutex mutex;
    std::vector<FrameLevers> begun, completed;

    LeveredFrameMaker maker()
    {
        return [this](std::span<const View> views, const FrameLevers& levers, Progress& progress) {
            {
                const std::lock_guard lock(mutex);
                begun.push_back(levers);
            }
            const double factor = cost.logFactor(levers);
            const double seconds = factor > endlessAbove ? 60.0 : finestSeconds * std::exp(factor);
            const auto end = Clock::now() + std::chrono::duration<double>(seconds);
            while (Clock::now() < end) {
                progress.check();
                std::this_thread::sleep_for(1ms);
            }
            std::vector<Frame> frames;
            for (const View& view : scaledViews(views, levers))
                frames.push_back(patternFrame(view, 0));
            const std::lock_guard lock(mutex);
            completed.push_back(levers);
            return frames;
        };
    }
    std::vector<FrameLevers> takeBegun()
    {
        const std::lock_guard lock(mutex);
        return std::exchange(begun, {});
    }
    std::vector<FrameLevers> takeCompleted()
    {
        const std::lock_guard lock(mutex);
        return std::exchange(completed, {});
    }
    bool hasCompleted()
    {
        const std::lock_guard lock(mutex);
        return !completed.empty();
    }
};

/// A window on a corner, at 10 frames per second.
class FramePaceShow : public ::testing::Test
{
protected:
    void SetUp() override
    {
        BRICKWALL_NEEDS_DISPLAY();
        show.emplace(rig, unitBox, pace, 1.0, false, progress);
    }
    void move(double angle) { show->navigation().rotateData(vec3d(0.0, 0.0, 1.0), angle); }
    void moveFor(std::chrono::milliseconds time)
    {
        for (const auto end = Clock::now() + time; Clock::now() < end; std::this_thread::sleep_for(2ms)) {
            move(0.01);
            show->step();
        }
    }
    void restFor(std::chrono::milliseconds time)
    {
        for (const auto end = Clock::now() + time; Clock::now() < end && !pace.refined();
             std::this_thread::sleep_for(2ms))
            show->step();
    }

    SlowRenderer renderer;
    FramePace pace{renderer.maker(), renderer.cost.table(), 10.0, {}, samplesPerPixel};
    Progress progress;
    const Rig rig = cornerRig(48, 48);
    std::optional<RigShow> show;
};

TEST_F(FramePaceShow, WhatMovesIsHeldAndWhatRestsIsRefinedAndThenCostsNothing)
{
    moveFor(3s);
    const double held = renderer.finestSeconds * std::exp(renderer.cost.logFactor(renderer.takeCompleted().back()));
    EXPECT_NEAR(held, 0.1, 0.04);
    EXPECT_FALSE(pace.refined());

    restFor(20s);
    EXPECT_TRUE(pace.refined());
    const std::vector<FrameLevers> refinements = renderer.takeCompleted();
    EXPECT_LE(refinements.size(), 4u + samplesPerPixel);
    EXPECT_EQ(std::count(refinements.begin(), refinements.end(), renderer.cost.finest()), samplesPerPixel);
    for (std::size_t i = 1; i < refinements.size(); ++i)
        EXPECT_GE(renderer.cost.logFactor(refinements[i]), renderer.cost.logFactor(refinements[i - 1]));
    EXPECT_NE(pace.status().find("3 samples per pixel"), std::string::npos) << pace.status();

    renderer.takeBegun();
    for (int i = 0; i < 50; ++i, std::this_thread::sleep_for(2ms))
        show->step();
    EXPECT_TRUE(renderer.takeBegun().empty());
}

TEST_F(FramePaceShow, AMovementBreaksARefinementOffAndIsAnsweredAsAccuratelyAsBefore)
{
    moveFor(2s);
    while (!pace.refined())
        show->step();
    moveFor(300ms);
    const FrameLevers moving = renderer.takeCompleted().back();
    renderer.endlessAbove = renderer.cost.logFactor(moving) + 1e-9; // nobody waits for what rests
    renderer.takeBegun();
    const auto refines = [&] {
        const std::lock_guard lock(renderer.mutex);
        return !renderer.begun.empty() &&
               renderer.cost.logFactor(renderer.begun.back()) > renderer.cost.logFactor(moving);
    };
    while (!refines())
        show->step();
    renderer.takeCompleted();
    const auto start = Clock::now();
    move(0.3);
    while (!renderer.hasCompleted() && Clock::now() - start < 20s)
        show->step();
    EXPECT_LT(Clock::now() - start, 10s) << "it was waited for";
    EXPECT_EQ(renderer.takeCompleted().front(), moving);
}

TEST(FramePace, WhatRestsIsTheMeanOfAllItsSamplesAndAnotherPoseHasNothingOfIt)
{
    std::vector<View> asked;
    const LeveredFrameMaker make = [&](std::span<const View> views, const FrameLevers&, Progress&) {
        asked.assign(views.begin(), views.end());
        std::vector<Frame> frames{emptyFrame(views[0])};
        std::fill(frames[0].color.begin(), frames[0].color.end(), vec4f(float(views[0].lowerLeft.x)));
        return frames;
    };
    View view = viewOfCamera("view", {0.0, 0.0, 5.0}, {0.0, 0.0, 0.0}, {0.0, 1.0, 0.0}, 40.0, 4, 4, 1.0, 10.0);
    Progress progress;
    FramePace pace(make, leversForTolerance(1.0 / 255.0), 20.0, {}, samplesPerPixel);
    pace.moving()({&view, 1}, progress);
    EXPECT_FALSE(pace.refined());
    double sum = 0.0;
    for (int n = 1; n <= samplesPerPixel; ++n) {
        const std::vector<Frame> frames = pace.resting()({&view, 1}, progress);
        sum += asked[0].lowerLeft.x;
        EXPECT_NEAR(frames[0].color[0].r, sum / n, 1e-6);
        EXPECT_EQ(frames[0].view.lowerLeft, view.lowerLeft) << "it is shown as the frame of the view itself";
        EXPECT_EQ(pace.refined(), n == samplesPerPixel);
    }
    for (vec3d* corner : {&view.lowerLeft, &view.lowerRight, &view.upperRight})
        corner->x += 0.5;
    EXPECT_NEAR(pace.resting()({&view, 1}, progress)[0].color[0].r, view.lowerLeft.x, 1e-6);
    EXPECT_FALSE(pace.refined());
    pace.moving()({&view, 1}, progress);
    EXPECT_NEAR(pace.resting()({&view, 1}, progress)[0].color[0].r, view.lowerLeft.x, 1e-6) << "it has moved";
}

TEST(FramePace, OffRendersEverythingAsTheUserWants)
{
    SlowRenderer renderer;
    renderer.finestSeconds = 0.05;
    FramePace pace(renderer.maker(), renderer.cost.table(), std::nullopt);
    Progress progress;
    for (int i = 0; i < 10; ++i)
        pace.moving()({}, progress);
    for (const FrameLevers& levers : renderer.takeCompleted())
        EXPECT_EQ(levers, renderer.cost.finest());
    EXPECT_TRUE(pace.refined());
    EXPECT_EQ(pace.status(), "");
    pace.setFps(100.0);
    EXPECT_EQ(pace.fps(), 60.0);
    pace.setFps(1.0);
    EXPECT_EQ(pace.fps(), 5.0);
    EXPECT_NE(pace.status(), "");
}

/// Mean of the picture as displayed over black, in steps of 1/255.
double brightnessOf(const Frame& frame)
{
    double sum = 0.0;
    for (const vec4f& color : frame.color)
        for (int c = 0; c < 3; ++c)
            sum += 255.0 * srgbFromLinear(std::clamp(color[c], 0.0f, 1.0f));
    return sum / (3.0 * double(frame.color.size()));
}

TEST(FramePace, RefiningChangesTheBrightnessOfThePictureByNoVisibleStep)
{
    const auto bricks = cubeOfBricks(vec3i(0), 16, 8);
    const auto waves = [](const vec3d& p) {
        return 1.0 + std::sin(0.9 * p.x) * std::sin(0.7 * p.y) * std::cos(0.5 * p.z);
    };
    const Scene scene = sceneOf(numbered(bricks), fieldOf(bricks, waves), colorful({0.0f, 2.0f}));
    // Of smaller pictures an eighth has so few pixels that their mean is off by more (112 x 112: 1.3).
    const View view =
        viewOfCamera("view", {8.0, 9.0, 40.0}, {8.0, 8.0, 8.0}, {0.0, 1.0, 0.0}, 40.0, 224, 224, 1.0, 100.0);
    for (const Method method : {Method::bounded, Method::midpoint}) {
        RenderSettings settings;
        settings.method = method;
        std::vector<double> brightness;
        const FrameCost slowMachine(leversOf(settings)); // the same one whatever this one does
        const LeveredFrameMaker make = [&](std::span<const View> views, const FrameLevers& levers, Progress&) {
            std::vector<Frame> frames{renderOne(scene, scaledViews(views, levers)[0], withLevers(settings, levers))};
            brightness.push_back(brightnessOf(frames[0]));
            if (brightness.size() < 4)
                std::this_thread::sleep_for(800ms * std::exp(slowMachine.logFactor(levers)));
            return frames;
        };
        Progress progress;
        FramePace pace(make, leversOf(settings), 60.0);
        for (int i = 0; i < 3; ++i)
            pace.moving()({&view, 1}, progress);
        while (!pace.refined())
            pace.resting()({&view, 1}, progress);
        EXPECT_GE(brightness.size(), 5u) << "three that move, and some that are refined";
        EXPECT_GT(brightness[0], 5.0);
        for (std::size_t i = 3; i < brightness.size(); ++i)
            EXPECT_NEAR(brightness[i], brightness[i - 1], 1.0) << methodNames[std::size_t(method)] << ", step " << i;
    }
}

struct Centroid
{
    double x = 0.0, y = 0.0;
};

Centroid centroidOf(const osg::Image& image)
{
    Centroid c;
    double sum = 0.0;
    for (int y = 0; y < image.t(); ++y)
        for (int x = 0; x < image.s(); ++x) {
            const Rgb p = pixel(image, x, y);
            const double weight = p[0] + p[1] + p[2];
            c.x += weight * x;
            c.y += weight * y;
            sum += weight;
        }
    return {c.x / sum, c.y / sum};
}

/// A ball off the centre in every direction.
Scene ballAside()
{
    const auto bricks = cubeOfBricks(vec3i(0), 32, 8);
    const auto distance = [](const vec3d& voxel) { return glm::length(voxel - vec3d(10.0, 21.0, 16.0)); };
    TransferFunction nothing = colorful({0.0f, 28.0f});
    nothing.opacityScale = 0.0f;
    Scene scene = sceneOf(numbered(bricks), fieldOf(bricks, distance), nothing);
    scene.surfaces = {{8.0f, vec3f(1.0f, 0.8f, 0.3f), 1.0f}};
    return scene;
}

TEST(FramePace, AtEveryImageScaleThePictureIsUprightAndInItsPlace)
{
    BRICKWALL_NEEDS_DISPLAY();
    const Scene scene = ballAside();
    const Rig rig = deskRig(96, 96);
    Progress progress;
    int eighths = 8;
    const FrameMaker make = [&](std::span<const View> views, Progress&) {
        std::vector<Frame> frames;
        for (const View& view : views)
            frames.push_back(renderOne(scene, scaledView(view, eighths), RenderSettings{}));
        return frames;
    };
    RigShow show(rig, worldBounds(scene), make, 1.0, false, progress);
    show.drawCompleted();
    const Centroid full = centroidOf(*show.pictures().at(0).left);
    EXPECT_GT(std::hypot(full.x - 47.5, full.y - 47.5), 4.0) << "a mirrored picture would be elsewhere";
    for (eighths = 2; eighths < 8; ++eighths) {
        show.navigation().rotateData(vec3d(0.0, 0.0, 1.0), 0.0); // a new stamp
        show.drawCompleted();
        const Centroid fewer = centroidOf(*show.pictures().at(0).left);
        EXPECT_NEAR(fewer.x, full.x, 0.7) << eighths << "/8";
        EXPECT_NEAR(fewer.y, full.y, 0.7) << eighths << "/8";
    }
}

} // namespace
} // namespace brickwall::test
