// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/ImageFiles.h"
#include "brickwall/core/shade/TransferFunction.h"

#include <string>
#include <vector>

namespace brickwall {

/// Draws a colour bar with ticks and labels into the lower right of an image, on a darkened panel, so that it can be
/// read on any background. It grows with the image (one pixel of the font is about 1/360 of its shorter side). What
/// does not fit is cut off at the image's edge; a long title is shortened with "..". Characters outside ASCII become
/// '?'.
///
/// `title` is usually the field's name; `unit` may be empty.
void drawLegend(Image& image, const TransferFunction& tf, const std::string& title, const std::string& unit);

struct Tick
{
    double value;
    double t; ///< in [0, 1] along the bar
    std::string label;
};

/// Round values inside the range, ascending, at most `most` (at least 2): multiples of 1, 2 or 5 times a power of ten,
/// or powers of ten on a logarithmic range of two decades and more. Labels tell neighbours apart.
std::vector<Tick> ticksOf(const TransferFunction& tf, int most);

} // namespace brickwall
