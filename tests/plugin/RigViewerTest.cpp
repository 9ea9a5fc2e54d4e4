// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestDisplay.h"
#include "TestRigs.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/render/ImageFiles.h"
#include "brickwall/plugin/RigViewer.h"
#include "brickwall/tests/common/ErrorOf.h"
#include "brickwall/tests/common/ScratchFolder.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <glm/gtc/matrix_transform.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <optional>
#include <thread>

namespace brickwall::test {
namespace {

namespace fs = std::filesystem;
const Box3d unitBox{vec3d(-1.0), vec3d(1.0)};

struct Notes : Progress
{
    std::vector<std::string> lines;
    void note(std::string_view line) override { lines.emplace_back(line); }
};

/// As `render` would have written it, but for the rounding of blending in 8 bits.
void expectSame(const Image& found, const Image& expected)
{
    ASSERT_EQ(found.width, expected.width);
    ASSERT_EQ(found.height, expected.height);
    int largest = 0;
    for (std::size_t i = 0; i < expected.rgba.size(); ++i)
        largest = std::max(largest, std::abs(int(found.rgba[i]) - int(expected.rgba[i])));
    EXPECT_LE(largest, 2);
}

TEST(RigViewer, AFlightMovesTheDataAndEndsWithAPictureOfItsLastPlace)
{
    BRICKWALL_NEEDS_DISPLAY();
    const std::string folder = scratchFile("landed");
    const auto bricks = cubeOfBricks(vec3i(0), 16, 8);
    const Scene scene =
        sceneOf(numbered(bricks), fieldOf(bricks, [](const vec3d& p) { return p.x; }), colorful({0.0f, 16.0f}));
    const Rig rig = deskRig(240, 240);
    const mat4d first = glm::inverse(worldFromRoom(rig, vec3d(0.0), vec3d(16.0)));
    const mat4d last = first * glm::rotate(mat4d(1.0), 1.0, vec3d(0.0, 0.0, 1.0));
    ViewerOptions options;
    options.frames = 1;
    options.screenshotFolder = folder;
    options.fps = 20.0;
    int asked = 0;
    options.flight = [&, landed = false](double seconds) mutable -> std::optional<mat4d> {
        ++asked;
        if (landed)
            return std::nullopt;
        landed = seconds >= 0.4;
        return landed ? last : first * glm::rotate(mat4d(1.0), seconds, vec3d(0.0, 0.0, 1.0));
    };
    Progress silent;
    viewScene(scene, rig, {}, options, silent);
    EXPECT_GT(asked, 2);

    const Executor executor(1);
    const View view = viewsOfRig(rig, glm::inverse(last)).views.at(0).view;
    const Image expected = imageOver(Renderer(scene, executor).render({&view, 1}, {}, silent).front(), rig.background);
    const Image found = readPng(folder + "/main.png");
    ASSERT_EQ(found.rgba.size(), expected.rgba.size());
    int halves[2] = {0, 0}; // one of them has the text about the frame rate
    for (std::size_t i = 0; i < expected.rgba.size(); ++i) {
        int& largest = halves[2 * i / expected.rgba.size()];
        largest = std::max(largest, std::abs(int(found.rgba[i]) - int(expected.rgba[i])));
    }
    EXPECT_LE(std::min(halves[0], halves[1]), 2)
        << "as accurate as the user wants it, and nothing of a frame that moved";
}

TEST(RigViewer, WritesAPictureOfEveryWindow)
{
    BRICKWALL_NEEDS_DISPLAY();
    const std::string folder = scratchFile("pictures");
    for (const bool drawThreads : {false, true}) {
        const Rig rig = cornerRig(80, 60);
        ViewerOptions options;
        options.frames = 2;
        options.screenshotFolder = folder;
        options.windowScale = 0.5;
        options.drawThreads = drawThreads;
        Progress silent;
        runRigViewer(rig, unitBox, patternFrames, options, silent);
        for (int i = 0; i < 2; ++i) {
            const Image picture = readPng(folder + (i == 0 ? "/main.png" : "/side.png"));
            View view;
            view.window = {0, 0, 40, 30};
            expectSame(picture, imageOver(patternFrame(view, i), rig.background));
        }
        fs::remove_all(folder);
    }
}

TEST(RigViewer, LeavesOutChannelsWithoutAWindow)
{
    BRICKWALL_NEEDS_DISPLAY();
    const std::string folder = scratchFile("pictures");
    Rig rig = deskRig(40, 30);
    rig.channels.insert(rig.channels.begin(), rig.channels.front());
    rig.channels.front().name = "unseen";
    rig.channels.front().window = -1;
    ViewerOptions options;
    options.frames = 1;
    options.screenshotFolder = folder;
    Progress silent;
    runRigViewer(rig, unitBox, patternFrames, options, silent);
    EXPECT_EQ(std::distance(fs::directory_iterator(folder), {}), 1);
    fs::remove_all(folder);

    rig.channels.resize(1);
    EXPECT_THROW(runRigViewer(rig, unitBox, patternFrames, options, silent), Error);
}

TEST(RigViewer, ShowsASceneAsTheRendererMakesIt)
{
    BRICKWALL_NEEDS_DISPLAY();
    const auto bricks = threeLevels(3);
    const Scene scene = sceneOf(bricks, fieldOf(bricks, waves), colorful({-1.0f, 1.0f}));
    const Rig rig = cornerRig(64, 64);
    const std::string folder = scratchFile("scene");
    ViewerOptions options;
    options.frames = 1;
    options.screenshotFolder = folder;
    Progress silent;
    viewScene(scene, rig, RenderSettings{}, options, silent);

    const Box3d bounds = worldBounds(scene);
    EXPECT_EQ(bounds, (Box3d{vec3d(0.0), vec3d(32.0)}));
    const RigViews views = viewsOfRig(rig, worldFromRoom(rig, bounds.lower, bounds.upper));
    ASSERT_EQ(views.views.size(), 2u);
    for (int i = 0; i < 2; ++i) {
        const Frame frame = renderOne(scene, views.views[i].view, RenderSettings{});
        const bool seen =
            std::any_of(frame.color.begin(), frame.color.end(), [](const vec4f& c) { return c.a > 0.1f; });
        EXPECT_TRUE(seen);
        expectSame(readPng(folder + (i == 0 ? "/main.png" : "/side.png")), imageOver(frame, rig.background));
    }
    fs::remove_all(folder);
}

TEST(RigViewer, NotesARefusedViewOnceAndShowsTheOthers)
{
    BRICKWALL_NEEDS_DISPLAY();
    Rig rig = cornerRig(40, 30);
    rig.viewers[0].roomFromHead[3] = vec4d(-1.5, 0.0, 0.0, 1.0); // behind the left screen
    ViewerOptions options;
    options.frames = 3;
    Notes notes;
    std::size_t viewsRendered = 0;
    const FrameMaker make = [&](std::span<const View> views, Progress& progress) {
        viewsRendered += views.size();
        return patternFrames(views, progress);
    };
    runRigViewer(rig, unitBox, make, options, notes);
    ASSERT_EQ(notes.lines.size(), 1u);
    EXPECT_EQ(notes.lines[0].rfind("left stays black: ", 0), 0u) << notes.lines[0];
    EXPECT_EQ(viewsRendered, 1u) << "nothing changed, so one rendering serves all frames";
}

TEST(RigViewer, EndsWhenItIsCancelledWhileAFrameIsRendered)
{
    BRICKWALL_NEEDS_DISPLAY();
    for (const int frames : {0, 5}) {
        Progress progress;
        const FrameMaker neverDone = [&](std::span<const View>, Progress& rendering) -> std::vector<Frame> {
            progress.cancel();
            for (;;) {
                rendering.check();
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
        };
        ViewerOptions options;
        options.frames = frames;
        EXPECT_THROW(runRigViewer(deskRig(32, 32), unitBox, neverDone, options, progress), Cancelled);
    }
}

TEST(RigViewer, TakesNextToNoTimeWhileNothingChanges)
{
    BRICKWALL_NEEDS_DISPLAY();
    Progress progress;
    double seconds = 0.0; // of all cores together
    std::thread watcher([&] {
        const auto used = [] { return double(std::clock()) / CLOCKS_PER_SEC; };
        std::this_thread::sleep_for(std::chrono::seconds(3));
        const double before = used();
        std::this_thread::sleep_for(std::chrono::seconds(5));
        seconds = used() - before;
        progress.cancel();
    });
    EXPECT_THROW(runRigViewer(cornerRig(64, 64), unitBox, patternFrames, {}, progress), Cancelled);
    watcher.join();
    EXPECT_LT(seconds, 0.02 * 5.0);
    RecordProperty("percent", std::to_string(100.0 * seconds / 5.0));
}

TEST(RigViewer, HandsOnWhatRenderingThrows)
{
    BRICKWALL_NEEDS_DISPLAY();
    const FrameMaker broken = [](std::span<const View>, Progress&) -> std::vector<Frame> {
        throw Error("here", "broken");
    };
    Progress silent;
    EXPECT_EQ(errorOf([&] { runRigViewer(deskRig(32, 32), unitBox, broken, {}, silent); }), "here: broken");
}

TEST(RigViewer, SaysInOneLineThatThereIsNoDisplay)
{
    const char* current = std::getenv("DISPLAY");
    const std::string saved = current ? current : "";
    unsetenv("DISPLAY");
    Progress silent;
    const auto run = [&] { runRigViewer(deskRig(32, 32), unitBox, patternFrames, {}, silent); };
    const std::string unset = errorOf(run);
    setenv("DISPLAY", ":9876", 1);
    const std::string absent = errorOf(run);
    saved.empty() ? unsetenv("DISPLAY") : setenv("DISPLAY", saved.c_str(), 1);
    EXPECT_EQ(unset.rfind("DISPLAY: is not set", 0), 0u) << unset;
    EXPECT_EQ(absent.rfind("DISPLAY: cannot open the X display ':9876' for window 'main'", 0), 0u) << absent;
    EXPECT_EQ(absent.find('\n'), std::string::npos);
}

TEST(RigViewer, RefusesOptionsThatMakeNoSense)
{
    Progress silent;
    ViewerOptions pictures;
    pictures.screenshotFolder = "somewhere";
    EXPECT_THROW(runRigViewer(deskRig(8, 8), unitBox, patternFrames, pictures, silent), Error);
    ViewerOptions scale;
    scale.windowScale = 0.0;
    EXPECT_THROW(runRigViewer(deskRig(8, 8), unitBox, patternFrames, scale, silent), Error);
    EXPECT_THROW(worldBounds(Scene{}), Error);
}

} // namespace
} // namespace brickwall::test
