// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"
#include "brickwall/core/render/ImageFiles.h"

#include <string>

namespace brickwall {

/// Height of a line, and of its letters from their top, in font pixels.
inline constexpr int textLineHeight = 12;
inline constexpr int textCapHeight = 7;

/// In font pixels.
int textWidth(const std::string& text);

/// `color` (sRGB, 0..255) with an opacity over a rectangle's pixels; what lies outside the image is left out.
void fillRect(Image& image, int x, int y, int width, int height, const vec3i& color, float opacity);

/// A line of text with the top of its letters at y; a font pixel is `scale` pixels wide.
void drawText(Image& image, int x, int y, int scale, const std::string& text, const vec3i& color);

} // namespace brickwall
