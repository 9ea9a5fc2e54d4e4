// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/RigViewer.h"

#include "brickwall/channels/FrameWork.h"
#include "brickwall/channels/LeveredViews.h"
#include "brickwall/core/base/BoxCorners.h"
#include "brickwall/core/base/Error.h"
#include "brickwall/plugin/Pictures.h"
#include "brickwall/plugin/RigShow.h"
#include "brickwall/plugin/RoomPreview.h"

#include <chrono>
#include <optional>
#include <thread>

namespace brickwall {
namespace {

using namespace std::chrono_literals;

constexpr int samplesAtRest = 17; ///< per pixel: edges are then off by an eighth of what they are with one

/// A channel may have no window (-1): it is rendered by `render`, and there is nothing to show it in here.
Rig withoutUnseenChannels(Rig rig)
{
    std::erase_if(rig.channels, [](const Channel& channel) { return channel.window < 0; });
    if (rig.channels.empty())
        throw Error(rig.name, "no channel of this rig has a window to be shown in");
    return rig;
}

/// Until something may be new.
void wait(RoomPreview&)
{
    std::this_thread::sleep_for(10ms);
}
void wait(RigShow& show)
{
    show.wait(10ms);
}

template <class Shown>
void step(Shown& shown)
{
    if (!shown.step())
        wait(shown);
}

/// Until the flight has ended, or the user ends it.
template <class Shown>
void fly(Shown& shown, const ViewerOptions& options)
{
    const auto start = std::chrono::steady_clock::now();
    while (!shown.done()) {
        const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
        const auto place = options.flight(seconds.count());
        if (!place)
            return;
        shown.navigation().placeData(*place);
        step(shown);
    }
}

/// Until the user ends it, or the frames are drawn.
template <class Shown>
void run(Shown& shown, const ViewerOptions& options)
{
    if (options.flight)
        fly(shown, options);
    for (int i = 0; i < options.frames && !shown.done(); ++i)
        shown.drawCompleted();
    while (options.frames == 0 && !shown.done())
        step(shown);
}

void checkOptions(const ViewerOptions& options)
{
    if (options.frames < 0)
        throw Error("viewer", "expected a number of frames, or 0 to run until it is closed");
    if (!(options.windowScale > 0.0))
        throw Error("viewer", "expected a scale of the windows above 0");
    if (options.frames == 0 && !options.screenshotFolder.empty())
        throw Error("viewer", "pictures of the windows are taken after a number of frames; give one");
}

/// `Shown` is what the show follows: a FrameMaker or a FramePace.
template <class Shown>
void runShow(const Rig& rig, const Box3d& worldBounds, Shown& shown, const ViewerOptions& options, Progress& progress)
{
    checkOptions(options);
    checkRig(rig, rig.name);
    const Rig seen = withoutUnseenChannels(rig);
    RigShow show(seen, worldBounds, shown, options.windowScale, options.drawThreads, progress);
    run(show, options);
    if (!options.screenshotFolder.empty())
        writePictures(options.screenshotFolder, seen, show.pictures());
}

void runPreview(const Rig& rig, const Box3d& worldBounds, const FrameMaker& makeFrames, const ViewerOptions& options,
                Progress& progress)
{
    checkOptions(options);
    checkRig(rig, rig.name);
    RoomPreview preview(rig, worldBounds, makeFrames, progress);
    run(preview, options);
    Rig window;
    window.windows.emplace_back().name = "preview";
    if (!options.screenshotFolder.empty())
        writePictures(options.screenshotFolder, window, {preview.picture()});
}

} // namespace

void runRigViewer(const Rig& rig, const Box3d& worldBounds, const FrameMaker& makeFrames, const ViewerOptions& options,
                  Progress& progress)
{
    if (options.preview)
        runPreview(rig, worldBounds, makeFrames, options, progress);
    else
        runShow(rig, worldBounds, makeFrames, options, progress);
}

void viewScene(const Scene& scene, const Rig& rig, const RenderSettings& settings, const ViewerOptions& options,
               Progress& progress)
{
    const Box3d bounds = worldBounds(scene);
    const Executor executor(options.renderThreads);
    const Renderer renderer(scene, executor);
    const LeveredFrameMaker makeFrames = [&](std::span<const View> views, const FrameLevers& levers,
                                             Progress& rendering) {
        return renderer.render(scaledViews(views, levers), withLevers(settings, levers), rendering);
    };
    const FrameWorkMeter meter = [&](std::span<const View> views, Progress& rendering) {
        return workOf(renderer, views, rendering);
    };
    FramePace pace(makeFrames, leversOf(settings), options.fps, meter, samplesAtRest);
    if (options.preview || !options.fps)
        runRigViewer(rig, bounds, pace.finished(), options, progress);
    else
        runShow(rig, bounds, pace, options, progress);
}

Box3d worldBounds(const Scene& scene)
{
    if (!scene.regions || scene.regions->bricks.empty())
        throw Error("scene", "has no bricks, so there is nothing to show");
    Box3i voxels;
    for (const PaddedBrick& brick : scene.regions->bricks)
        voxels.extend({brick.lower, brick.lower + brick.size * brick.cellWidth()});
    return boundsOfTransformed(scene.worldFromVoxel, {vec3d(voxels.lower), vec3d(voxels.upper)});
}

} // namespace brickwall
