// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/FrameLevers.h"

#include <cstddef>
#include <vector>

namespace brickwall {

/// What levers do to the time of a frame. Each lever has a model of its own: moving it from its finest value to one
/// with the part w of the work (workAt) multiplies the time by
///   share + (1 - share) w,
/// that is, time = a + b x work, where `share` is the part of the time at the finest value that the lever has no hold
/// of. The factors of all levers are multiplied. Shares are learnt while levers are moved; factors are logarithms.
class FrameCost
{
public:
    /// With shares that are usual; the table's ranges have to be positive and finite.
    explicit FrameCost(LeverTable table);

    const LeverTable& table() const { return table_; }
    double share(std::size_t lever) const { return shares_[lever]; }

    FrameLevers finest() const;
    FrameLevers coarsest() const;
    /// Within the table's ranges; what is not finite becomes the finest value.
    FrameLevers clamped(const FrameLevers& levers) const;

    /// Logarithm of the time, against that at the finest setting; not above 0.
    double logFactor(const FrameLevers& levers) const;
    /// The setting that loses least for a factor: later levers are only moved when the earlier ones are at their
    /// coarsest, and what an eighth gives too much, the earlier ones take back. Its factor is not above the one wanted,
    /// unless that is below the coarsest setting's, which is then returned.
    FrameLevers solve(double logFactor) const;

    /// The time has changed by exp(logRatio), known to this variance, from one setting to another: moves the shares of
    /// the levers that were moved to what explains it, as far as it is known better than they are (an iterated extended
    /// Kalman filter). Shares are never taken for certain, so that old ones are forgotten.
    void learn(const FrameLevers& from, const FrameLevers& to, double logRatio, double variance);

private:
    double leverFactor(std::size_t lever, double value) const;
    /// How the logarithm of a lever's factor changes with its share.
    double slope(std::size_t lever, const FrameLevers& levers) const;

    LeverTable table_;
    std::vector<double> shares_;
    std::vector<double> variances_; ///< how well they are known
};

} // namespace brickwall
