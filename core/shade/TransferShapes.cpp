// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/TransferShapes.h"

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

constexpr double height = 1.6; ///< of the Gaussian that is cut off at 1
constexpr double reach = 2.0;  ///< in widths
constexpr int flankPoints = 32;

/// The opacity at x widths from the centre, of a plateau of 1.
double opacityAt(double x)
{
    return std::min(1.0, height * std::exp(-0.5 * x * x));
}

/// In widths from the centre, ascending.
std::vector<double> positions()
{
    const double plateau = std::sqrt(2.0 * std::log(height));
    std::vector<double> right;
    for (int i = 0; i <= flankPoints; ++i)
        right.push_back(std::lerp(plateau, reach, double(i) / flankPoints));
    std::vector<double> all;
    for (auto x = right.rbegin(); x != right.rend(); ++x)
        all.push_back(-*x);
    all.insert(all.end(), right.begin(), right.end());
    return all;
}

} // namespace

std::vector<ColorPoint> flatAround(std::span<const ColorPoint> points, float width)
{
    const float half = 0.5f * width;
    std::vector<ColorPoint> flat;
    for (std::size_t i = 0; i < points.size(); ++i) {
        const float t = points[i].t;
        const float below = i > 0 ? 0.5f * (points[i - 1].t + t) : 0.0f;
        const float above = i + 1 < points.size() ? 0.5f * (t + points[i + 1].t) : 1.0f;
        flat.push_back({std::max(t - half, below), points[i].color});
        flat.push_back({std::min(t + half, above), points[i].color});
    }
    return flat;
}

Range rangeOf(const OpacityWindow& window)
{
    return {static_cast<float>(window.center - reach * window.width),
            static_cast<float>(window.center + reach * window.width)};
}

std::vector<OpacityPoint> opacityPoints(const OpacityWindow& window, const Range& range, Scale scale)
{
    TransferFunction tf; // for its t
    tf.range = range;
    tf.scale = scale;
    const auto tOf = [&](double x) { return normalized(tf, window.center + x * window.width); };
    const double first = tOf(-reach), last = tOf(reach);
    if (!(first < 1.0 && last > 0.0))
        return {{0.0f, 0.0f}};
    // A window that ends where the range does, but for rounding, ends with it.
    const double rounding = (std::min(last, 1.0) - std::max(first, 0.0)) / 400.0;
    std::vector<OpacityPoint> points;
    const auto add = [&](double t, double opacity) {
        points.push_back({static_cast<float>(std::clamp(t, 0.0, 1.0)), static_cast<float>(opacity * window.opacity)});
    };
    const auto atEnd = [&](double value) { return opacityAt((value - window.center) / window.width); };
    if (first > rounding)
        add(first, 0.0);
    else if (first < -rounding)
        add(0.0, atEnd(range.lo));
    for (const double x : positions())
        if (const double t = tOf(x); t > -rounding && t < 1.0 + rounding)
            add(t, opacityAt(x));
    if (last < 1.0 - rounding)
        add(last, 0.0);
    else if (last > 1.0 + rounding)
        add(1.0, atEnd(range.hi));
    return points;
}

} // namespace brickwall
