// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/FrameTime.h"

#include <algorithm>
#include <cmath>
#include <deque>
#include <functional>
#include <random>
#include <string>
#include <vector>

namespace brickwall::test {

/// A renderer that is not there: how long frames take at levers. The target is 50 ms, the wanted tolerance 1/255.
struct Plant
{
    std::string name;
    double finestSeconds = 0.1;   ///< a frame at the finest setting, before noise and display
    double share = 0.1;           ///< of the time that the tolerance has no hold of
    double exponent = 1.0;        ///< of the tolerance's work; 1 is what the controller assumes
    double constantSeconds = 0.0; ///< that no lever has a hold of
    double refreshSeconds = 0.0;  ///< times are whole refreshes of a display
    double noise = 0.0;           ///< relative; of a normal deviate, or the half width of a uniform one
    bool uniformNoise = false;
    unsigned seed = 1;
    int spikeEvery = 0;                   ///< such a frame takes five times as long
    int delay = 0;                        ///< frames on their way when levers are decided
    std::function<double(int)> load = {}; ///< factor by frame

    double loadAt(int frame) const { return load ? load(frame) : 1.0; }

    /// Without noise, spikes and display.
    double secondsAt(const FrameLevers& levers, int frame) const
    {
        const double work = std::pow(workAt({Lever::tolerance, 1.0 / 255.0, 0.1}, levers.tolerance), exponent);
        const double scale = levers.imageEighths / 8.0;
        return constantSeconds +
               loadAt(frame) * finestSeconds * (share + (1.0 - share) * work) * (0.02 + 0.98 * scale * scale);
    }
};

struct FlownFrame
{
    FrameLevers levers;
    double expected = 0.0; ///< seconds, without noise, spikes and display
    double measured = 0.0; ///< seconds, as the controller is told
    bool moved = false;    ///< levers were moved after it
};

/// The plant's times for these levers, in turn.
class PlantClock
{
public:
    explicit PlantClock(const Plant& plant) : plant_(plant), random_(plant.seed) {}

    FlownFrame next(const FrameLevers& levers)
    {
        FlownFrame flown{levers, plant_.secondsAt(levers, frame_), 0.0, false};
        double seconds = flown.expected * (1.0 + disturbance());
        if (plant_.spikeEvery > 0 && frame_ % plant_.spikeEvery == plant_.spikeEvery - 1)
            seconds *= 5.0;
        if (plant_.refreshSeconds > 0.0)
            seconds = std::ceil(seconds / plant_.refreshSeconds - 1e-9) * plant_.refreshSeconds;
        flown.measured = seconds;
        ++frame_;
        return flown;
    }

private:
    double disturbance()
    {
        if (plant_.uniformNoise)
            return std::uniform_real_distribution(-plant_.noise, plant_.noise)(random_);
        return std::max(plant_.noise * std::normal_distribution()(random_), -0.9);
    }

    Plant plant_;
    std::mt19937 random_;
    int frame_ = 0;
};

/// Flies frames with the controller, levers on their way for the plant's delay.
inline std::vector<FlownFrame> fly(const Plant& plant, FrameTime& controller, int frames)
{
    std::vector<FlownFrame> flown;
    PlantClock clock(plant);
    std::deque<FrameLevers> underway(std::size_t(plant.delay), controller.decision().levers);
    for (int i = 0; i < frames; ++i) {
        underway.push_back(controller.decision().levers);
        FlownFrame frame = clock.next(underway.front());
        underway.pop_front();
        const FrameLevers before = controller.decision().levers;
        controller.report(frame.levers, frame.measured);
        frame.moved = !(controller.decide().levers == before);
        flown.push_back(frame);
    }
    return flown;
}

} // namespace brickwall::test
