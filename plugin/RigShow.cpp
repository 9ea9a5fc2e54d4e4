// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/RigShow.h"

#include <chrono>
#include <thread>

namespace brickwall {

using namespace std::chrono_literals;

RigShow::RigShow(const Rig& rig, const Box3d& worldBounds, const FrameMaker& makeFrames, double windowScale,
                 bool drawThreads, Progress& progress)
    : RigShow(rig, worldBounds, makeFrames, makeFrames, nullptr, windowScale, drawThreads, progress)
{
}

RigShow::RigShow(const Rig& rig, const Box3d& worldBounds, FramePace& pace, double windowScale, bool drawThreads,
                 Progress& progress)
    : RigShow(rig, worldBounds, pace.moving(), pace.finished(), &pace, windowScale, drawThreads, progress)
{
}

RigShow::RigShow(const Rig& rig, const Box3d& worldBounds, const FrameMaker& moving, const FrameMaker& finished,
                 FramePace* pace, double windowScale, bool drawThreads, Progress& progress)
    : rig_(rig),
      moving_(moving),
      finished_(finished),
      pace_(pace),
      progress_(progress),
      navigation_(rig, worldBounds),
      windows_(rig, windowSizes(rig, windowScale), windowScale, drawThreads),
      layout_(layoutOf(rig, windows_.sizes())),
      views_(progress),
      controls_(new RigControls(layout_, windows_, navigation_, pace)),
      rendering_(windows_.drawer())
{
    windows_.show({}, navigation_.roomFromWorld());
    windows_.viewer().addEventHandler(controls_);
}

/// Points the cameras at what is new, and asks for frames of it. Says whether there was something.
bool RigShow::followPose(const FrameMaker& makeFrames)
{
    if (shownStamp_ == navigation_.stamp() && shownSizes_ == windows_.sizes())
        return false;
    shownStamp_ = navigation_.stamp();
    shownSizes_ = windows_.sizes();
    layout_ = layoutOf(rig_, shownSizes_);
    const RigViews views = views_.of(layout_, navigation_);
    const mat4d roomFromWorld = navigation_.roomFromWorld();
    windows_.show(views, roomFromWorld);
    requested_ = windows_.requestOf(views, roomFromWorld);
    request_ = rendering_.request(requested_, makeFrames);
    finishing_ = &makeFrames == &finished_;
    return true;
}

/// Asks for a better picture of what is shown, as long as it rests.
void RigShow::refine()
{
    if (requested_.empty() || pace_->refined())
        return;
    finishing_ = false;
    request_ = rendering_.refine(requested_, pace_->resting());
}

bool RigShow::step()
{
    progress_.check();
    const std::optional<unsigned> published = rendering_.publish();
    const bool moved = followPose(moving_);
    if (pace_ && published == request_ && published && !moved)
        refine();
    if (pace_ && published)
        controls_->showStatus(pace_->status());
    if (!published && !moved && !windows_.viewer().checkNeedToDoFrame())
        return false;
    windows_.viewer().frame();
    return true;
}

void RigShow::wait(std::chrono::milliseconds time) const
{
    if (rendering_.idle())
        std::this_thread::sleep_for(time); // for the user
    else
        rendering_.waitFor(time);
}

void RigShow::drawCompleted()
{
    if (!followPose(finished_) && !finishing_ && !requested_.empty()) { // what was shown last has moved
        request_ = rendering_.request(requested_, finished_);
        finishing_ = true;
    }
    while (!rendering_.idle()) {
        progress_.check();
        rendering_.waitFor(20ms);
        rendering_.publish();
    }
    windows_.viewer().frame();
}

std::vector<WindowCapture::Picture> RigShow::pictures()
{
    windows_.requestPictures();
    windows_.viewer().frame();
    return windows_.takePictures();
}

} // namespace brickwall
