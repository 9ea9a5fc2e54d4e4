// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/DefaultTransferFunction.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/shade/CellSample.h"
#include "brickwall/core/shade/ColorMaps.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace brickwall {
namespace {

using Sample = std::span<const SampledCell>;

constexpr std::size_t knotCount = 64;
using Knots = std::array<double, knotCount>;

/// What of the depth is spread evenly, so that the outline of the data can be guessed.
constexpr double hazeDepth = 0.01;
/// The largest optical depth of what is shown, were it all gathered in one cube: thin shells in a large domain would
/// otherwise be walls, because they alone have to make up the mean depth.
constexpr double gatheredDepth = 4.0;
/// Per finest cell; more is a solid wall on any screen.
constexpr double largestExtinction = 5.0;
/// How rare a value is counts down to this part of the most common one.
constexpr double rarest = 1e-5;

bool spansDecades(const Range& r)
{
    return r.lo > 0.0f && double(r.hi) / r.lo > 1000.0;
}

/// Without outliers, if they alone would make the range three times as wide.
Range robust(const Range& full, Sample sample, bool logarithmic)
{
    constexpr double tail = 0.0005;
    std::vector<float> values;
    for (const SampledCell& s : sample)
        values.push_back(s.value);
    std::sort(values.begin(), values.end());
    const auto at = [&](double q) { return double(values[std::size_t(q * double(values.size() - 1))]); };
    const auto coordinate = [&](double v) { return logarithmic ? std::log(v) : v; };
    const double lo = coordinate(at(tail));
    const double hi = coordinate(at(1.0 - tail));
    const double fullLo = coordinate(full.lo);
    const double fullHi = coordinate(full.hi);
    if (!(hi > lo) || fullHi - fullLo <= 3.0 * (hi - lo))
        return full;
    const double margin = 0.1 * (hi - lo);
    const auto value = [&](double c) { return float(logarithmic ? std::exp(c) : c); };
    const Range inner{value(lo - margin), value(hi + margin)};
    return {std::max(full.lo, inner.lo), std::min(full.hi, inner.hi)};
}

/// A range around a single value: the smallest that is safely one in float.
Range around(float v)
{
    const float margin = std::max(std::abs(v) * 1e-3f, 1e-30f);
    return {v - margin, v + margin};
}

/// The volume near each knot, as part of the largest such volume.
Knots commonness(const TransferFunction& tf, Sample sample)
{
    Knots volume{};
    for (const SampledCell& s : sample) {
        const double x = normalized(tf, s.value) * double(knotCount - 1);
        if (!(x >= 0.0 && x <= double(knotCount - 1)))
            continue;
        const std::size_t i = std::min(std::size_t(x), knotCount - 2);
        volume[i] += s.volume * (1.0 - (x - double(i)));
        volume[i + 1] += s.volume * (x - double(i));
    }
    Knots smooth{};
    for (std::size_t i = 0; i < knotCount; ++i) {
        const double before = i > 0 ? volume[i - 1] : 0.0;
        const double after = i + 1 < knotCount ? volume[i + 1] : 0.0;
        const double reached = i > 0 && i + 1 < knotCount ? 1.0 : 0.75; // the end knots have values on one side only
        smooth[i] = (0.25 * before + 0.5 * volume[i] + 0.25 * after) / reached;
    }
    const double largest = *std::max_element(smooth.begin(), smooth.end());
    for (double& v : smooth)
        v /= largest > 0.0 ? largest : 1.0;
    return smooth;
}

/// 0 for the most common values, 1 for the rarest. Values that no cell has, but that interpolation between cells passes
/// through, are taken as in between, not as rare: a step in the data is no feature of its own.
Knots rarity(const Knots& common)
{
    Knots result{};
    std::ptrdiff_t known = -1;
    for (std::size_t i = 0; i < knotCount; ++i) {
        if (common[i] <= 0.0)
            continue;
        const double r = std::clamp(std::log(common[i]) / std::log(rarest), 0.0, 1.0);
        result[i] = r * r * std::sqrt(r);
        for (std::size_t k = std::size_t(known + 1); k < i; ++k) {
            const double f = known < 0 ? 1.0 : double(k - std::size_t(known)) / double(i - std::size_t(known));
            result[k] = known < 0 ? result[i] : std::lerp(result[std::size_t(known)], result[i], f);
        }
        known = std::ptrdiff_t(i);
    }
    for (std::size_t k = std::size_t(known + 1); known >= 0 && k < knotCount; ++k)
        result[k] = result[std::size_t(known)];
    return result;
}

/// The extinction of all cells together, each by its volume.
double totalExtinction(Sample sample, const TransferFunction& tf)
{
    double sum = 0.0;
    for (const SampledCell& s : sample)
        sum += s.volume * extinctionAt(tf, s.value);
    return sum;
}

/// The mean optical depth along the diagonal for a total extinction.
double depthOf(const Model& model, double total)
{
    const vec3d extent(voxelBounds(model.bricks).extent());
    return total / (extent.x * extent.y * extent.z) *
           std::sqrt(extent.x * extent.x + extent.y * extent.y + extent.z * extent.z);
}

/// Sets the extinction: `shape` and an even haze, scaled to the depth wanted.
void setExtinction(TransferFunction& tf, const Knots& shape, const Model& model, Sample sample)
{
    tf.kind = TransferFunction::Kind::extinction;
    const auto set = [&](double scale, double haze) {
        tf.opacity.clear();
        for (std::size_t i = 0; i < knotCount; ++i)
            tf.opacity.push_back(
                {float(double(i) / (knotCount - 1)), float(std::min(shape[i] * scale + haze, largestExtinction))});
    };
    set(1.0, 0.0);
    const double shown = totalExtinction(sample, tf); // voxels, weighted by the shape
    const double shapeDepth = depthOf(model, shown);
    set(0.0, 1.0);
    const double evenDepth = depthOf(model, totalExtinction(sample, tf));
    const bool flat = !(shapeDepth > 1e-6 * evenDepth); // nothing is rare: all of it is worth seeing
    const double haze = (flat ? defaultOpticalDepth : hazeDepth) / evenDepth;
    const double scale = std::min((defaultOpticalDepth - hazeDepth) / shapeDepth, gatheredDepth / std::cbrt(shown));
    set(flat ? 0.0 : scale, haze);
}

std::string explain(const Field& field, const TransferFunction& tf, const Knots& common, bool cut)
{
    const bool logarithmic = tf.scale == Scale::logarithmic;
    const double t = double(std::max_element(common.begin(), common.end()) - common.begin()) / (knotCount - 1);
    const double lo = tf.range.lo;
    const double hi = tf.range.hi;
    const double background = logarithmic ? lo * std::pow(hi / lo, t) : std::lerp(lo, hi, t);
    std::string line = field.name;
    if (logarithmic)
        line += fmt::format(" spans {:.1f} decades: logarithmic", std::log10(hi / lo));
    else
        line += ": linear";
    line += fmt::format(" range {:.3g}..{:.3g}{}", lo, hi, field.unit.empty() ? "" : " " + field.unit);
    if (cut)
        line += " without the outermost 0.1 % of the cells";
    return line + fmt::format("; the most common values, near {:.3g}, are nearly transparent", background);
}

} // namespace

