// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/Similarity.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/shade/Srgb.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace brickwall {
namespace {

using Weights = std::array<double, similarityWindow>;

Weights gaussian()
{
    constexpr double deviation = 1.5;
    Weights weights;
    double sum = 0.0;
    for (int i = 0; i < similarityWindow; ++i) {
        const double x = i - similarityWindow / 2;
        weights[std::size_t(i)] = std::exp(-x * x / (2.0 * deviation * deviation));
        sum += weights[std::size_t(i)];
    }
    for (double& weight : weights)
        weight /= sum;
    return weights;
}

/// Values per window: as many as there are places for the window in the picture.
struct Means
{
    const Weights weights = gaussian();
    int width, height; ///< of the picture

    /// The weighted mean of `value(pixel)` over every window, one dimension after the other.
    template <class Value>
    std::vector<double> of(const Value& value) const
    {
        const int columns = width - similarityWindow + 1, rows = height - similarityWindow + 1;
        std::vector<double> alongRows(std::size_t(columns) * height, 0.0), means(std::size_t(columns) * rows, 0.0);
        for (int y = 0; y < height; ++y)
            for (int x = 0; x < columns; ++x)
                for (int k = 0; k < similarityWindow; ++k)
                    alongRows[std::size_t(y) * columns + x] +=
                        weights[std::size_t(k)] * value(std::size_t(y) * width + x + k);
        for (int y = 0; y < rows; ++y)
            for (int k = 0; k < similarityWindow; ++k)
                for (int x = 0; x < columns; ++x)
                    means[std::size_t(y) * columns + x] +=
                        weights[std::size_t(k)] * alongRows[std::size_t(y + k) * columns + x];
        return means;
    }
};

bool isFinite(const Frame& frame)
{
    return std::all_of(frame.color.begin(), frame.color.end(), [](const vec4f& c) {
        return std::isfinite(c.r) && std::isfinite(c.g) && std::isfinite(c.b) && std::isfinite(c.a);
    });
}

std::vector<float> lumaOverBlack(const Frame& frame)
{
    std::vector<float> luma;
    luma.reserve(frame.color.size());
    for (const vec4f& c : frame.color) {
        const auto shown = [](float linear) { return srgbFromLinear(std::clamp(linear, 0.0f, 1.0f)); };
        luma.push_back(0.299f * shown(c.r) + 0.587f * shown(c.g) + 0.114f * shown(c.b));
    }
    return luma;
}

} // namespace

double structuralSimilarity(std::span<const float> a, std::span<const float> b, int width, int height)
{
    const std::size_t pixels = std::size_t(std::max(width, 0)) * std::size_t(std::max(height, 0));
    if (width < similarityWindow || height < similarityWindow || a.size() != pixels || b.size() != pixels)
        throw Error("structural similarity",
                    fmt::format("expected two equal sizes of at least {0} x {0} pixels, found {1} x {2}",
                                similarityWindow, width, height));
    const Means means{.width = width, .height = height};
    const std::vector<double> meanA = means.of([&](std::size_t i) { return double(a[i]); });
    const std::vector<double> meanB = means.of([&](std::size_t i) { return double(b[i]); });
    const std::vector<double> squareA = means.of([&](std::size_t i) { return double(a[i]) * a[i]; });
    const std::vector<double> squareB = means.of([&](std::size_t i) { return double(b[i]) * b[i]; });
    const std::vector<double> product = means.of([&](std::size_t i) { return double(a[i]) * b[i]; });

    constexpr double c1 = 0.01 * 0.01, c2 = 0.03 * 0.03; // (K1 L)^2 and (K2 L)^2 with L = 1
    double sum = 0.0;
    for (std::size_t i = 0; i < meanA.size(); ++i) {
        const double ma = meanA[i], mb = meanB[i];
        const double varianceA = squareA[i] - ma * ma, varianceB = squareB[i] - mb * mb;
        const double covariance = product[i] - ma * mb;
        sum +=
            (2.0 * ma * mb + c1) * (2.0 * covariance + c2) / ((ma * ma + mb * mb + c1) * (varianceA + varianceB + c2));
    }
    return sum / double(meanA.size());
}

double structuralSimilarity(const Frame& a, const Frame& b)
{
    if (a.width != b.width || a.height != b.height)
        throw Error("structural similarity", fmt::format("expected equal sizes, found {} x {} and {} x {}", a.width,
                                                         a.height, b.width, b.height));
    if (!isFinite(a) || !isFinite(b))
        return 0.0;
    return structuralSimilarity(lumaOverBlack(a), lumaOverBlack(b), a.width, a.height);
}

} // namespace brickwall
