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
