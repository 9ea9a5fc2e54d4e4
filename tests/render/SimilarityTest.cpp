// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/Similarity.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/shade/Srgb.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

namespace brickwall {
namespace {

using Picture = std::vector<float>;

constexpr double c1 = 1e-4, c2 = 9e-4;

Picture noise(std::size_t pixels, unsigned seed)
{
    std::mt19937 random(seed);
    Picture picture;
    for (std::size_t i = 0; i < pixels; ++i)
        picture.push_back(float(random() % 1000) / 999.0f);
    return picture;
}

/// Word for word as the paper says it: every window on its own, centred moments.
double similarityByDefinition(const Picture& a, const Picture& b, int width, int height)
{
    double total = 0.0;
    int windows = 0;
    for (int y0 = 0; y0 + 11 <= height; ++y0)
        for (int x0 = 0; x0 + 11 <= width; ++x0, ++windows) {
            const auto over = [&](const auto& value) {
                double sum = 0.0, weights = 0.0;
                for (int y = 0; y < 11; ++y)
                    for (int x = 0; x < 11; ++x) {
                        const double w = std::exp(-((x - 5) * (x - 5) + (y - 5) * (y - 5)) / 4.5);
                        sum += w * value(std::size_t((y0 + y) * width + x0 + x));
                        weights += w;
                    }
                return sum / weights;
            };
            const double ma = over([&](std::size_t i) { return a[i]; });
            const double mb = over([&](std::size_t i) { return b[i]; });
            const double va = over([&](std::size_t i) { return (a[i] - ma) * (a[i] - ma); });
            const double vb = over([&](std::size_t i) { return (b[i] - mb) * (b[i] - mb); });
            const double vab = over([&](std::size_t i) { return (a[i] - ma) * (b[i] - mb); });
            total += (2 * ma * mb + c1) * (2 * vab + c2) / ((ma * ma + mb * mb + c1) * (va + vb + c2));
        }
    return total / windows;
}

Frame frameOf(int width, int height, const vec4f& color)
{
    Frame frame;
    frame.width = width;
    frame.height = height;
    frame.color.assign(std::size_t(width) * height, color);
    return frame;
}

} // namespace

TEST(Similarity, EqualPicturesHaveOne)
{
    const Picture a = noise(20 * 15, 1);
    EXPECT_NEAR(structuralSimilarity(a, a, 20, 15), 1.0, 1e-12);
}

TEST(Similarity, FlatPicturesHaveTheLuminanceTerm)
{
    const Picture a(16 * 16, 0.5f), b(16 * 16, 0.25f);
    const double expected = (2 * 0.5 * 0.25 + c1) / (0.25 + 0.0625 + c1);
    EXPECT_NEAR(structuralSimilarity(a, b, 16, 16), expected, 1e-12);
    const Picture white(16 * 16, 1.0f), black(16 * 16, 0.0f);
    EXPECT_NEAR(structuralSimilarity(white, black, 16, 16), c1 / (1.0 + c1), 1e-12);
}

TEST(Similarity, AConstantShiftLeavesStructureAlone)
{
    // Stripes finer than the window: all windows have nearly the same mean, and variance and covariance are those of
    // the unshifted picture.
    Picture a(22 * 22), b;
    for (std::size_t i = 0; i < a.size(); ++i)
        a[i] = i % 2 ? 0.5f : 0.3f;
    for (const float v : a)
        b.push_back(v + 0.2f);
    EXPECT_NEAR(structuralSimilarity(a, b, 22, 22), (2 * 0.4 * 0.6 + c1) / (0.16 + 0.36 + c1), 1e-4);
}

TEST(Similarity, TheNegativeIsNegative)
{
    Picture a(22 * 22), b;
    for (std::size_t i = 0; i < a.size(); ++i)
        a[i] = i % 2 ? 0.6f : 0.4f;
    for (const float v : a)
        b.push_back(1.0f - v);
    EXPECT_NEAR(structuralSimilarity(a, b, 22, 22), (-2 * 0.01 + c2) / (2 * 0.01 + c2), 1e-4);
}

TEST(Similarity, IsThatOfThePaperOnNoise)
{
    const Picture a = noise(17 * 23, 2);
    Picture b = noise(17 * 23, 3);
    for (std::size_t i = 0; i < b.size(); ++i)
        b[i] = 0.7f * a[i] + 0.3f * b[i];
    const double similarity = structuralSimilarity(a, b, 17, 23);
    EXPECT_NEAR(similarity, similarityByDefinition(a, b, 17, 23), 1e-9);
    EXPECT_NEAR(similarity, structuralSimilarity(b, a, 17, 23), 1e-12);
    EXPECT_LT(similarity, 0.99);
}

TEST(Similarity, OfFramesIsThatOfTheirLumaOverBlack)
{
    const Frame red = frameOf(12, 12, {0.25f, 0.0f, 0.0f, 0.5f}), grey = frameOf(12, 12, vec4f(0.25f));
    const double coded = srgbFromLinear(0.25), luma = 0.299 * coded;
    EXPECT_NEAR(structuralSimilarity(red, grey), (2 * luma * coded + c1) / (luma * luma + coded * coded + c1), 1e-6);
    // What a display cuts off is no difference.
    EXPECT_NEAR(structuralSimilarity(frameOf(12, 12, vec4f(1.0f)), frameOf(12, 12, vec4f(7.0f))), 1.0, 1e-12);
}

TEST(Similarity, NanIsLikeNothing)
{
    Frame frame = frameOf(12, 12, vec4f(0.5f));
    frame.color[17].a = NAN;
    EXPECT_EQ(structuralSimilarity(frame, frame), 0.0);
}

TEST(Similarity, RefusesPicturesSmallerThanItsWindowAndOfOtherSizes)
{
    EXPECT_THROW(structuralSimilarity(frameOf(10, 40, vec4f(0.5f)), frameOf(10, 40, vec4f(0.5f))), Error);
    EXPECT_THROW(structuralSimilarity(frameOf(20, 40, vec4f(0.5f)), frameOf(40, 20, vec4f(0.5f))), Error);
    EXPECT_THROW(structuralSimilarity(Picture(144), Picture(143), 12, 12), Error);
}

} // namespace brickwall
