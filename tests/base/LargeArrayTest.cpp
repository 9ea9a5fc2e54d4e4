// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/LargeArray.h"

#include <gtest/gtest.h>

#include <algorithm>

using namespace brickwall;

TEST(LargeArray, IsZeroAndNoLargerThanAskedFor)
{
    for (const std::size_t count : {std::size_t(0), std::size_t(1), std::size_t(1) << 20, (std::size_t(5) << 20) + 3}) {
        for (const int threads : {1, 3}) {
            std::vector<float> values = makeLargeArray(count, Executor(threads));
            EXPECT_EQ(values.size(), count);
            EXPECT_EQ(values.capacity(), count);
            EXPECT_TRUE(std::all_of(values.begin(), values.end(), [](float v) { return v == 0.0f; }));
            std::fill(values.begin(), values.end(), 1.0f); // the next one may get the same memory
        }
    }
}

TEST(LargeArray, GrowsInItsRoomAndKeepsWhatItHas)
{
    for (const std::size_t step : {std::size_t(1000), (std::size_t(3) << 20) + 5}) {
        std::vector<float> values = roomForLargeArray(5 * step);
        EXPECT_TRUE(values.empty());
        for (std::size_t n = 1; n <= 5; ++n) {
            growLargeArray(values, n * step, Executor(2));
            ASSERT_EQ(values.size(), n * step);
            EXPECT_TRUE(std::all_of(values.begin() + std::ptrdiff_t((n - 1) * step), values.end(),
                                    [](float v) { return v == 0.0f; }));
            std::fill(values.begin() + std::ptrdiff_t((n - 1) * step), values.end(), float(n));
        }
        EXPECT_EQ(values.capacity(), 5 * step) << "it was never moved";
        for (std::size_t i = 0; i < values.size(); ++i)
            ASSERT_EQ(values[i], float(i / step + 1));
    }
}

TEST(LargeArray, ReleasedValuesTakeNoneOfTheirNeighboursAlong)
{
    std::vector<float> values(1 << 20, 1.0f);
    const std::size_t begin = 12345, end = 1000001;
    releaseValues(std::span(values).subspan(begin, end - begin));
    EXPECT_TRUE(std::all_of(values.begin(), values.begin() + begin, [](float v) { return v == 1.0f; }));
    EXPECT_TRUE(std::all_of(values.begin() + end, values.end(), [](float v) { return v == 1.0f; }));
    std::fill(values.begin(), values.end(), 2.0f); // the memory is still ours
    EXPECT_EQ(values[begin], 2.0f);
}
