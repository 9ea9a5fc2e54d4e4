// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/RigRendering.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace brickwall {

RigRendering::~RigRendering()
{
    progress_.cancel();
    if (pending_.valid())
        pending_.wait();
}

void RigRendering::start(RigViews views, const mat4d& roomFromWorld)
{
    moment_ = {std::move(views), roomFromWorld};
    pending_ = std::async(std::launch::async, [this] { render(); });
}

bool RigRendering::waitFor(std::chrono::milliseconds time) const
{
    return pending_.wait_for(time) == std::future_status::ready;
}

RigMoment RigRendering::finish()
{
    pending_.get();
    return std::move(moment_);
}

void RigRendering::render()
{
    const std::vector<ChannelView>& wanted = moment_.views.views;
    if (wanted.empty())
        return;
    std::vector<View> views;
    for (const ChannelView& view : wanted)
        views.push_back(view.view);
    const std::vector<Frame> frames = makeFrames_(views, progress_);
    if (frames.size() != wanted.size())
        throw Error("viewer",
                    fmt::format("expected a frame for each of {} views, got {}", wanted.size(), frames.size()));
    for (std::size_t i = 0; i < wanted.size(); ++i)
        write(wanted[i], frames[i]);
}

void RigRendering::write(const ChannelView& view, const Frame& frame)
{
    const int index = channels_.indexOf(view.channel, view.eye);
    drawer_.resizeView(index, frame.width, frame.height);
    std::copy(frame.color.begin(), frame.color.end(), drawer_.rgba(index));
    std::copy(frame.depth.begin(), frame.depth.end(), drawer_.depth(index));
}

} // namespace brickwall