double meanOpticalDepth(const Model& model, const Field& field, const TransferFunction& tf)
{
    return depthOf(model, totalExtinction(sampleCells(model, field, sampledForDefault), tf));
}

DefaultChoice chooseTransferFunction(const Model& model, const Field& field, std::string_view colorMapName)
{
    Field known = Field{field.name, field.unit, {}, field.range, field.preferredRange};
    if (known.range.empty())
        known.range = rangeOf(field.values);
    return chooseTransferFunction(model, known, sampleCells(model, field, sampledForDefault), colorMapName);
}

DefaultChoice chooseTransferFunction(const Model& model, const Field& field, std::span<const SampledCell> sample,
                                     std::string_view colorMapName)
{
    if (sample.empty())
        throw Error(field.name, "the field has no values to choose a transfer function from");
    DefaultChoice choice;
    TransferFunction& tf = choice.tf;
    tf.colors = colorMap(colorMapName);
    const Range full = field.range;
    if (full.lo == full.hi) {
        tf.range = around(full.lo);
        setExtinction(tf, Knots{}, model, sample);
        choice.explanation = fmt::format("{} is {:.6g} everywhere: shown as a haze", field.name, full.lo);
        return choice;
    }
    const bool preferred = field.preferredRange.lo < field.preferredRange.hi;
    tf.range = preferred ? field.preferredRange : robust(full, sample, spansDecades(full));
    tf.scale = spansDecades(tf.range) ? Scale::logarithmic : Scale::linear;
    const Knots common = commonness(tf, sample);
    setExtinction(tf, rarity(common), model, sample);
    choice.explanation = explain(field, tf, common, !preferred && tf.range != full);
    return choice;
}

} // namespace brickwall
