// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/FrameTime.h"
#include "brickwall/plugin/ViewRendering.h"

#include <functional>
#include <mutex>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

/// Renders views, all with the same levers; of another size than asked for if these say so (scaledView).
using LeveredFrameMaker =
    std::function<std::vector<Frame>(std::span<const View>, const FrameLevers&, Progress& progress)>;

/// Holds the frame rate of a host that renders by ViewRendering: gives it FrameMakers for views that move, which
/// measure what they take and follow the controller (FrameTime), and for views that rest, which refine what was shown
/// last, each about four times as long as the one before, until it is as the user wants it. All views of a request are
/// rendered by one decision.
///
/// Thread-safe; the makers have to be called one at a time, and not after this has gone.
class FramePace
{
public:
    static constexpr double lowestFps = 5.0, highestFps = 60.0;

    /// No fps: nothing is held, every frame is as the user wants it.
    FramePace(LeveredFrameMaker makeFrames, LeverTable levers, std::optional<double> fps);

    FrameMaker moving();
    /// The next finer one than what was completed last.
    FrameMaker resting();
    /// As the user wants it, at once.
    FrameMaker finished();
    /// What was completed last is as the user wants it.
    bool refined() const;

    std::optional<double> fps() const;
    /// Within lowestFps and highestFps, or else the nearest of them.
    void setFps(std::optional<double> fps);

    /// For people, a line: the target, what frames take, and the error that is paid for it. Empty if nothing is held.
    std::string status() const;

private:
    FrameLevers nextRefinement() const;
    std::vector<Frame> render(std::span<const View> views, const FrameLevers& levers, bool isMoving,
                              Progress& progress);

    const LeveredFrameMaker makeFrames_;
    mutable std::mutex mutex_;
    // Under the mutex:
    FrameTime controller_;
    std::optional<double> fps_;
    FrameLevers completed_; ///< what was rendered last
    double seconds_ = 0.0;  ///< that the last moving frame took
    bool moving_ = false;   ///< it was one
};

} // namespace brickwall
