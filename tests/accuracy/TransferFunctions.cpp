// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TransferFunctions.h"

#include "brickwall/core/shade/ColorMaps.h"
#include "brickwall/core/shade/TransferFunctionFile.h"
#include "brickwall/tests/common/ScratchFolder.h"
#include "brickwall/tests/oracles/RandomLayout.h"
#include "brickwall/tests/oracles/WriteExa.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <span>
#include <stdexcept>
#include <utility>

namespace brickwall::test {
namespace {

constexpr int xfEntries = 128;

TransferFunction withOpacity(const Subject& subject, std::vector<OpacityPoint> opacity)
{
    TransferFunction tf;
    tf.range = subject.standard.range;
    tf.scale = subject.standard.scale;
    tf.colors = colorMap("Cool Warm");
    tf.opacity = std::move(opacity);
    return tf;
}

/// A triangle of this width around t = `center`.
TransferFunction window(const Subject& subject, float center, float width, float peak)
{
    const float lo = std::max(center - width / 2, 0.0f), hi = std::min(center + width / 2, 1.0f);
    return withOpacity(subject, {{0.0f, 0.0f}, {lo, 0.0f}, {center, peak}, {hi, 0.0f}, {1.0f, 0.0f}});
}

TransferFunction step(const Subject& subject, float at)
{
    return withOpacity(subject, {{0.0f, 0.0f}, {at, 0.0f}, {at, 1.0f}, {1.0f, 1.0f}});
}

std::array<float, xfEntries> gauss(float center)
{
    std::array<float, xfEntries> opacity{};
    for (int i = 0; i < xfEntries; ++i) {
        const float x = (float(i) / (xfEntries - 1) - center) / 0.02f;
        opacity[std::size_t(i)] = 0.9f * std::exp(-0.5f * x * x);
    }
    return opacity;
}

/// Neighbouring entries have nothing to do with each other, as if painted with a shaking hand.
std::array<float, xfEntries> noisy()
{
    oracles::Random random(128);
    std::array<float, xfEntries> opacity{};
    for (float& a : opacity) {
        const double x = random.real();
        a = float(0.6 * x * x * x * x);
    }
    return opacity;
}

/// As a user has it: in a file.
TransferFunction fromXf(const Subject& subject, const std::array<float, xfEntries>& opacity)
{
    const std::string path = scratchFile("opacity.xf");
    oracles::writeBytes(path, std::as_bytes(std::span(opacity)));
    TransferFunction tf = readTransferFunction(path, colorMap("Cool Warm"), subject.standard.range);
    tf.scale = subject.standard.scale;
    return tf;
}

/// Optically thin and thick at once, and colours with kinks elsewhere.
TransferFunction extinction(const Subject& subject)
{
    TransferFunction tf =
        withOpacity(subject, {{0.0f, 0.02f}, {0.25f, 0.3f}, {0.5f, 0.0f}, {0.9f, 0.4f}, {1.0f, 3.0f}});
    tf.kind = TransferFunction::Kind::extinction;
    tf.colors = {{0.0f, {1.0f, 0.2f, 0.1f}}, {0.4f, {0.1f, 0.9f, 0.3f}}, {1.0f, {0.2f, 0.1f, 1.0f}}};
    tf.referenceLength = 1.0f;
    return tf;
}

/// The range is narrower than the data, and opaque at its very ends.
TransferFunction slab(const Subject& subject)
{
    TransferFunction tf = withOpacity(subject, {{0.0f, 0.3f}, {1.0f, 0.6f}});
    const float lo = valueAt(subject.standard, subject.quantile(0.35));
    const float hi = valueAt(subject.standard, subject.quantile(0.65));
    tf.range = {lo, hi > lo ? hi : subject.standard.range.hi};
    return tf;
}

TransferFunction logarithmic(const Subject& subject)
{
    TransferFunction tf = withOpacity(subject, {});
    if (!(subject.range.lo > 0.0f) || !(subject.range.hi > subject.range.lo))
        return tf;
    tf.range = subject.range;
    tf.scale = Scale::logarithmic;
    tf.opacity = {{0.0f, 0.02f}, {0.3f, 0.0f}, {0.5f, 0.0f}, {0.55f, 0.9f}, {0.6f, 0.0f}, {1.0f, 0.3f}};
    return tf;
}

using Maker = std::function<TransferFunction(const Subject&)>;

const std::vector<std::pair<std::string, Maker>>& makers()
{
    static const std::vector<std::pair<std::string, Maker>> all{
        {"default", [](const Subject& s) { return s.standard; }},
        {"ramp to 0.05",
         [](const Subject& s) {
             return withOpacity(s, {{0.0f, 0.0f}, {1.0f, 0.05f}});
         }},
        {"ramp to 1",
         [](const Subject& s) {
             return withOpacity(s, {{0.0f, 0.0f}, {1.0f, 1.0f}});
         }},
        {"window of 1/200", [](const Subject& s) { return window(s, s.quantile(0.75), 0.005f, 0.9f); }},
        {"Gaussian of 0.02", [](const Subject& s) { return fromXf(s, gauss(s.quantile(0.5))); }},
        {"spike of 1/2000", [](const Subject& s) { return window(s, s.quantile(0.9), 0.0005f, 0.9999f); }},
        {"step to 1", [](const Subject& s) { return step(s, 0.45f); }},
        {"step on a plateau", [](const Subject& s) { return step(s, s.quantile(0.6)); }},
        {"noisy xf", [](const Subject& s) { return fromXf(s, noisy()); }},
        {"extinction", extinction},
        {"cut range", slab},
        {"opaque",
         [](const Subject& s) {
             return withOpacity(s, {{0.0f, 1.0f}, {1.0f, 1.0f}});
         }},
        {"logarithmic", logarithmic}};
    return all;
}

} // namespace

std::vector<std::string> transferFunctionNames()
{
    std::vector<std::string> names;
    for (const auto& [name, make] : makers())
        names.push_back(name);
    return names;
}

TransferFunction transferFunctionNamed(const std::string& name, const Subject& subject)
{
    for (const auto& [known, make] : makers())
        if (known == name)
            return make(subject);
    throw std::invalid_argument("no transfer function " + name);
}

float valueAt(const TransferFunction& tf, double t)
{
    if (tf.scale == Scale::linear)
        return float(tf.range.lo + t * (double(tf.range.hi) - tf.range.lo));
    return float(tf.range.lo * std::pow(double(tf.range.hi) / tf.range.lo, t));
}

} // namespace brickwall::test
