// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Renderer.h"
#include "brickwall/core/shade/TransferFunction.h"

#include <array>
#include <string>

namespace brickwall {

/// What is shown of rendering a view instead of its colours.
enum class Show {
    cost,    ///< evaluations of the field per pixel
    regions, ///< regions visited per pixel
    levels,  ///< the finest level of what a pixel's ray meets of the data and sees; -1 if nothing
    error,   ///< the error that `bounded` admits to have made
};

inline constexpr std::array showNames = {"cost", "regions", "levels", "error"};

struct ShownView
{
    Frame numbers; ///< red, green and blue are the number itself; opaque, no depth
    Frame colors;  ///< the same in the colours of `scale`, which ends above all but a thousandth of the pixels
    TransferFunction scale;
    std::string title;
    double mean = 0.0;
};

/// A picture of numbers, a pixel at a time: the renderer counts per view, and a view may be a single pixel. Takes many
/// times as long as the picture itself. Deterministic. Throws Error for `error` of methods other than bounded, and
/// Cancelled.
ShownView showView(const Renderer& renderer, const View& view, const RenderSettings& settings, Show what,
                   const Executor& executor, Progress& progress);

} // namespace brickwall
