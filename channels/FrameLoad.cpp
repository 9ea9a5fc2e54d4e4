// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/FrameLoad.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace brickwall {
namespace {

constexpr std::size_t longest = 24;
constexpr double leastNoise = 0.02;
constexpr double noiseRate = 1.0 / 24.0;
constexpr double sureness = 5.0;        ///< standard deviations
constexpr double leastChange = 0.06;    ///< smaller ones are followed by the median
constexpr double medianSpread = 1.2533; ///< of a median against a mean, sqrt(pi / 2)
constexpr double driftBetween = 0.05;   ///< the load is not the same before and after levers are moved

double median(std::vector<double> values)
{
    const auto middle = values.begin() + std::ptrdiff_t(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    if (values.size() % 2 == 1)
        return *middle;
    return 0.5 * (*middle + *std::max_element(values.begin(), middle));
}

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

} // namespace

void FrameLoad::add(const Frame& frame, const FrameCost& cost)
{
    if (!frames_.empty() && frames_.back().levers == frame.levers) {
        // The difference of two normal deviates has a mean size of 2 / sqrt(pi) = 1.128.
        const double difference = std::abs(load(frame, cost) - load(frames_.back(), cost)) / 1.128;
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
    std::vector<double> loads;
    for (const Frame& frame : frames_)
        loads.push_back(load(frame, cost));
    for (const std::size_t newer : {2, 3, 4, 6, 8, 12}) {
        if (loads.size() <= newer)
            break;
        const std::size_t older = loads.size() - newer;
        const double before = median({loads.begin(), loads.begin() + std::ptrdiff_t(older)});
        const double after = cautious({loads.begin() + std::ptrdiff_t(older), loads.end()}, before);
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

double FrameLoad::estimate(const FrameCost& cost) const
{
    std::vector<double> loads;
    for (const Frame& frame : frames_)
        loads.push_back(load(frame, cost));
    return median(loads);
}

std::optional<double> FrameLoad::logTimeAtNewest(std::size_t least, std::size_t most) const
{
    std::vector<double> times;
    for (auto frame = frames_.rbegin();
         frame != frames_.rend() && frame->levers == frames_.back().levers && times.size() < most; ++frame)
        times.push_back(frame->logTime);
    return times.empty() || times.size() < least ? std::nullopt : std::optional(median(times));
}

double FrameLoad::uncertainty() const
{
    return spread(std::max<std::size_t>(frames_.size(), 1), noise_);
}

std::optional<FrameLoad::LeverChange> FrameLoad::leverChange() const
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
    change.logRatio = median(after) - median(before);
    change.variance = driftBetween * driftBetween + std::pow(spread(after.size(), noise_), 2.0) +
                      std::pow(spread(before.size(), noise_), 2.0);
    return change;
}

} // namespace brickwall
