// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/FrameRate.h"

#include "brickwall/channels/RigFilesText.h"
#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

namespace brickwall {

std::optional<double> parseFps(const std::string& text, const std::string& place)
{
    if (text == "off")
        return std::nullopt;
    const std::optional<double> fps = parseNumber(text);
    if (!fps || !(*fps >= lowestFps && *fps <= highestFps))
        throw Error(place, fmt::format("expected {:g} to {:g} frames per second, or off, found {}", lowestFps,
                                       highestFps, text));
    return fps;
}

} // namespace brickwall
