// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/FrameLoad.h"
#include "brickwall/core/base/Median.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace brickwall {
namespace {

constexpr std::size_t longest = 24;
constexpr double wantedSpread = 0.025;
constexpr std::size_t fewestForSlope = 6;
constexpr double slopeSureness = 3.0; ///< standard deviations
constexpr double leastNoise = 0.02;
constexpr double noiseRate = 1.0 / 24.0;
constexpr double sureness = 5.0;        ///< standard deviations
constexpr double leastChange = 0.06;    ///< smaller ones are followed by the median
constexpr double medianSpread = 1.2533; ///< of a median against a mean, sqrt(pi / 2)
constexpr double driftBetween = 0.05;   ///< the load is not the same before and after levers are moved

/// Of two, the one nearer to `expected`: one of them may be the exception.
double cautious(const std::vector<double>& values, double expected)
{
    if (values.size() != 2)
        return median(values);
    const double a = values[0] - expected, b = values[1] - expected;
    if (a * b <= 0.0)
        return expected;
    return expected + (std::abs(a) < std::abs(b) ? a : b);
}

double spread(std::size_t count, double noise)
{
    return noise * (count > 2 ? medianSpread : 1.0) / std::sqrt(double(count));
}

/// By how much values grow from one to the next, if the noise would hardly do that, or else 0: the median of the slopes
/// between the values of the older half and those of the newer one (the incomplete method of Theil, "A Rank-Invariant
/// Method of Linear and Polynomial Regression Analysis", 1950), so that single frames that take long change nothing.
double slopeOf(const std::vector<double>& values, double noise)
{
    const std::size_t half = values.size() / 2;
    if (half < fewestForSlope / 2)
        return 0.0;
    const std::size_t apart = values.size() - half;
    std::vector<double> slopes;
    for (std::size_t i = 0; i < half; ++i)
        slopes.push_back((values[i + apart] - values[i]) / double(apart));
    const double slope = median(slopes);
    const double doubt = medianSpread * noise * std::sqrt(2.0 / double(half)) / double(apart);
    return std::abs(slope) > slopeSureness * doubt ? slope : 0.0;
}

/// Of the line with that slope, at the place after the last value.
double nextOf(const std::vector<double>& values, double slope)
{
    std::vector<double> levels;
    for (std::size_t i = 0; i < values.size(); ++i)
        levels.push_back(values[i] + slope * double(values.size() - i));
    return median(levels);
}

} // namespace

void FrameLoad::add(const Frame& frame, const FrameCost& cost)
{
    if (!frames_.empty() && frames_.back().levers == frame.levers) {
        // The difference of two normal deviates has a mean size of 2 / sqrt(pi) = 1.128.
        const double change = load(frame, cost) - load(frames_.back(), cost) - drift(cost);
        const double difference = std::abs(change) / 1.128;
        const double rate = std::max(noiseRate, 1.0 / (2.0 + differences_++)); // at first their mean
        noise_ += rate * (std::min(difference, 4.0 * noise_) - noise_);
        noise_ = std::max(noise_, leastNoise);
    }
    frames_.push_back(frame);
    if (frames_.size() > longest)
        frames_.pop_front();
}

FrameLoad::Change FrameLoad::forgetBeforeChange(const FrameCost& cost)
{
    const std::vector<double> loads = loadsOf(cost);
    for (const std::size_t newer : {2, 3, 4, 6, 8, 12}) {
        if (loads.size() <= newer)
            break;
        const std::size_t older = loads.size() - newer;
        const std::vector<double> past(loads.begin(), loads.begin() + std::ptrdiff_t(older));
        const double slope = slopeOf(past, noise_), before = nextOf(past, slope);
        std::vector<double> present;
        for (std::size_t i = older; i < loads.size(); ++i)
            present.push_back(loads[i] - slope * double(i - older));
        const double after = cautious(present, before);
        const double doubt = std::hypot(spread(older, noise_), spread(newer, noise_));
        if (newer == 2 && after < before)
            continue; // a shorter time does not press
        if (std::abs(after - before) > std::max(sureness * doubt, leastChange)) {
            const bool sameLevers = std::all_of(frames_.begin(), frames_.end(), [&](const Frame& frame) {
                return frame.levers == frames_.back().levers;
            });
            frames_.erase(frames_.begin(), frames_.begin() + std::ptrdiff_t(older));
            return sameLevers ? Change::ofLoad : Change::atMovedLevers;
        }
    }
    return Change::none;
}

std::vector<double> FrameLoad::loadsOf(const FrameCost& cost) const
{
    std::vector<double> loads;
    for (const Frame& frame : frames_)
        loads.push_back(load(frame, cost));
    return loads;
}

double FrameLoad::estimate(const FrameCost& cost) const
{
    const std::vector<double> loads = loadsOf(cost);
    const double slope = slopeOf(loads, noise_);
    const auto newest = std::ptrdiff_t(std::min(loads.size(), framesNeeded()));
    return nextOf({loads.end() - newest, loads.end()}, slope);
}

std::size_t FrameLoad::framesNeeded() const
{
    return std::size_t(std::clamp(std::ceil(std::pow(noise_ / wantedSpread, 2.0)), 3.0, double(longest)));
}

double FrameLoad::drift(const FrameCost& cost) const
{
    return slopeOf(loadsOf(cost), noise_);
}

std::optional<double> FrameLoad::logTimeAtNewest(std::size_t least, std::size_t most) const
{
    std::vector<double> times;
    for (auto frame = frames_.rbegin();
         frame != frames_.rend() && frame->levers == frames_.back().levers && times.size() < most; ++frame)
        times.push_back(frame->logTime);
    if (times.empty() || times.size() < least)
        return std::nullopt;
    return times.size() == 2 ? std::min(times[0], times[1]) : median(times); // one of two may be the exception
}

double FrameLoad::uncertainty() const
{
    const std::size_t count = std::min(frames_.size(), framesNeeded());
    return spread(std::max<std::size_t>(count, 1), noise_);
}

std::optional<FrameLoad::LeverChange> FrameLoad::leverChange(const FrameCost& cost) const
{
    std::vector<double> after, before;
    auto frame = frames_.rbegin();
    for (; frame != frames_.rend() && frame->levers == frames_.back().levers; ++frame)
        after.push_back(frame->logTime);
    for (auto older = frame; older != frames_.rend() && older->levers == frame->levers && before.size() < 8; ++older)
        before.push_back(older->logTime);
    if ((after.size() != 2 && after.size() != 4) || before.size() < 2)
        return std::nullopt;
    LeverChange change{frame->levers, frames_.back().levers, 0.0, 0.0};
    change.logRatio = median(after) - median(before) - drift(cost) * 0.5 * double(after.size() + before.size());
    change.variance = driftBetween * driftBetween + std::pow(spread(after.size(), noise_), 2.0) +
                      std::pow(spread(before.size(), noise_), 2.0);
    return change;
}

} // namespace brickwall
