// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/Rig.h"

#include <span>

namespace brickwall {

struct WindowSize
{
    int width = 0;
    int height = 0;

    bool operator==(const WindowSize&) const = default;
};

/// The rig with its windows at other sizes, one size per window. Everything in a window is scaled by the same factor,
/// the largest that fits, and centred: pixels keep their shape, the rest of the window stays black. Where a screen has
/// pixels of its own, they are scaled with the channel that shows them. Channels without head tracking (fixedViewer)
/// keep looking at `rig`'s pose of their viewer when the other poses are replaced later: each gets a viewer of its own,
/// at the end.
Rig layoutOf(const Rig& rig, std::span<const WindowSize> sizes);

/// The windows' own sizes times a factor, at least one pixel.
std::vector<WindowSize> windowSizes(const Rig& rig, double factor);

} // namespace brickwall
