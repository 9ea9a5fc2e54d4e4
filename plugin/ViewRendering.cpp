// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/ViewRendering.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace brickwall {
namespace {

std::vector<Frame> framesOf(const std::vector<RequestedView>& requested, const FrameMaker& makeFrames,
                            Progress& progress)
{
    if (requested.empty())
        return {};
    std::vector<View> views;
    for (const RequestedView& view : requested)
        views.push_back(view.view);
    std::vector<Frame> frames = makeFrames(views, progress);
    if (frames.size() != views.size())
        throw Error("viewer",
                    fmt::format("expected a frame for each of {} views, got {}", views.size(), frames.size()));
    return frames;
}

} // namespace

ViewRendering::ViewRendering(MultiChannelDrawer& drawer) : drawer_(drawer), thread_([this] { loop(); }) {}

ViewRendering::~ViewRendering()
{
    {
        const std::lock_guard lock(mutex_);
        stop_ = true;
        if (running_)
            running_->cancel();
    }
    changed_.notify_all();
    thread_.join();
}

unsigned ViewRendering::request(std::vector<RequestedView> views, FrameMaker makeFrames, bool outdated)
{
    const std::lock_guard lock(mutex_);
    outdated = std::exchange(refining_, false) || outdated;
    if (outdated && running_ && !cancelledBefore_) {
        running_->cancel();
        cancelledBefore_ = true;
    }
    return replaceNewest(std::move(views), std::move(makeFrames));
}

unsigned ViewRendering::refine(std::vector<RequestedView> views, FrameMaker makeFrames)
{
    const std::lock_guard lock(mutex_);
    refining_ = true;
    return replaceNewest(std::move(views), std::move(makeFrames));
}

unsigned ViewRendering::replaceNewest(std::vector<RequestedView> views, FrameMaker makeFrames)
{
    newest_ = Request{++lastNumber_, std::move(views), std::move(makeFrames)};
    changed_.notify_all();
    return lastNumber_;
}

std::optional<unsigned> ViewRendering::publish()
{
    const std::lock_guard lock(mutex_);
    if (failure_)
        std::rethrow_exception(std::exchange(failure_, nullptr));
    return swap();
}

std::optional<unsigned> ViewRendering::swap()
{
    if (!finished_)
        return std::nullopt;
    for (const RequestedView& view : finished_->views)
        drawer_.updateMatrices(view.drawerView, view.model, view.viewing, view.projection);
    drawer_.swapFrame();
    const unsigned number = finished_->number;
    finished_.reset();
    changed_.notify_all();
    return number;
}

bool ViewRendering::idle() const
{
    const std::lock_guard lock(mutex_);
    return !newest_ && !running_ && !finished_ && !failure_;
}

void ViewRendering::waitFor(std::chrono::milliseconds time) const
{
    std::unique_lock lock(mutex_);
    changed_.wait_for(lock, time, [this] { return finished_ || failure_ || (!newest_ && !running_); });
}

void ViewRendering::restructure(const std::function<void()>& change)
{
    std::unique_lock lock(mutex_);
    ++structure_;
    newest_.reset();
    if (running_)
        running_->cancel();
    changed_.wait(lock, [this] { return !writing_; });
    swap();
    change();
}

void ViewRendering::loop()
{
    std::unique_lock lock(mutex_);
    for (;;) {
        changed_.wait(lock, [this] { return stop_ || newest_; });
        if (stop_)
            return;
        try {
            renderNewest(lock);
        } catch (const Cancelled&) {
            lock.lock();
        } catch (...) {
            lock.lock();
            failure_ = std::current_exception();
        }
        writing_ = false;
        running_.reset();
        changed_.notify_all();
    }
}

/// Throws with the lock open.
void ViewRendering::renderNewest(std::unique_lock<std::mutex>& lock)
{
    const Request request = *std::exchange(newest_, std::nullopt);
    const unsigned structure = structure_;
    running_ = std::make_unique<Progress>();
    Progress& progress = *running_;
    lock.unlock();
    const std::vector<Frame> frames = framesOf(request.views, request.makeFrames, progress);
    lock.lock();
    cancelledBefore_ = false;

    changed_.wait(lock, [this] { return stop_ || !finished_; }); // the back images are free again
    if (stop_ || structure != structure_)
        return;
    writing_ = true;
    lock.unlock();
    write(request, frames);
    lock.lock();
    finished_ = request;
}

void ViewRendering::write(const Request& request, const std::vector<Frame>& frames)
{
    for (std::size_t i = 0; i < frames.size(); ++i) {
        const Frame& frame = frames[i];
        const int view = request.views[i].drawerView;
        drawer_.resizeView(view, frame.width, frame.height);
        std::copy(frame.color.begin(), frame.color.end(), drawer_.rgba(view));
        std::copy(frame.depth.begin(), frame.depth.end(), drawer_.depth(view));
    }
}

} // namespace brickwall
