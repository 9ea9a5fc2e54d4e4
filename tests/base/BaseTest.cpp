// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Box.h"
#include "brickwall/core/base/Error.h"
#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/base/Range.h"

#include <gtest/gtest.h>

#include <atomic>
#include <string>
#include <vector>

using namespace brickwall;

TEST(Box, StartsEmptyAndGrowsToWhatItIsExtendedBy)
{
    Box3i box;
    EXPECT_TRUE(box.empty());
    EXPECT_EQ(volume(box), 0);
    box.extend(vec3i(1, 2, 3));
    box.extend(vec3i(4, 4, 4));
    EXPECT_EQ(volume(box), 3 * 2 * 1);
}

TEST(Box, OfAdjacentCellsHasThePointOfTheirFaceOnce)
{
    const Box3i left{vec3i(0), vec3i(2)}, right{vec3i(2, 0, 0), vec3i(4, 2, 2)};
    const vec3i onFace(2, 1, 1);
    EXPECT_NE(left.contains(onFace), right.contains(onFace));
    EXPECT_FALSE(left.overlaps(right));
}

TEST(Box, VolumeDoesNotOverflowAnInt)
{
    EXPECT_EQ(volume(Box3i{vec3i(0), vec3i(1 << 20)}), std::int64_t(1) << 60);
}

TEST(Range, TouchingRangesOverlap)
{
    EXPECT_TRUE((Range{0, 1}.overlaps(Range{1, 2})));
    EXPECT_FALSE((Range{0, 1}.overlaps(Range{1.5f, 2})));
    EXPECT_TRUE(Range{}.empty());
    EXPECT_FALSE((Range{}.overlaps(Range{0, 1})));
}

TEST(Error, IsOneLineEvenIfTheFileIsHostile)
{
    const Error error("a\nb.exa", "unknown keyword \"x\r\ty\"");
    EXPECT_EQ(std::string(error.what()), "a b.exa: unknown keyword \"x  y\"");
}

TEST(Executor, VisitsEveryIndexOnce)
{
    for (int threads : {1, 2, 5}) {
        const Executor executor(threads);
        EXPECT_EQ(executor.threads(), threads);
        std::vector<std::atomic<int>> visits(1000);
        executor.forEach(visits.size(), 7, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                ++visits[i];
        });
        for (const auto& v : visits)
            EXPECT_EQ(v, 1);
    }
}

TEST(Executor, HandsAnExceptionToTheCaller)
{
    for (int threads : {1, 3})
        EXPECT_THROW(Executor(threads).forEach(100, 1, [](std::size_t, std::size_t) { throw Cancelled(); }), Cancelled);
}

TEST(Executor, CallsMayBeNested)
{
    const Executor executor(2);
    std::atomic<int> sum{0};
    executor.forEach(4, 1, [&](std::size_t b, std::size_t e) {
        for (std::size_t i = b; i < e; ++i)
            executor.both([&] { ++sum; }, [&] { ++sum; });
    });
    EXPECT_EQ(sum, 8);
}

TEST(Executor, RefusesANegativeThreadCount)
{
    EXPECT_THROW(Executor(-1), Error);
}

TEST(Progress, ThrowsOnlyAfterItWasCancelled)
{
    Progress progress;
    EXPECT_NO_THROW(progress.check());
    progress.cancel();
    EXPECT_THROW(progress.check(), Cancelled);
}
