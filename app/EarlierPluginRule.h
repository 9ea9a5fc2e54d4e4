// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

namespace brickwall {

/// How the earlier CAVE plugin for AMR held its frame rate, as its source has it, to be compared with and for nothing
/// else: a fixed increment of dt per frame outside of target +- 0.5 fps, and sleeps in the frame loop, which are a part
/// of the time that it looks at. dt has no bounds there: below 0 it never returned from a frame.
class EarlierPluginRule
{
public:
    static constexpr double increment = 0.01;
    static constexpr double sleep = 0.005; ///< seconds per frame, and once more when dt is changed
    static constexpr double amplitude = 0.5;

    explicit EarlierPluginRule(double targetFps, double dt = 0.5) : targetFps_(targetFps), dt_(dt) {}

    double dt() const { return dt_; }

    /// A frame took so long to render; returns for how long the rule then sleeps.
    double frame(double renderSeconds)
    {
        const double fps = 1.0 / (renderSeconds + slept_);
        slept_ = sleep;
        if (fps < targetFps_ - amplitude) {
            dt_ += increment;
            slept_ += sleep;
        }
        if (fps > targetFps_ + amplitude) {
            dt_ -= increment;
            slept_ += sleep;
        }
        return slept_;
    }

private:
    double targetFps_;
    double dt_;
    double slept_ = 0.0;
};

} // namespace brickwall
