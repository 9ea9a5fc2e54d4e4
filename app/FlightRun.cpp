// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "EarlierPluginRule.h"
#include "Flight.h"

#include "brickwall/channels/FrameWork.h"
#include "brickwall/channels/LeveredViews.h"
#include "brickwall/core/base/Median.h"
#include "brickwall/core/render/Compare.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <ctime>
#include <utility>

namespace brickwall {
namespace {

using Clock = std::chrono::steady_clock;

View viewAt(const Flight& flight, double time, const Box3d& bounds, const PixelSize& size)
{
    const FlightKey key = flight.at(time);
    return cameraView({key.eye.x, key.eye.y, key.eye.z, key.at.x, key.at.y, key.at.z, key.up.x, key.up.y, key.up.z},
                      flight.fov, bounds, size);
}

/// As a window shows it: every pixel of the larger one has the value of the one that it lies in.
Frame stretched(const Frame& frame, int width, int height)
{
    Frame result = frame;
    result.width = width;
    result.height = height;
    result.color.resize(std::size_t(width) * height);
    for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x) {
            const int fromX = (2 * x + 1) * frame.width / (2 * width),
                      fromY = (2 * y + 1) * frame.height / (2 * height);
            result.color[result.index(x, y)] = frame.color[frame.index(fromX, fromY)];
        }
    return result;
}

/// Renders the frames of a flight, one after the other.
class FlightRenderer
{
public:
    FlightRenderer(const Renderer& renderer, const RenderSettings& wanted, const FlightOptions& options)
        : renderer_(renderer), wanted_(wanted), options_(options)
    {
    }

    /// What the controller needs to know about the frame is a part of its time.
    FlightFrame render(const View& view, FrameTime& controller)
    {
        const double start = now(), work = workOf(renderer_, {&view, 1}, silent_);
        const FrameLevers levers = controller.decide(work).levers;
        FlightFrame flown = render(view, withLevers(wanted_, levers), levers, start);
        controller.report(levers, flown.renderSeconds, work);
        flown.unreachable = controller.decision().unreachable;
        return flown;
    }

    FlightFrame render(const View& view, const RenderSettings& settings, const FrameLevers& levers)
    {
        return render(view, settings, levers, now());
    }

private:
    FlightFrame render(const View& view, const RenderSettings& settings, const FrameLevers& levers, double start)
    {
        FlightFrame flown;
        flown.levers = levers;
        std::vector<ViewStatistics> statistics;
        const View scaled = scaledView(view, levers.imageEighths);
        const std::vector<Frame> frames = renderer_.render({&scaled, 1}, settings, silent_, &statistics);
        flown.renderSeconds = now() - start;
        flown.admitted = statistics.front().largestBound;
        if (options_.measureEvery > 0 && frame_++ % options_.measureEvery == 0)
            flown.rmsError = errorOf(frames.front(), view);
        return flown;
    }

    double now() const
    {
        if (options_.processorTime)
            return double(std::clock()) / CLOCKS_PER_SEC;
        return std::chrono::duration<double>(Clock::now().time_since_epoch()).count();
    }

    double errorOf(const Frame& frame, const View& view)
    {
        const std::vector<Frame> finest = renderer_.render({&view, 1}, wanted_, silent_);
        const Frame& wanted = finest.front();
        return compareFrames(stretched(frame, wanted.width, wanted.height), wanted).rms;
    }

    const Renderer& renderer_;
    const RenderSettings& wanted_;
    const FlightOptions& options_;
    Progress silent_;
    int frame_ = 0;
};

} // namespace

std::vector<FlightFrame> fly(const Renderer& renderer, const RenderSettings& settings, const Flight& flight,
                             const Box3d& bounds, const FlightOptions& options, Progress& progress)
{
    FrameTimeConfig config;
    config.targetSeconds = 1.0 / options.fps;
    FrameTime controller(leversOf(settings), config);
    FlightRenderer frames(renderer, settings, options);
    std::vector<FlightFrame> flown;
    for (double time = 0.0; time < flight.seconds();
         time += std::max(flown.back().renderSeconds, config.targetSeconds)) {
        progress.check();
        flown.push_back(frames.render(viewAt(flight, time, bounds, options.size), controller));
        flown.back().time = time;
    }
    return flown;
}

std::vector<FlightFrame> flyByEarlierRule(const Renderer& renderer, const RenderSettings& settings,
                                          const Flight& flight, const Box3d& bounds, const FlightOptions& options,
                                          Progress& progress)
{
    EarlierPluginRule rule(options.fps);
    RenderSettings stepping = settings;
    stepping.method = Method::midpoint;
    FlightRenderer frames(renderer, settings, options);
    std::vector<FlightFrame> flown;
    for (double time = 0.0; time < flight.seconds() && rule.dt() > 0.5 * EarlierPluginRule::increment;
         time += flown.back().renderSeconds + flown.back().sleepSeconds) {
        progress.check();
        FrameLevers levers;
        levers.dt = rule.dt();
        flown.push_back(
            frames.render(viewAt(flight, time, bounds, options.size), withLevers(stepping, levers), levers));
        flown.back().time = time;
        flown.back().sleepSeconds = rule.frame(flown.back().renderSeconds);
    }
    return flown;
}

FlightShares sharesOf(const std::vector<FlightFrame>& frames, double targetSeconds, const FrameLevers& finest)
{
    FlightShares shares;
    std::vector<double> errors;
    int count = 0;
    for (const FlightFrame& frame : frames) {
        if (frame.time < 1.0)
            continue;
        ++count;
        const double ratio = (frame.renderSeconds + frame.sleepSeconds) / targetSeconds;
        shares.within += std::abs(ratio - 1.0) <= 0.2;
        shares.longer += ratio > 1.2;
        shares.shorterAtFinest += ratio < 0.8 && frame.levers == finest;
        if (frame.rmsError)
            errors.push_back(*frame.rmsError);
    }
    for (double* share : {&shares.within, &shares.longer, &shares.shorterAtFinest})
        *share /= std::max(count, 1);
    shares.medianRmsError = median(errors);
    return shares;
}

} // namespace brickwall
