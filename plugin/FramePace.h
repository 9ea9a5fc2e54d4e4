// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/FrameTime.h"
#include "brickwall/core/render/Accumulation.h"
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

/// What views have to do before they are rendered, in any unit (workOf, pixelsOf).
using FrameWorkMeter = std::function<double(std::span<const View>, Progress& progress)>;

/// Holds the frame rate of a host that renders by ViewRendering: gives it FrameMakers for views that move, which
/// measure what they take and follow the controller (FrameTime), and for views that rest, which refine what was shown
/// last, each about four times as long as the one before, until it is as the user wants it, and then average frames of
/// other points of the pixels with it (Accumulation). All views of a request are rendered by one decision.
///
/// Thread-safe; the makers have to be called one at a time, and not after this has gone.
class FramePace
{
public:
    /// No fps: nothing is held, every frame is as the user wants it. The meter is asked before each frame that moves,
    /// in its time; without one the views' pixels count. What rests is the mean of so many frames in the end.
    FramePace(LeveredFrameMaker makeFrames, LeverTable levers, std::optional<double> fps, FrameWorkMeter meter = {},
              int samplesPerPixel = 1);

    FrameMaker moving() { return maker(Purpose::moving); }
    /// The next finer one than what was completed last, or one more in the mean.
    FrameMaker resting() { return maker(Purpose::resting); }
    /// As the user wants it, at once.
    FrameMaker finished() { return maker(Purpose::finished); }
    /// What was completed last is as the user wants it, and has all its samples.
    bool refined() const;

    /// That it was made with.
    const LeverTable& levers() const { return controller_.cost().table(); }
    std::optional<double> fps() const;
    /// Within lowestFps and highestFps, or else the nearest of them.
    void setFps(std::optional<double> fps);

    /// For people, a line: the target, what frames take, and the error that is paid for it. Empty if nothing is held.
    std::string status() const;

private:
    enum class Purpose { moving, resting, finished };

    FrameMaker maker(Purpose purpose);
    FrameLevers leversFor(Purpose purpose, double work);
    FrameLevers nextRefinement() const;
    bool isFinest(const FrameLevers& levers) const;
    std::vector<Frame> render(std::span<const View> views, Purpose purpose, Progress& progress);

    const LeveredFrameMaker makeFrames_;
    const FrameWorkMeter meter_;
    const int samplesPerPixel_;
    Accumulation accumulation_; ///< of the thread that renders
    mutable std::mutex mutex_;
    // Under the mutex:
    FrameTime controller_;
    std::optional<double> fps_;
    FrameLevers completed_; ///< what was rendered last
    double seconds_ = 0.0;  ///< that the last moving frame took
    bool moving_ = false;   ///< what was rendered last was one
    int averaged_ = 0;      ///< frames in the mean that was returned last; 0: it is none
};

} // namespace brickwall
