// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/plugin/MultiChannelDrawer.h"
#include "brickwall/plugin/RigChannels.h"
#include "brickwall/plugin/RigViewer.h"

#include <chrono>
#include <future>

namespace brickwall {

/// What a set of frames was rendered for.
struct RigMoment
{
    RigViews views;
    mat4d roomFromWorld{1.0};
};

/// Renders the views of a rig in a thread of its own, one set at a time, and leaves them in the drawer's back images.
class RigRendering
{
public:
    /// All have to outlive this.
    RigRendering(MultiChannelDrawer& drawer, const RigChannels& channels, const FrameMaker& makeFrames)
        : drawer_(drawer), channels_(channels), makeFrames_(makeFrames)
    {
    }
    /// Cancels what is running and waits for its end.
    ~RigRendering();

    bool running() const { return pending_.valid(); }
    /// Not while another one is running.
    void start(RigViews views, const mat4d& roomFromWorld);
    /// Whether the running one has ended by then.
    bool waitFor(std::chrono::milliseconds time) const;
    /// The drawer may now swap. Throws what the rendering threw.
    RigMoment finish();

private:
    void render();
    void write(const ChannelView& view, const Frame& frame);

    MultiChannelDrawer& drawer_;
    const RigChannels& channels_;
    const FrameMaker& makeFrames_;
    Progress progress_;
    RigMoment moment_;
    std::future<void> pending_;
};

} // namespace brickwall
