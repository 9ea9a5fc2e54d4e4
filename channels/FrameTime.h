// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/FrameLoad.h"

#include <cstdint>
#include <optional>

namespace brickwall {

struct FrameTimeConfig
{
    double targetSeconds = 1.0 / 20.0;
    /// No lever is moved while a frame is expected to take between these, as parts of the target.
    double bandLow = 0.86;
    double bandHigh = 1.10;
    double aim = 0.97;              ///< what levers are moved to
    double fastestRise = 1.3;       ///< of the time by one decision, where there is time left
    double noisyRise = 4.0;         ///< instead, where times are noisy and a decision has to last for quietSeconds
    double safeRise = 0.5;          ///< up to this part of the target it rises at once
    double quietSeconds = 1.05;     ///< between decisions that no change of the load asks for, where there is noise
    double longestPatience = 2.0;   ///< seconds that levers stay down where going up was in vain again and again
    double wantedUncertainty = 2.5; ///< standard deviations by which an expectation leaves the band
};

/// One decision, for all eyes and screens of a rig: a plain record, to be sent to every node that renders.
struct FrameDecision
{
    FrameLevers levers;
    double targetSeconds = 0.0;
    double expectedSeconds = 0.0; ///< for a frame at these levers; 0 before anything was measured
    bool unreachable = false;     ///< the cheapest setting takes longer than the target, as far as is known
    std::uint32_t number = 0;     ///< counts the changes of the levers
};

/// Holds the time of frames by giving up accuracy, and gives it back where there is time left. Has no clock: it is told
/// what frames took, and at which levers. The time is that of rendering, not the interval of a display, which counts in
/// whole refreshes.
///
/// Before each frame it is asked what to do (decide) and after it told what that took (report). It knows the load (how
/// long a frame takes at the finest setting for its work, FrameLoad) and what levers do to it (FrameCost), and solves
/// for the setting whose time is the target. Down at once, up by steps; nothing in a dead band around the target; never
/// twice before a frame at the new setting was seen; on noise at most once in `quietSeconds`. Where more accuracy was
/// tried and took too long, it is not tried again until the load changes: a time that jumps (a display that counts in
/// refreshes) leads to no cycle.
///
/// Not thread-safe.
class FrameTime
{
public:
    /// Starts at the finest setting. Throws std::invalid_argument for ranges of levers that are none, and for times
    /// that are not positive and finite.
    explicit FrameTime(LeverTable table, const FrameTimeConfig& config = {});

    /// A frame took so long at these levers, which may be older than the newest decision. `work` is what is known in
    /// advance about frames, in any unit (workOf, pixelsOf): time is taken to grow with it, so that neither a window
    /// that is resized is a surprise nor data that come nearer. Times and works that are not positive and finite are
    /// counted and change nothing.
    void report(const FrameLevers& levers, double seconds, double work = 1.0);

    /// What the next frame shall be rendered with, if `work` is what is known in advance about it. To be asked once
    /// before each frame.
    const FrameDecision& decide(double work = 1.0);
    /// What was decided last.
    const FrameDecision& decision() const { return decision_; }
    /// The levers' time as it is known now.
    const FrameCost& cost() const { return cost_; }

    void setTarget(double seconds);
    /// Another scene: what is known about the load is void. Levers stay.
    void forgetLoad();

    std::uint64_t ignored() const { return ignored_; } ///< reports that were no numbers

private:
    double learn(const FrameLoad::LeverChange& moved);
    double noisiness() const;
    void forgetTries();
    void watchLoad();
    /// To what the logarithm of the levers' factor shall be changed, if it shall.
    std::optional<double> wantedFactor(double load);
    std::optional<double> lower(double load);
    std::optional<double> higher(double load);
    void move(double logFactor);
    double logTarget() const;

    FrameTimeConfig config_;
    FrameCost cost_;
    FrameLoad load_;
    FrameDecision decision_;
    double logWork_ = 0.0;        ///< of the next frame
    double logWorkBefore_ = 0.0;  ///< of the one before
    double logWorkLowered_ = 0.0; ///< of the one before which levers were lowered last
    double sinceRaise_ = 1e9;     ///< seconds
    double sinceLowering_ = 1e9;  ///< seconds
    double patience_ = 0.0;       ///< seconds after a lowering before the first raise
    double sinceChange_ = 0.0;    ///< seconds
    int framesSinceChange_ = 0;   ///< reports, of any levers
    bool seen_ = true;            ///< a frame at the present levers
    bool changed_ = true;         ///< the load, since the last decision, so that it need not be waited
    bool raising_ = false;        ///< step by step, there is more to come
    std::uint64_t ignored_ = 0;

    bool raised_ = false; ///< by the last change, and not known to be good
    FrameLevers raisedFrom_;
    int inVain_ = 0;                     ///< raises to what took too long, at this load
    std::optional<FrameLevers> tooFine_; ///< they were raised to that, and it took too long
    std::optional<double> settled_;      ///< logarithm of the time at the present levers, since something was too fine
};

} // namespace brickwall
