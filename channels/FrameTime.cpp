// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/FrameTime.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <utility>

namespace brickwall {
namespace {

constexpr double littleNoise = 0.065;  ///< up to which no quiet is needed
constexpr double fullNoise = 0.07;     ///< from which on quietSeconds count in full
constexpr double surprise = 4.0;       ///< standard deviations
constexpr double vain = 0.5;           ///< seconds; a raise that is taken back before was one too many
constexpr double firstPatience = 0.25; ///< seconds
constexpr int longestDelay = 4;        ///< frames after which levers that nobody renders with are no longer waited for
constexpr double otherLoad = 0.1;      ///< a ceiling was found for this load, up to 10 %
constexpr std::size_t confirmed = 3;   ///< frames
constexpr double loadHasRisen = 0.7;
constexpr int mostInVain = 3;
constexpr double pressing = 0.5;   ///< a time that is too long by 65 % is answered at once, however noisy it is
constexpr double sureRise = 2.0;   ///< standard deviations that a raise stays below what is expected of it
constexpr double leastTry = 0.12;  ///< where a little more was in vain
constexpr double leastMove = 0.02; ///< 2 % of time are not worth a change
constexpr double shortest = 1e-7, longest = 1e6; ///< seconds, what is beyond counts as that

bool isPositive(double value)
{
    return std::isfinite(value) && value > 0.0;
}

double logOf(double work)
{
    return std::clamp(std::log(work), -100.0, 100.0);
}

} // namespace

FrameTime::FrameTime(LeverTable table, const FrameTimeConfig& config) : config_(config), cost_(std::move(table))
{
    decision_.levers = cost_.finest();
    setTarget(config.targetSeconds);
}

void FrameTime::setTarget(double seconds)
{
    if (!isPositive(seconds))
        throw std::invalid_argument("a frame's target time has to be positive and finite");
    config_.targetSeconds = decision_.targetSeconds = std::clamp(seconds, shortest, longest);
    forgetTries();
    changed_ = true;
}

void FrameTime::forgetLoad()
{
    load_.clear();
    forgetTries();
    changed_ = true;
}

double FrameTime::logTarget() const
{
    return std::log(config_.targetSeconds);
}

void FrameTime::report(const FrameLevers& levers, double seconds, double work)
{
    if (!isPositive(seconds) || !isPositive(work)) {
        ++ignored_;
        return;
    }
    const FrameLevers used = cost_.clamped(levers);
    const double time = std::clamp(seconds, shortest, longest);
    for (double* since : {&sinceChange_, &sinceRaise_, &sinceLowering_})
        *since += std::max(time, 0.5 * config_.targetSeconds); // nobody asks for many more frames than the target
    if (sinceLowering_ > 2.0 * patience_)
        patience_ = 0.0;
    ++framesSinceChange_;
    seen_ = seen_ || used == decision_.levers || framesSinceChange_ > longestDelay;
    logWorkBefore_ = logOf(work);
    load_.add({used, std::log(time) - logWorkBefore_}, cost_);
    const std::optional<FrameLoad::LeverChange> moved = load_.leverChange(cost_);
    const FrameLoad::Change change = load_.forgetBeforeChange(cost_);
    changed_ = changed_ || change != FrameLoad::Change::none;
    if (change == FrameLoad::Change::ofLoad)
        forgetTries();
    if (moved && std::abs(learn(*moved)) > surprise * std::sqrt(moved->variance))
        changed_ = true;
    watchLoad();
}

/// Returns what had been thought wrongly.
double FrameTime::learn(const FrameLoad::LeverChange& moved)
{
    const double missing = moved.logRatio - (cost_.logFactor(moved.to) - cost_.logFactor(moved.from));
    cost_.learn(moved.from, moved.to, moved.logRatio, moved.variance);
    return missing;
}

void FrameTime::forgetTries()
{
    tooFine_.reset();
    inVain_ = 0;
    raised_ = false;
}

/// The same levers take another time: what was in vain before need not be so any longer.
void FrameTime::watchLoad()
{
    const std::optional<double> measured = load_.logTimeAtNewest(confirmed, 24);
    if (!seen_ || !measured)
        return;
    if (settled_ && std::abs(*measured - *settled_) > otherLoad)
        forgetTries();
    if (!settled_ || !tooFine_)
        settled_ = measured;
}

const FrameDecision& FrameTime::decide(double work)
{
    if (isPositive(work))
        logWork_ = logOf(work);
    if (logWork_ < logWorkLowered_ - otherLoad) { // there is less to do than there was when more was too much
        forgetTries();
        patience_ = 0.0;
    }
    if (load_.frames() == 0)
        return decision_;
    const double load = load_.estimate(cost_) + logWork_;
    if (seen_ && load_.frames() >= 2) {
        if (const std::optional<double> factor = wantedFactor(load))
            move(*factor);
    }
    const double cheapest = load + cost_.logFactor(cost_.coarsest());
    decision_.unreachable = cheapest > logTarget() + std::log(config_.bandHigh);
    decision_.expectedSeconds = std::exp(load + cost_.logFactor(decision_.levers));
    return decision_;
}

/// From 0, where times say what they mean, to 1.
double FrameTime::noisiness() const
{
    return std::clamp((load_.noise() - littleNoise) / (fullNoise - littleNoise), 0.0, 1.0);
}

std::optional<double> FrameTime::wantedFactor(double load)
{
    const double expected = load + cost_.logFactor(decision_.levers) - logTarget();
    const double noisy = noisiness();
    const bool quiet = sinceChange_ >= noisy * config_.quietSeconds;
    const double doubt = changed_ || raising_ ? 0.0 : config_.wantedUncertainty * load_.uncertainty();
    const double missing = expected - std::log(config_.aim);
    const bool tooLong = expected > std::log(config_.bandHigh), tooShort = expected < std::log(config_.bandLow);
    if (tooLong || tooShort) {
        const bool mayMove = quiet || (tooLong ? changed_ && missing > noisy * pressing : raising_ && noisy < 0.5);
        if (!mayMove || std::abs(missing) <= doubt)
            return std::nullopt;
        return tooLong ? lower(load) : higher(load);
    }
    if (seen_ && load_.logTimeAtNewest(confirmed, 24))
        raised_ = false; // it was good
    changed_ = raising_ = false;
    return std::nullopt;
}

std::optional<double> FrameTime::lower(double load)
{
    const std::optional<double> measured = load_.logTimeAtNewest(1, 3);
    if (measured && *measured + logWork_ < logTarget() + std::log(config_.bandHigh))
        return std::nullopt; // whatever is thought about the levers
    const double wanted = logTarget() + std::log(config_.aim) - load;
    patience_ =
        sinceRaise_ < vain ? std::clamp(2.0 * patience_, firstPatience, config_.longestPatience) : 0.5 * patience_;
    changed_ = raising_ = false;
    sinceLowering_ = 0.0;
    logWorkLowered_ = logWork_;
    if (!std::exchange(raised_, false))
        return wanted;
    tooFine_ = decision_.levers;
    ++inVain_;
    // What was good is good enough, whatever is now thought about the levers; unless that is not the reason.
    const double good = cost_.logFactor(raisedFrom_);
    return wanted < good - loadHasRisen ? wanted : good;
}

/// Step by step; the steps follow each other without waiting. Where times are noisy they have to wait, and each goes as
/// far as is surely good.
std::optional<double> FrameTime::higher(double load)
{
    const std::optional<double> measured = load_.logTimeAtNewest(2, 3);
    if (load_.frames() < 3 || !measured || sinceLowering_ < patience_ || inVain_ >= mostInVain)
        return std::nullopt;
    if (*measured + logWork_ > logTarget() + std::log(config_.bandHigh))
        return std::nullopt;
    const double now = cost_.logFactor(decision_.levers);
    const double wanted = std::min(logTarget() + std::log(config_.aim) - load, 0.0);
    const double safe = logTarget() + std::log(config_.safeRise) - load;
    const double known = std::max(0.0, logWorkBefore_ - logWork_); // that there is less to do is no experiment
    const double noisy = noisiness(),
                 step = std::lerp(std::log(config_.fastestRise), std::log(config_.noisyRise), noisy);
    const double sure = wanted - noisy * sureRise * load_.uncertainty();
    double factor = std::min(sure, std::max(safe, now + known + step));
    const double limit = tooFine_ ? std::min(wanted, 0.5 * (now + cost_.logFactor(*tooFine_))) : wanted;
    factor = std::min(factor, limit);
    while (factor < limit && cost_.logFactor(cost_.solve(factor)) < now + leastMove) // less than an eighth of the image
        factor = std::min(limit, factor + leastMove);
    changed_ = false;
    raising_ = factor < wanted && !tooFine_;
    if (factor < now + (tooFine_ ? leastTry : leastMove))
        return std::nullopt;
    sinceRaise_ = 0.0;
    raised_ = true;
    raisedFrom_ = decision_.levers;
    return factor;
}

void FrameTime::move(double logFactor)
{
    const FrameLevers levers = cost_.solve(logFactor);
    if (levers == decision_.levers)
        return;
    decision_.levers = levers;
    settled_.reset();
    ++decision_.number;
    sinceChange_ = 0.0;
    framesSinceChange_ = 0;
    seen_ = false;
}

} // namespace brickwall
