// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/FrameCost.h"

#include <cstddef>
#include <deque>
#include <optional>

namespace brickwall {

/// How long frames take at the finest setting, from frames that were measured at any: the logarithm of time less that
/// of the levers' factor. What is remembered reaches back until the load last changed, at most 24 frames: after Bifet
/// and Gavalda, "Learning from Time-Changing Data with Adaptive Windowing" (2007), with medians, so that single frames
/// that take long change nothing.
class FrameLoad
{
public:
    struct Frame
    {
        FrameLevers levers;
        double logTime = 0.0;
    };

    void add(const Frame& frame, const FrameCost& cost);
    void clear() { frames_.clear(); }

    enum class Change {
        none,
        atMovedLevers, ///< the load, or what was thought about the levers
        ofLoad,        ///< between frames at the same levers
    };
    /// Forgets the frames before a change that the noise does not explain; two frames in a row show a large one.
    Change forgetBeforeChange(const FrameCost& cost);

    int frames() const { return int(frames_.size()); }
    /// For the next frame: the median, or where the load surely drifts, the straight line through the frames. There has
    /// to be a frame.
    double estimate(const FrameCost& cost) const;
    /// By how much the load grows from frame to frame; 0 where the noise would explain that.
    double drift(const FrameCost& cost) const;
    /// The median of at most `most` newest frames, as measured, if there are `least` of them at the same levers; of two
    /// the shorter one.
    std::optional<double> logTimeAtNewest(std::size_t least, std::size_t most) const;
    /// Standard deviation of a frame's logarithm, as far as it is not the load that changes.
    double noise() const { return noise_; }
    /// Of the estimate.
    double uncertainty() const;

    /// What the newest change of levers did, once two or four frames have come since and there were two before.
    struct LeverChange
    {
        FrameLevers from;
        FrameLevers to;
        double logRatio = 0.0;
        double variance = 0.0;
    };
    std::optional<LeverChange> leverChange(const FrameCost& cost) const;

private:
    std::size_t framesNeeded() const;
    double load(const Frame& frame, const FrameCost& cost) const
    {
        return frame.logTime - cost.logFactor(frame.levers);
    }

    std::vector<double> loadsOf(const FrameCost& cost) const;

    std::deque<Frame> frames_; ///< the newest last
    double noise_ = 0.1;
    double differences_ = 0.0; ///< that the noise was learnt from
};

} // namespace brickwall
