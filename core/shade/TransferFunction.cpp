// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/TransferFunction.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brickwall {
namespace {

template <class Point>
void checkAscending(const std::vector<Point>& points, const std::string& place, std::string_view what)
{
    if (points.empty())
        throw Error(place, fmt::format("expected at least one {} point, found none", what));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float t = points[i].t;
        if (!(t >= 0.0f && t <= 1.0f))
            throw Error(place, fmt::format("{} point {}: expected t in [0, 1], found {}", what, i, t));
        if (i > 0 && t < points[i - 1].t)
            throw Error(place, fmt::format("{} point {}: expected t to ascend, found {} after {}", what, i, t,
                                           points[i - 1].t));
    }
}

void checkPositive(float value, const std::string& place, std::string_view what)
{
    if (!(value > 0.0f && std::isfinite(value)))
        throw Error(place, fmt::format("expected a positive {}, found {}", what, value));
}

/// Where t lies among points with ascending t: the weight of `upper` is `f`. Continuous from the right at a step.
struct Bracket
{
    std::size_t lower;
    std::size_t upper;
    double f;
};

template <class Point>
Bracket bracketOf(const std::vector<Point>& points, double t)
{
    const auto after =
        std::upper_bound(points.begin(), points.end(), t, [](double x, const Point& p) { return x < double(p.t); });
    const std::size_t upper = std::size_t(after - points.begin());
    if (upper == 0)
        return {0, 0, 0.0};
    if (upper == points.size())
        return {upper - 1, upper - 1, 0.0};
    const double a = points[upper - 1].t;
    return {upper - 1, upper, (t - a) / (double(points[upper].t) - a)};
}

double extinctionAtT(const TransferFunction& tf, double t)
{
    const Bracket b = bracketOf(tf.opacity, t);
    const double lower = tf.opacity[b.lower].value;
    const double value = (lower + (double(tf.opacity[b.upper].value) - lower) * b.f) * tf.opacityScale;
    if (tf.kind == TransferFunction::Kind::extinction)
        return value;
    return -std::log1p(-std::min(value, double(TransferFunction::opacityCap))) / tf.referenceLength;
}

double normalizedIn(const Range& range, Scale scale, double value)
{
    const double lo = range.lo, hi = range.hi;
    if (scale == Scale::linear)
        return (value - lo) / (hi - lo);
    if (value <= 0.0)
        return -std::numeric_limits<double>::infinity();
    return (std::log(value) - std::log(lo)) / (std::log(hi) - std::log(lo));
}

void checkRange(const Range& range, Scale scale, const std::string& place)
{
    const auto& [lo, hi] = range;
    if (!(lo < hi) || !std::isfinite(lo) || !std::isfinite(hi))
        throw Error(place, fmt::format("expected a range with lo < hi, found [{}, {}]", lo, hi));
    constexpr float narrowest = 1e-34f; // values closer than this have no reciprocals that leave room for slopes
    if (hi - lo < narrowest)
        throw Error(place, fmt::format("expected a range of at least {:g}, found [{:g}, {:g}], which is too narrow "
                                       "for 32-bit floats: use data in other units",
                                       narrowest, lo, hi));
    if (scale == Scale::logarithmic && !(lo > 0.0f))
        throw Error(place, fmt::format("a logarithmic range has to start above 0, found [{}, {}]", lo, hi));
}

vec3d colorAtT(const TransferFunction& tf, double t)
{
    const Bracket b = bracketOf(tf.colors, t);
    const vec3d lower(tf.colors[b.lower].color);
    return lower + (vec3d(tf.colors[b.upper].color) - lower) * b.f;
}

} // namespace

void checkTransferFunction(const TransferFunction& tf, const std::string& place)
{
    checkRange(tf.range, tf.scale, place);
    if (tf.colorField)
        checkRange(tf.colorField->range, tf.colorField->scale, place);
    checkPositive(tf.referenceLength, place, "reference length");
    if (!(tf.opacityScale >= 0.0f && std::isfinite(tf.opacityScale)))
        throw Error(place, fmt::format("expected an opacity scale of 0 or more, found {}", tf.opacityScale));

    checkAscending(tf.colors, place, "colour");
    for (std::size_t i = 0; i < tf.colors.size(); ++i)
        for (int c = 0; c < 3; ++c)
            if (const float v = tf.colors[i].color[c]; !(v >= 0.0f && v <= 1.0f))
                throw Error(place, fmt::format("colour point {}: expected components in [0, 1], found {}", i, v));

    const bool isOpacity = tf.kind == TransferFunction::Kind::opacity;
    const std::string_view what = isOpacity ? "opacity" : "extinction";
    checkAscending(tf.opacity, place, what);
    for (std::size_t i = 0; i < tf.opacity.size(); ++i)
        if (const float v = tf.opacity[i].value; !(v >= 0.0f && std::isfinite(v)) || (isOpacity && v > 1.0f))
            throw Error(place, fmt::format("{} point {}: expected a value {}, found {}", what, i,
                                           isOpacity ? "in [0, 1]" : "of 0 or more", v));
}

double normalized(const TransferFunction& tf, double value)
{
    return normalizedIn(tf.range, tf.scale, value);
}

vec3d colorAt(const TransferFunction& tf, double value)
{
    return colorAtT(tf, tf.colorField ? normalizedIn(tf.colorField->range, tf.colorField->scale, value)
                                      : normalized(tf, value));
}

double extinctionAt(const TransferFunction& tf, double value)
{
    const double t = normalized(tf, value);
    return t >= 0.0 && t <= 1.0 ? extinctionAtT(tf, t) : 0.0;
}

TransferFunction extinctionFunction(const TransferFunction& tf)
{
    TransferFunction white = tf;
    white.colors = {{0.0f, vec3f(1.0f)}};
    white.colorField.reset();
    return white;
}

TransferFunction colorFunction(const TransferFunction& tf)
{
    TransferFunction colors;
    colors.range = tf.colorField ? tf.colorField->range : tf.range;
    colors.scale = tf.colorField ? tf.colorField->scale : tf.scale;
    colors.colors = tf.colors;
    colors.opacity = {{0.0f, 1.0f}};
    colors.kind = TransferFunction::Kind::extinction;
    return colors;
}

TransferTable tabulate(const TransferFunction& tf, int size)
{
    if (size < 2)
        throw Error("transfer function", fmt::format("expected a table of 2 entries or more, found {}", size));
    checkTransferFunction(tf, "transfer function");
    TransferTable table{tf.range, tf.scale, std::vector<vec4f>(std::size_t(size))};
    for (int i = 0; i < size; ++i) {
        const double t = double(i) / (size - 1);
        table.entries[std::size_t(i)] = vec4f(vec3f(colorAtT(tf, t)), float(extinctionAtT(tf, t)));
    }
    return table;
}

} // namespace brickwall
