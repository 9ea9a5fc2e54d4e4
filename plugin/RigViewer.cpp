// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/RigViewer.h"

#include "brickwall/core/base/BoxCorners.h"
#include "brickwall/core/base/Error.h"
#include "brickwall/plugin/Pictures.h"
#include "brickwall/plugin/RigControls.h"
#include "brickwall/plugin/RigWindows.h"
#include "brickwall/plugin/ViewRendering.h"

#include <chrono>
#include <map>
#include <optional>
#include <set>
#include <thread>
#include <utility>

namespace brickwall {
namespace {

using namespace std::chrono_literals;

class RigViewer
{
public:
    RigViewer(const Rig& rig, const Box3d& bounds, const FrameMaker& makeFrames, const ViewerOptions& options,
              Progress& progress);

    void showFrames(int count);
    void runUntilClosed();
    void takePictures(const std::string& folder);

private:
    bool changed() const;
    void startRendering();
    bool publishIfDone();
    void noteRefused(const RigViews& views);

    /// What a set of frames was asked for.
    struct Moment
    {
        RigViews views;
        mat4d roomFromWorld;
    };

    const Rig& rig_;
    const FrameMaker& makeFrames_;
    Progress& progress_;
    RigNavigation navigation_;
    RigWindows windows_;
    Rig layout_;
    std::optional<unsigned> renderedStamp_; ///< of the navigation, in the latest request
    std::vector<WindowSize> renderedSizes_;
    std::set<std::string> refused_;
    osg::ref_ptr<RigControls> controls_;
    std::map<unsigned, Moment> moments_; ///< by the numbers of the requests
    ViewRendering rendering_;            ///< last: it ends before what it writes to does
};

RigViewer::RigViewer(const Rig& rig, const Box3d& bounds, const FrameMaker& makeFrames, const ViewerOptions& options,
                     Progress& progress)
    : rig_(rig),
      makeFrames_(makeFrames),
      progress_(progress),
      navigation_(rig, bounds),
      windows_(rig, windowSizes(rig, options.windowScale), options.windowScale, options.drawThreads),
      layout_(layoutOf(rig, windows_.sizes())),
      controls_(new RigControls(layout_, windows_, navigation_)),
      rendering_(windows_.drawer())
{
    windows_.show({}, navigation_.roomFromWorld());
    windows_.viewer().addEventHandler(controls_);
}

bool RigViewer::changed() const
{
    return renderedStamp_ != navigation_.stamp() || renderedSizes_ != windows_.sizes();
}

void RigViewer::startRendering()
{
    renderedStamp_ = navigation_.stamp();
    renderedSizes_ = windows_.sizes();
    layout_ = layoutOf(rig_, renderedSizes_);
    // Viewers that layoutOf appends belong to channels without head tracking and stay.
    const std::vector<mat4d>& heads = navigation_.roomFromHeads();
    for (std::size_t i = 0; i < heads.size(); ++i)
        layout_.viewers[i].roomFromHead = heads[i];
    RigViews views = viewsOfRig(layout_, navigation_.worldFromRoom());
    noteRefused(views);
    const mat4d roomFromWorld = navigation_.roomFromWorld();
    const unsigned number = rendering_.request(windows_.requestOf(views, roomFromWorld), makeFrames_);
    moments_.emplace(number, Moment{std::move(views), roomFromWorld});
}

bool RigViewer::publishIfDone()
{
    const std::optional<unsigned> number = rendering_.publish();
    if (!number)
        return false;
    const Moment& moment = moments_.at(*number);
    windows_.show(moment.views, moment.roomFromWorld);
    moments_.erase(moments_.begin(), moments_.upper_bound(*number));
    return true;
}

void RigViewer::noteRefused(const RigViews& views)
{
    std::set<std::string> names;
    for (const RefusedView& view : views.refused) {
        names.insert(view.name);
        if (!refused_.contains(view.name))
            progress_.note(view.name + " stays black: " + view.reason);
    }
    refused_ = std::move(names);
}

void RigViewer::showFrames(int count)
{
    for (int i = 0; i < count && !windows_.viewer().done(); ++i) {
        if (changed())
            startRendering();
        while (!rendering_.idle()) {
            progress_.check();
            rendering_.waitFor(20ms);
            publishIfDone();
        }
        windows_.viewer().frame();
    }
}

void RigViewer::runUntilClosed()
{
    while (!windows_.viewer().done()) {
        progress_.check();
        const bool published = publishIfDone();
        if (changed())
            startRendering();
        if (published || windows_.viewer().checkNeedToDoFrame())
            windows_.viewer().frame();
        else
            std::this_thread::sleep_for(10ms);
    }
}

void RigViewer::takePictures(const std::string& folder)
{
    windows_.requestPictures();
    windows_.viewer().frame();
    writePictures(folder, rig_, windows_.takePictures());
}

/// A channel may have no window (-1): it is rendered by `render`, and there is nothing to show it in here.
Rig withoutUnseenChannels(Rig rig)
{
    std::erase_if(rig.channels, [](const Channel& channel) { return channel.window < 0; });
    if (rig.channels.empty())
        throw Error(rig.name, "no channel of this rig has a window to be shown in");
    return rig;
}

} // namespace

void runRigViewer(const Rig& rig, const Box3d& worldBounds, const FrameMaker& makeFrames, const ViewerOptions& options,
                  Progress& progress)
{
    if (options.frames < 0)
        throw Error("viewer", "expected a number of frames, or 0 to run until it is closed");
    if (!(options.windowScale > 0.0))
        throw Error("viewer", "expected a scale of the windows above 0");
    if (options.frames == 0 && !options.screenshotFolder.empty())
        throw Error("viewer", "pictures of the windows are taken after a number of frames; give one");
    checkRig(rig, rig.name);
    const Rig shown = withoutUnseenChannels(rig);
    RigViewer viewer(shown, worldBounds, makeFrames, options, progress);
    if (options.frames == 0)
        return viewer.runUntilClosed();
    viewer.showFrames(options.frames);
    if (!options.screenshotFolder.empty())
        viewer.takePictures(options.screenshotFolder);
}

void viewScene(const Scene& scene, const Rig& rig, const RenderSettings& settings, const ViewerOptions& options,
               Progress& progress)
{
    const Box3d bounds = worldBounds(scene);
    const Executor executor(options.renderThreads);
    const Renderer renderer(scene, executor);
    const FrameMaker makeFrames = [&](std::span<const View> views, Progress& rendering) {
        return renderer.render(views, settings, rendering);
    };
    runRigViewer(rig, bounds, makeFrames, options, progress);
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
