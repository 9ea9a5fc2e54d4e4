// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/FrameCost.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace brickwall {
namespace {

constexpr double largestShare = 0.9; ///< a lever that seems to do nothing is tried again
constexpr double forgetting = 0.015; ///< how far a share may change from one time that levers are moved to the next
constexpr int iterations = 5;

/// As measured on the samples; low rather than high: the first step then is too short rather than too long.
double usualShare(Lever lever)
{
    return lever == Lever::imageScale ? 0.03 : 0.15;
}

/// How far it may be from that: of an image's pixels next to all take their time, of a tolerance that is not known.
double usualDoubt(Lever lever)
{
    return lever == Lever::imageScale ? 0.05 : 0.15;
}

double square(double x)
{
    return x * x;
}

bool isRange(const LeverRange& range)
{
    if (!std::isfinite(range.finest) || !std::isfinite(range.coarsest))
        return false;
    if (range.lever == Lever::imageScale)
        return range.finest <= 8.0 && range.coarsest >= 1.0 && range.coarsest <= range.finest;
    return range.finest > 0.0 && range.coarsest >= range.finest;
}

} // namespace

FrameCost::FrameCost(LeverTable table) : table_(std::move(table))
{
    for (const LeverRange& range : table_) {
        if (!isRange(range))
            throw std::invalid_argument("a lever's range is not from its finest to its coarsest value");
        shares_.push_back(usualShare(range.lever));
        variances_.push_back(square(usualDoubt(range.lever)));
    }
}

FrameLevers FrameCost::finest() const
{
    FrameLevers levers;
    for (const LeverRange& range : table_)
        setValue(levers, range.lever, range.finest);
    return levers;
}

FrameLevers FrameCost::coarsest() const
{
    FrameLevers levers;
    for (const LeverRange& range : table_)
        setValue(levers, range.lever, range.coarsest);
    return levers;
}

FrameLevers FrameCost::clamped(const FrameLevers& levers) const
{
    FrameLevers result;
    for (const LeverRange& range : table_) {
        const auto [low, high] = std::minmax(range.finest, range.coarsest);
        const double value = valueOf(levers, range.lever);
        setValue(result, range.lever, std::isfinite(value) ? std::clamp(value, low, high) : range.finest);
    }
    return result;
}

double FrameCost::leverFactor(std::size_t lever, double value) const
{
    return std::log(shares_[lever] + (1.0 - shares_[lever]) * workAt(table_[lever], value));
}

double FrameCost::logFactor(const FrameLevers& levers) const
{
    double sum = 0.0;
    for (std::size_t i = 0; i < table_.size(); ++i)
        sum += leverFactor(i, valueOf(levers, table_[i].lever));
    return sum;
}

FrameLevers FrameCost::solve(double logFactor) const
{
    std::vector<double> least{0.0}; ///< of the first i levers together
    for (std::size_t i = 0; i < table_.size(); ++i)
        least.push_back(least[i] + leverFactor(i, table_[i].coarsest));
    FrameLevers levers = finest();
    double wanted = std::min(logFactor, 0.0);
    for (std::size_t i = table_.size(); i-- > 0;) {
        if (least[i] <= wanted) // the earlier ones can do it alone
            continue;
        const double factor = std::exp(wanted - least[i]);
        const double work = (factor - shares_[i]) / (1.0 - shares_[i]);
        const double value = valueWithWork(table_[i], work);
        setValue(levers, table_[i].lever, value);
        wanted -= leverFactor(i, value);
    }
    return levers;
}

double FrameCost::slope(std::size_t lever, const FrameLevers& levers) const
{
    const double work = workAt(table_[lever], valueOf(levers, table_[lever].lever));
    return (1.0 - work) / (shares_[lever] + (1.0 - shares_[lever]) * work);
}

void FrameCost::learn(const FrameLevers& from, const FrameLevers& to, double logRatio, double variance)
{
    if (!std::isfinite(logRatio) || !(variance > 0.0))
        return;
    for (std::size_t i = 0; i < table_.size(); ++i)
        variances_[i] = std::min(variances_[i] + square(forgetting), square(usualDoubt(table_[i].lever)));
    const std::vector<double> before = shares_;
    std::vector<double> slopes(table_.size());
    double sum = 0.0; ///< variance of what is measured, less what is thought
    for (int iteration = 0; iteration < iterations; ++iteration) {
        double missing = logRatio - (logFactor(to) - logFactor(from));
        sum = variance;
        for (std::size_t i = 0; i < table_.size(); ++i) {
            slopes[i] = slope(i, to) - slope(i, from);
            missing -= slopes[i] * (before[i] - shares_[i]);
            sum += variances_[i] * square(slopes[i]);
        }
        for (std::size_t i = 0; i < table_.size(); ++i)
            shares_[i] = std::clamp(before[i] + variances_[i] * slopes[i] / sum * missing, 0.0, largestShare);
    }
    for (std::size_t i = 0; i < table_.size(); ++i)
        variances_[i] *= 1.0 - variances_[i] * square(slopes[i]) / sum;
}

} // namespace brickwall
