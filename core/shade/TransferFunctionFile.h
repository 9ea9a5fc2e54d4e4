// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/shade/TransferFunction.h"

#include <string>
#include <vector>

namespace brickwall {

/// Reads a transfer function; the content tells which of the two kinds it is.
///
/// ExaBrick's `.xf`: exactly 128 float32 (little-endian) opacities in [0, 1] at t = i / 127, per finest cell. It has no
/// colours and no range: they are `xfColors` and `xfRange`.
///
/// JSON, an object with
///   "range": [lo, hi]                  values at t = 0 and 1
///   "scale": "linear" | "log"          optional, linear
///   "colors": [[t, r, g, b], ...]      display (sRGB) values in [0, 1] as in ParaView, or the name of a colour map
///   "opacity": [[t, a], ...]           per "reference_length" finest cells (optional, 1), or instead
///   "extinction": [[t, s], ...]        per finest cell
///   "opacity_scale": s                 optional, 1
/// and in place of "opacity" and "extinction" (and with it "range" is optional: all of the window), or besides:
///   "opacity_window": {"center": c, "width": s, "opacity": a}     the shape of OpacityWindow, in values; a optional, 1
///   "color_flat": w                    the colour map is flat around each point, w wide in t (flatAround)
///   "color_field": NAME                colours are those of another field, by
///   "color_range": [lo, hi]            its values at t = 0 and 1, beyond which the map is flat, and
///   "color_scale": "linear" | "log"    optional, linear
/// Between the points colours are interpolated in linear RGB.
///
/// Throws Error naming the file and the line, key or byte.
TransferFunction readTransferFunction(const std::string& path, const std::vector<ColorPoint>& xfColors,
                                      const Range& xfRange);

/// Writes the JSON; `readTransferFunction` gives it back, colours to rounding.
void writeTransferFunction(const TransferFunction& tf, const std::string& path);

/// The same JSON in memory, for files that have a transfer function among other things; `place` is for messages.
TransferFunction transferFunctionOf(const std::string& json, const std::string& place);
std::string toJson(const TransferFunction& tf);

} // namespace brickwall
