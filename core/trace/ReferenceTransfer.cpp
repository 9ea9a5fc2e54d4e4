// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/ReferenceTransfer.h"

#include <algorithm>
#include <cmath>

namespace brickwall::reference {
namespace {

double valueAt(const TransferFunction& tf, double t)
{
    const double lo = tf.range.lo, hi = tf.range.hi;
    if (t <= 0.0)
        return lo;
    if (t >= 1.0)
        return hi;
    return tf.scale == Scale::linear ? lo + t * (hi - lo) : lo * std::pow(hi / lo, t);
}

/// Positions in [0, 1], in any order.
std::vector<double> positionsOf(const TransferFunction& tf)
{
    std::vector<double> positions{0.0, 1.0};
    for (const ColorPoint& p : tf.colors)
        positions.push_back(p.t);
    for (const OpacityPoint& p : tf.opacity)
        positions.push_back(p.t);
    if (tf.kind == TransferFunction::Kind::extinction || !(tf.opacityScale > 0.0f))
        return positions;
    const double cap = double(TransferFunction::opacityCap) / tf.opacityScale;
    for (std::size_t i = 1; i < tf.opacity.size(); ++i) {
        const OpacityPoint &a = tf.opacity[i - 1], &b = tf.opacity[i];
        if ((a.value < cap) != (b.value < cap))
            positions.push_back(a.t + (cap - a.value) / (double(b.value) - a.value) * (double(b.t) - a.t));
    }
    return positions;
}

} // namespace

Knots::Knots(const TransferFunction& tf)
{
    std::vector<double> positions = positionsOf(tf);
    std::sort(positions.begin(), positions.end());
    positions.erase(std::unique(positions.begin(), positions.end()), positions.end());
    transparent_.push_back(true);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        values_.push_back(valueAt(tf, positions[i]));
        if (i + 1 == positions.size())
            break;
        // Extinction rises with an opacity that is linear here: two zeros inside mean that there is none.
        const double step = positions[i + 1] - positions[i];
        const double a = extinctionAt(tf, valueAt(tf, positions[i] + 0.25 * step));
        const double b = extinctionAt(tf, valueAt(tf, positions[i] + 0.75 * step));
        transparent_.push_back(a == 0.0 && b == 0.0);
        largestExtinction_ = std::max({largestExtinction_, a, b});
    }
    transparent_.push_back(true);
}

std::span<const double> Knots::within(double lo, double hi) const
{
    const auto first = std::upper_bound(values_.begin(), values_.end(), lo);
    const auto last = std::lower_bound(first, values_.end(), hi);
    return {first, last};
}

double Knots::snapped(double value, double noise) const
{
    const auto after = std::lower_bound(values_.begin(), values_.end(), value - noise);
    return after != values_.end() && *after <= value + noise ? *after : value;
}

bool Knots::transparent(double lo, double hi) const
{
    const auto first = std::upper_bound(values_.begin(), values_.end(), lo) - values_.begin();
    const auto last = std::lower_bound(values_.begin(), values_.end(), hi) - values_.begin();
    for (auto i = first; i <= last; ++i)
        if (!transparent_[std::size_t(i)])
            return false;
    return true;
}

} // namespace brickwall::reference
