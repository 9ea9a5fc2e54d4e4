// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/TransferFunction.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

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

double normalizedOver(const Range& range, Scale scale, double value)
{
    if (scale == Scale::linear)
        return (value - double(range.lo)) / (double(range.hi) - double(range.lo));
    if (value <= 0.0)
        return -std::numeric_limits<double>::infinity();
    const double lo = std::log(double(range.lo));
    return (std::log(value) - lo) / (std::log(double(range.hi)) - lo);
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

vec3d colorAtT(const TransferFunction& tf, double t)
{
    const Bracket b = bracketOf(tf.colors, t);
    const vec3d lower(tf.colors[b.lower].color);
    return lower + (vec3d(tf.colors[b.upper].color) - lower) * b.f;
}

std::vector<std::vector<float>> maximaOf(const std::vector<vec4f>& entries)
{
    std::vector<std::vector<float>> levels(1);
    for (const vec4f& e : entries)
        levels[0].push_back(e.w);
    for (std::size_t width = 2; width <= entries.size(); width *= 2) {
        const std::vector<float>& half = levels.back();
        std::vector<float> level(entries.size() - width + 1);
        for (std::size_t i = 0; i < level.size(); ++i)
            level[i] = std::max(half[i], half[i + width / 2]);
        levels.push_back(std::move(level));
    }
    return levels;
}

/// The table's extinction between its entries; rounded upwards, so that a bound stays a bound.
float interpolatedUp(const std::vector<vec4f>& entries, double x)
{
    const std::size_t i = std::min(std::size_t(x), entries.size() - 1);
    const std::size_t j = std::min(i + 1, entries.size() - 1);
    const double exact = std::lerp(double(entries[i].w), double(entries[j].w), x - double(i));
    const float rounded = float(exact);
    return double(rounded) >= exact ? rounded : std::nextafter(rounded, std::numeric_limits<float>::infinity());
}

} // namespace

void checkTransferFunction(const TransferFunction& tf, const std::string& place)
{
    const auto& [lo, hi] = tf.range;
    if (!(lo < hi) || !std::isfinite(lo) || !std::isfinite(hi))
        throw Error(place, fmt::format("expected a range with lo < hi, found [{}, {}]", lo, hi));
    if (tf.scale == Scale::logarithmic && !(lo > 0.0f))
        throw Error(place, fmt::format("a logarithmic range has to start above 0, found [{}, {}]", lo, hi));
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
    return normalizedOver(tf.range, tf.scale, value);
}

vec3d colorAt(const TransferFunction& tf, double value)
{
    return colorAtT(tf, normalized(tf, value));
}

double extinctionAt(const TransferFunction& tf, double value)
{
    const double t = normalized(tf, value);
    return t >= 0.0 && t <= 1.0 ? extinctionAtT(tf, t) : 0.0;
}

float TransferTable::largestExtinction(const Range& r) const
{
    const double t0 = normalizedOver(range, scale, r.lo);
    const double t1 = normalizedOver(range, scale, r.hi);
    if (!(t0 <= t1 && t1 >= 0.0 && t0 <= 1.0))
        return 0.0f;
    const double last = double(entries.size() - 1);
    const double x0 = std::max(t0, 0.0) * last;
    const double x1 = std::min(t1, 1.0) * last;
    const float ends = std::max(interpolatedUp(entries, x0), interpolatedUp(entries, x1));

    const auto first = std::size_t(std::ceil(x0));
    const auto end = std::size_t(std::floor(x1)) + 1;
    if (first >= end)
        return ends;
    const std::size_t k = std::bit_width(end - first) - 1;
    return std::max({ends, maxExtinction[k][first], maxExtinction[k][end - (std::size_t(1) << k)]});
}

TransferTable tabulate(const TransferFunction& tf, int size)
{
    if (size < 2)
        throw Error("transfer function", fmt::format("expected a table of 2 entries or more, found {}", size));
    checkTransferFunction(tf, "transfer function");
    TransferTable table{tf.range, tf.scale, std::vector<vec4f>(std::size_t(size)), {}};
    for (int i = 0; i < size; ++i) {
        const double t = double(i) / (size - 1);
        table.entries[std::size_t(i)] = vec4f(vec3f(colorAtT(tf, t)), float(extinctionAtT(tf, t)));
    }
    table.maxExtinction = maximaOf(table.entries);
    return table;
}

} // namespace brickwall
