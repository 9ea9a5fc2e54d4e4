// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/Compare.h"

#include "brickwall/core/base/Error.h"

#include <gtest/gtest.h>

#include <cmath>

namespace brickwall {
namespace {

Frame grey(int width, int height, float value)
{
    Frame frame;
    frame.width = width;
    frame.height = height;
    frame.color.assign(std::size_t(width) * height, vec4f(value));
    return frame;
}

} // namespace

TEST(Compare, EqualFramesAreInfinitelyAlike)
{
    const FrameDifference d = compareFrames(grey(4, 3, 0.3f), grey(4, 3, 0.3f));
    EXPECT_EQ(d.mean, 0.0);
    EXPECT_EQ(d.max, 0.0);
    EXPECT_EQ(d.rms, 0.0);
    EXPECT_EQ(d.psnr, INFINITY);
    EXPECT_EQ(d.nonFinite, 0u);
}

TEST(Compare, ConstantOffsetHasItsClosedForm)
{
    const FrameDifference d = compareFrames(grey(4, 3, 0.25f), grey(4, 3, 0.35f));
    EXPECT_NEAR(d.mean, 0.1, 1e-7);
    EXPECT_NEAR(d.max, 0.1, 1e-7);
    EXPECT_NEAR(d.rms, 0.1, 1e-7);
    EXPECT_NEAR(d.psnr, 20.0, 1e-5); // -20 log10(0.1)
}

TEST(Compare, OneComponentOfOnePixelCounts)
{
    Frame frame = grey(10, 10, 0.5f);
    frame.color[37].w = 0.9f;
    const FrameDifference d = compareFrames(grey(10, 10, 0.5f), frame);
    EXPECT_NEAR(d.max, 0.4, 1e-6);
    EXPECT_NEAR(d.mean, 0.4 / 400.0, 1e-8);
    EXPECT_NEAR(d.rms, 0.4 / 20.0, 1e-7);
    EXPECT_NEAR(d.psnr, -10.0 * std::log10(0.16 / 400.0), 1e-4);
}

TEST(Compare, NanIsInfinitelyDifferentEvenFromItself)
{
    Frame frame = grey(2, 2, 0.5f);
    frame.color[3].y = NAN;
    for (const Frame& other : {grey(2, 2, 0.5f), frame}) {
        const FrameDifference d = compareFrames(frame, other);
        EXPECT_EQ(d.nonFinite, 1u);
        EXPECT_EQ(d.max, INFINITY);
        EXPECT_EQ(d.mean, INFINITY);
        EXPECT_EQ(d.rms, INFINITY);
        EXPECT_EQ(d.psnr, -INFINITY);
    }
}

TEST(Compare, DifferentSizesAreRefused)
{
    EXPECT_THROW(compareFrames(grey(4, 3, 0.0f), grey(3, 4, 0.0f)), Error);
}

} // namespace brickwall
