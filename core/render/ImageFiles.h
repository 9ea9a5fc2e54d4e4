// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Frame.h"

#include <cstdint>
#include <string>
#include <vector>

namespace brickwall {

/// A picture for people and for PNG files. Row 0 is the TOP row, the other way round than in a frame.
struct Image
{
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgba; ///< sRGB, alpha not premultiplied, 4 bytes per pixel

    std::size_t index(int x, int y) const { return 4 * (std::size_t(y) * width + x); }
};

/// The frame over a background (linear RGB): C + (1 - A) background, then the sRGB curve; opaque. Components outside
/// [0, 1] are cut off as a display does; pixels with a NaN become magenta, so that a defect is seen.
Image imageOver(const Frame& frame, const vec3f& background);

/// The frame alone, with its opacity as alpha, for other programs to put over something.
Image imageOf(const Frame& frame);

/// All files are written under a temporary name and renamed. Throws Error with the path and the reason.
/// RGBA with 8 bits, or RGB if every pixel is opaque.
void writePng(const Image& image, const std::string& path);

/// Any PNG as 8-bit RGBA. Throws Error.
Image readPng(const std::string& path);

/// Linear, premultiplied R, G, B, A and the window depth Z, all float32, nothing lost but the view.
void writeExr(const Frame& frame, const std::string& path);

/// What writeExr wrote, and EXR files like it: R, G, B are needed; without A the frame is opaque, without Z its depth
/// is 1. The view is left empty. Throws Error.
Frame readExr(const std::string& path);

} // namespace brickwall
