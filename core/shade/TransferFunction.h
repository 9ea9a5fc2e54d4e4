// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Range.h"
#include "brickwall/core/base/Vec.h"

#include <optional>
#include <string>
#include <vector>

namespace brickwall {

/// How a value is mapped to t in [0, 1] over the range: linearly, or by its logarithm (range.lo > 0).
enum class Scale { linear, logarithmic };

struct ColorPoint
{
    float t;
    vec3f color; ///< linear RGB, not premultiplied
};

struct OpacityPoint
{
    float t;
    float value; ///< opacity in [0, 1] per reference length, or extinction per finest cell
};

/// Another field than the one that is seen, whose values say in which colour: t is 0 and 1 at the ends of the range,
/// and values beyond an end have its colour.
struct ColorField
{
    std::string name;
    Range range{0.0f, 1.0f};
    Scale scale = Scale::linear;

    bool operator==(const ColorField&) const = default;
};

/// Colour c(v) and extinction sigma(v), both piecewise linear in t in [0, 1]; transparent outside the range.
///
/// Opacity a is meant per `referenceLength` (in finest cells, default 1 as in ExaBrick) and becomes the extinction
/// sigma = -ln(1 - min(a, opacityCap)) / referenceLength per finest cell. Points at equal t make a step. Plain data;
/// copies are cheap.
struct TransferFunction
{
    /// The largest opacity; 1 would be an infinite extinction.
    static constexpr float opacityCap = 0.9999f;

    enum class Kind { opacity, extinction };

    Range range{0.0f, 1.0f};
    Scale scale = Scale::linear;
    std::vector<ColorPoint> colors;    ///< ascending t, at least one
    std::vector<OpacityPoint> opacity; ///< ascending t, at least one; flat beyond the ends, inside [0, 1]
    Kind kind = Kind::opacity;
    float referenceLength = 1.0f;
    float opacityScale = 1.0f; ///< multiplies the points' values, before the cap
    /// What `colors` are of; without it the field itself, over `range`.
    std::optional<ColorField> colorField;
};

/// Throws Error naming `place` if points are missing, unsorted, outside [0, 1], not finite, or the range is empty.
void checkTransferFunction(const TransferFunction& tf, const std::string& place);

/// t of a value; below 0 or above 1 outside the range.
double normalized(const TransferFunction& tf, double value);

/// Exact evaluation in double, for references and legends. `extinction` is 0 outside the range. Colours are those at a
/// value of the colour field, if there is one.
vec3d colorAt(const TransferFunction& tf, double value);
double extinctionAt(const TransferFunction& tf, double value);

/// A transfer function with a colour field, taken apart: the extinction, in white, of the field itself; and the colours
/// as a transfer function of the colour field, with an extinction of 1 throughout its range.
TransferFunction extinctionFunction(const TransferFunction& tf);
TransferFunction colorFunction(const TransferFunction& tf);

/// The sampled form that the stepping methods of the literature look up, as the systems they come from do: linear
/// between `size` entries at t = i / (size - 1), colour and extinction. What is visible at all, TransferIntegral knows.
struct TransferTable
{
    Range range;
    Scale scale = Scale::linear;
    std::vector<vec4f> entries; ///< r, g, b (linear), extinction per finest cell
};

/// Checks `tf`, then samples it at `size` >= 2 entries. The default is 8 x 127 + 1, so that the knots of a `.xf` (128
/// of them) lie on entries. Steps become slopes one entry wide; a peak narrower than an entry may be missed.
TransferTable tabulate(const TransferFunction& tf, int size = 1017);

} // namespace brickwall
