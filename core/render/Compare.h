// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Frame.h"

#include <cstdint>

namespace brickwall {

/// How far two frames are apart, over all four components (linear, premultiplied RGBA) of all pixels.
struct FrameDifference
{
    double mean = 0.0; ///< of the absolute differences
    double max = 0.0;  ///< of the absolute differences
    double rms = 0.0;  ///< square root of the mean of the squared differences
    double psnr = 0.0; ///< dB with peak 1: -20 log10(rms); infinite for equal frames
    /// Components that are not finite in either frame. Each counts as infinitely different, so that then mean, max and
    /// rms are infinite and psnr is minus infinity; never a NaN.
    std::uint64_t nonFinite = 0;
};

/// Throws Error if the sizes differ. Depth is not compared.
FrameDifference compareFrames(const Frame& a, const Frame& b);

} // namespace brickwall
