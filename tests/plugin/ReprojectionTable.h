// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "WarpTesting.h"

#include "brickwall/core/render/ImageFiles.h"

#include <map>
#include <string>
#include <tuple>
#include <vector>

namespace brickwall::test {

/// How far warped pictures of a CAVE are from the true ones, over all pixels of all of its screens.
struct WarpError
{
    double squared = 0.0; ///< sum over the components, in sRGB steps of 1/255
    std::int64_t components = 0;
    std::int64_t seen = 0;  ///< pixels that show something in the true picture, with an opacity of 0.02 or more
    std::int64_t holes = 0; ///< of these, those that no pixel of the image covers

    double psnr() const; ///< dB
    double holeShare() const { return seen ? double(holes) / double(seen) : 0.0; }
};

/// By the views that a channel shows, mode, and offset of the eye in metres.
using WarpErrors = std::map<std::tuple<MultiChannelDrawer::ViewSelection, MultiChannelDrawer::Mode, double>, WarpError>;

inline const std::vector<double> eyeOffsets = {0.01, 0.02, 0.05, 0.1};
/// AsIs and all that reproject.
std::vector<NamedMode> comparedModes();

/// The five screens of `cave5`, with `size` pixels across each, rendered for the left eye and shown for one that has
/// moved by every offset to the right, upwards and forward. If `picture` is given, it becomes one of the front screen,
/// 5 cm to the right, in all modes side by side.
WarpErrors measureWarp(const std::string& sample, int size, Image* picture = nullptr);

} // namespace brickwall::test
