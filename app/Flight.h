// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Camera.h"

#include "brickwall/channels/FrameRate.h"
#include "brickwall/channels/FrameTime.h"
#include "brickwall/channels/Rig.h"
#include "brickwall/core/base/Box.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/render/Renderer.h"

#include <optional>
#include <string>
#include <vector>

namespace brickwall {

struct FlightKey
{
    double time = 0.0; ///< seconds
    vec3d eye{0.0};
    vec3d at{0.0};
    vec3d up{0.0, 1.0, 0.0};
};

/// A camera's way through data: key poses with times, a smooth curve in between (cubic Hermite, tangents from the
/// neighbours). docs/frame-time.md has the file's format.
struct Flight
{
    std::vector<FlightKey> keys; ///< two or more, in the order of their times; world space
    double fov = 60.0;           ///< vertical, degrees

    double seconds() const { return keys.back().time - keys.front().time; }
    /// So long after the first key; before it and after the last one these count.
    FlightKey at(double seconds) const;
};

/// Where data stand in a room for a pose: the eye at the rig's first viewer, looking along y with z upwards, at the
/// scale that the rig gives data of these bounds.
mat4d roomFromWorldAt(const FlightKey& pose, const Rig& rig, const Box3d& bounds);

/// Poses that are given as parts of the data's box become world space. Throws Error naming the file and the key.
Flight readFlight(const std::string& path, const Box3d& bounds);

/// One frame of a flight, as it was rendered.
struct FlightFrame
{
    double time = 0.0; ///< seconds after the first key, when it was begun
    double renderSeconds = 0.0;
    double sleepSeconds = 0.0; ///< of the earlier plugin's rule
    FrameLevers levers;
    bool unreachable = false;
    double admitted = 0.0;          ///< the largest error that bounded admits to; 0 of other methods
    std::optional<double> rmsError; ///< against the frame as the user wants it, stretched as windows do
};

struct FlightOptions
{
    double fps = usualFps;
    PixelSize size;
    bool processorTime = false; ///< times are those of the process's one thread, for machines that others use as well
    int measureEvery = 5;       ///< frames whose error is measured, beside the flight's time; 0: none
};

/// Flies in real time: the next frame is that of the moment at which the last one was complete, or of the target's
/// interval after it if it was complete before. Throws Cancelled.
std::vector<FlightFrame> fly(const Renderer& renderer, const RenderSettings& settings, const Flight& flight,
                             const Box3d& bounds, const FlightOptions& options, Progress& progress);

/// The same with the midpoint method and the rule of the earlier plugin (EarlierPluginRule), from dt = 0.5. Ends where
/// dt is no longer positive.
std::vector<FlightFrame> flyByEarlierRule(const Renderer& renderer, const RenderSettings& settings,
                                          const Flight& flight, const Box3d& bounds, const FlightOptions& options,
                                          Progress& progress);

/// What came of a flight.
struct FlownFlight
{
    std::string data;
    std::string wanted; ///< method and parameter, for people
    double seconds = 0.0;
    FlightOptions options;
    std::vector<FlightFrame> frames;
    std::vector<FlightFrame> earlier; ///< by the earlier rule; may be empty
};

/// Parts of the frames after the first second: within 20 % of the target, longer, and shorter than that although
/// rendered as the user wants it, which is no fault.
struct FlightShares
{
    double within = 0.0;
    double longer = 0.0;
    double shorterAtFinest = 0.0;
    double medianRmsError = 0.0; ///< of those that were measured
};
FlightShares sharesOf(const std::vector<FlightFrame>& frames, double targetSeconds, const FrameLevers& finest);

void writeFlightCsv(const std::string& path, const FlownFlight& flown);
void writeFlightSvg(const std::string& path, const FlownFlight& flown);

} // namespace brickwall
