// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/RigShow.h"

#include <chrono>

namespace brickwall {

using namespace std::chrono_literals;

RigShow::RigShow(const Rig& rig, const Box3d& worldBounds, const FrameMaker& makeFrames, double windowScale,
                 bool drawThreads, Progress& progress)
    : rig_(rig),
      makeFrames_(makeFrames),
      progress_(progress),
      navigation_(rig, worldBounds),
      windows_(rig, windowSizes(rig, windowScale), windowScale, drawThreads),
      layout_(layoutOf(rig, windows_.sizes())),
      views_(progress),
      controls_(new RigControls(layout_, windows_, navigation_)),
      rendering_(windows_.drawer())
{
    windows_.show({}, navigation_.roomFromWorld());
    windows_.viewer().addEventHandler(controls_);
}

/// Points the cameras at what is new, and asks for frames of it. Says whether there was something.
bool RigShow::followPose()
{
    if (shownStamp_ == navigation_.stamp() && shownSizes_ == windows_.sizes())
        return false;
    shownStamp_ = navigation_.stamp();
    shownSizes_ = windows_.sizes();
    layout_ = layoutOf(rig_, shownSizes_);
    const RigViews views = views_.of(layout_, navigation_);
    const mat4d roomFromWorld = navigation_.roomFromWorld();
    windows_.show(views, roomFromWorld);
    rendering_.request(windows_.requestOf(views, roomFromWorld), makeFrames_);
    return true;
}

bool RigShow::step()
{
    progress_.check();
    const bool published = rendering_.publish().has_value();
    const bool moved = followPose();
    if (!published && !moved && !windows_.viewer().checkNeedToDoFrame())
        return false;
    windows_.viewer().frame();
    return true;
}

void RigShow::drawCompleted()
{
    followPose();
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
