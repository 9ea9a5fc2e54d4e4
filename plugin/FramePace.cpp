// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/FramePace.h"

#include "brickwall/channels/FrameRate.h"
#include "brickwall/channels/LeveredViews.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <utility>

namespace brickwall {
namespace {

using Clock = std::chrono::steady_clock;

constexpr double refinement = 4.0; ///< how much longer each frame at rest takes than the one before

/// "tolerance 0.031 (0.0039 wanted)"
std::string paid(const FrameCost& cost, const FrameLevers& levers)
{
    std::string text;
    for (const LeverRange& range : cost.table()) {
        const double value = valueOf(levers, range.lever);
        if (!text.empty())
            text += ", ";
        if (range.lever == Lever::tolerance)
            text += fmt::format("error up to {:.2g} ({:.2g} wanted)", value, range.finest);
        else if (range.lever == Lever::dt)
            text += fmt::format("dt {:.2g} ({:.2g} wanted)", value, range.finest);
        else
            text += fmt::format("{:.0f}/8 of the pixels across", value);
    }
    return text;
}

} // namespace

FramePace::FramePace(LeveredFrameMaker makeFrames, LeverTable levers, std::optional<double> fps, FrameWorkMeter meter,
                     int samplesPerPixel)
    : makeFrames_(std::move(makeFrames)),
      meter_(std::move(meter)),
      samplesPerPixel_(samplesPerPixel),
      controller_(std::move(levers))
{
    completed_ = controller_.cost().finest();
    setFps(fps);
}

FrameMaker FramePace::maker(Purpose purpose)
{
    return
        [this, purpose](std::span<const View> views, Progress& progress) { return render(views, purpose, progress); };
}

FrameLevers FramePace::leversFor(Purpose purpose, double work)
{
    const std::lock_guard lock(mutex_);
    if (purpose == Purpose::resting)
        return nextRefinement();
    return purpose == Purpose::moving && fps_ ? controller_.decide(work).levers : controller_.cost().finest();
}

FrameLevers FramePace::nextRefinement() const
{
    const FrameCost& cost = controller_.cost();
    const double now = cost.logFactor(completed_), next = now + std::log(refinement);
    const FrameLevers finer = cost.solve(next);
    return next < 0.0 && cost.logFactor(finer) > now ? finer : cost.finest();
}

std::vector<Frame> FramePace::render(std::span<const View> views, Purpose purpose, Progress& progress)
{
    const bool isMoving = purpose == Purpose::moving;
    const auto start = Clock::now();
    const double work = isMoving && meter_ && fps() ? meter_(views, progress) : pixelsOf(views);
    const FrameLevers levers = leversFor(purpose, work);
    const bool averaging = purpose == Purpose::resting && samplesPerPixel_ > 1 && isFinest(levers);
    if (!averaging)
        accumulation_.restart();
    // A cancelled one leaves no trace.
    std::vector<Frame> frames = averaging ? accumulation_.add(makeFrames_(accumulation_.next(views), levers, progress))
                                          : makeFrames_(views, levers, progress);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    const std::lock_guard lock(mutex_);
    completed_ = levers;
    averaged_ = accumulation_.count();
    moving_ = isMoving;
    if (isMoving && fps_) {
        seconds_ = seconds;
        controller_.report(levers, seconds, work);
    }
    return frames;
}

bool FramePace::refined() const
{
    const std::lock_guard lock(mutex_);
    return completed_ == controller_.cost().finest() && (samplesPerPixel_ <= 1 || averaged_ >= samplesPerPixel_);
}

bool FramePace::isFinest(const FrameLevers& levers) const
{
    const std::lock_guard lock(mutex_);
    return levers == controller_.cost().finest();
}

std::optional<double> FramePace::fps() const
{
    const std::lock_guard lock(mutex_);
    return fps_;
}

void FramePace::setFps(std::optional<double> fps)
{
    const std::lock_guard lock(mutex_);
    fps_ = fps;
    if (!fps_)
        return;
    fps_ = withinFps(*fps_);
    controller_.setTarget(1.0 / *fps_);
}

std::string FramePace::status() const
{
    const std::lock_guard lock(mutex_);
    if (!fps_)
        return {};
    const std::string error = paid(controller_.cost(), completed_);
    if (!moving_)
        return fmt::format("{:.0f} fps, at rest: {}{}", *fps_, error,
                           averaged_ > 1 ? fmt::format(", {} samples per pixel", averaged_) : "");
    return fmt::format("{:.0f} fps: {:.0f} of {:.0f} ms{}\n{}", *fps_, 1e3 * seconds_, 1e3 / *fps_,
                       controller_.decision().unreachable ? ", out of reach" : "", error);
}

} // namespace brickwall
