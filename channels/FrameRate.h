// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <algorithm>
#include <optional>
#include <string>

namespace brickwall {

/// What users may ask for, and what they get if they do not: frames per second.
inline constexpr double lowestFps = 5.0, highestFps = 60.0, usualFps = 20.0;

/// The nearest that may be asked for; of what is no number the highest.
inline double withinFps(double fps)
{
    return std::max(lowestFps, std::min(highestFps, fps));
}

/// What a user has written: a number within the limits, or "off", which is no value. Throws Error at `place` for
/// anything else.
std::optional<double> parseFps(const std::string& text, const std::string& place);

} // namespace brickwall
