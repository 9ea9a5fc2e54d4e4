// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Progress.h"
#include "brickwall/core/render/Frame.h"
#include "brickwall/plugin/MultiChannelDrawer.h"

#include <chrono>
#include <condition_variable>
#include <exception>
#include <functional>
#include <memory>
#include <mutex>
#include <optional>
#include <span>
#include <thread>
#include <vector>

namespace brickwall {

/// Renders views, all of one moment, in their order; called in a thread of its own, one call at a time.
using FrameMaker = std::function<std::vector<Frame>(std::span<const View>, Progress&)>;

/// An image that a host wants, and the view of its drawer that is to show it. The matrices are those of the image,
/// which the drawer needs to show it from elsewhere: clip = vertex * model * viewing * projection.
struct RequestedView
{
    int drawerView = 0;
    View view;
    osg::Matrixd model;
    osg::Matrixd viewing;
    osg::Matrixd projection;
};

/// The rendering loop of a host with a MultiChannelDrawer: renders in a thread of its own the newest set of views that
/// was asked for, all of them by one call of the FrameMaker, and publishes whole sets only, so that two eyes or two
/// walls never show different poses. While nothing is asked for, it does nothing.
///
/// Neither side waits for the other: a request replaces one that has not been begun; frames are written into the
/// drawer's back images beside drawing, and the next ones are rendered while the host has not yet published these. All
/// functions belong to the update phase; none takes longer than handing over pointers, but `restructure`.
class ViewRendering
{
public:
    /// Whose back images nobody else writes to; has to outlive this.
    explicit ViewRendering(MultiChannelDrawer& drawer);
    /// Cancels what is running and waits for its end.
    ~ViewRendering();

    /// What is to be shown from now on; the number says so when it is published. A set that is being rendered is
    /// completed, or else a moving head would never see a picture, unless `outdated`: what it renders is no longer what
    /// is shown (another transfer function). Even then every second one is completed.
    unsigned request(std::vector<RequestedView> views, FrameMaker makeFrames, bool outdated = false);
    /// A better picture of what was asked for last: it is cancelled as outdated by the next request.
    unsigned refine(std::vector<RequestedView> views, FrameMaker makeFrames);

    /// Swaps the drawer's images if a whole set waits for that, and returns the number of its request. Throws what the
    /// FrameMaker has thrown, once.
    std::optional<unsigned> publish();

    /// Nothing is asked for, rendered or waits to be published.
    bool idle() const;
    /// Until there is something to publish, or it is idle, or the time is over.
    void waitFor(std::chrono::milliseconds time) const;

    /// Changes the drawer's views, while nobody writes to them. A set that is complete is swapped before; what is asked
    /// for or being rendered is forgotten, its views may no longer be the same. Waits for the end of a writing, some
    /// milliseconds.
    void restructure(const std::function<void()>& change);

private:
    struct Request
    {
        unsigned number = 0;
        std::vector<RequestedView> views;
        FrameMaker makeFrames;
    };

    unsigned replaceNewest(std::vector<RequestedView> views, FrameMaker makeFrames);
    std::optional<unsigned> swap();
    void loop();
    void renderNewest(std::unique_lock<std::mutex>& lock);
    void write(const Request& request, const std::vector<Frame>& frames);

    MultiChannelDrawer& drawer_;
    mutable std::mutex mutex_;
    mutable std::condition_variable changed_;
    // Under the mutex:
    std::optional<Request> newest_;
    std::unique_ptr<Progress> running_;
    std::optional<Request> finished_; ///< its frames are in the back images
    std::exception_ptr failure_;
    bool writing_ = false;
    bool cancelledBefore_ = false;
    bool refining_ = false; ///< by the latest request
    bool stop_ = false;
    unsigned lastNumber_ = 0;
    unsigned structure_ = 0; ///< counts the calls of restructure

    std::thread thread_; ///< last: it uses all the others
};

} // namespace brickwall
