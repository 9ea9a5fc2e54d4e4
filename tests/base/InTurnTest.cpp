// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/InTurn.h"

#include <gtest/gtest.h>

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <stdexcept>
#include <vector>

namespace brickwall {
namespace {

TEST(InTurn, CallsEachOnce)
{
    for (const int threads : {1, 2, 5})
        for (const std::size_t count : {std::size_t(0), std::size_t(1), std::size_t(3), std::size_t(1000)}) {
            std::vector<std::atomic<int>> calls(count);
            forEachInTurn(Executor(threads), count, [&](std::size_t i) { ++calls[i]; });
            for (const auto& n : calls)
                EXPECT_EQ(n.load(), 1);
        }
}

TEST(InTurn, OneThreadKeepsTheOrder)
{
    std::vector<std::size_t> order;
    forEachInTurn(Executor(1), 100, [&](std::size_t i) { order.push_back(i); });
    ASSERT_EQ(order.size(), 100u);
    for (std::size_t i = 0; i < order.size(); ++i)
        EXPECT_EQ(order[i], i);
}

// Whichever is held up, wherever it is in the row: all others are done meanwhile, none waits behind it.
TEST(InTurn, NothingWaitsBehindWhatTakesLong)
{
    constexpr std::size_t count = 200;
    for (const std::size_t held : {std::size_t(0), std::size_t(1), std::size_t(77), count - 1}) {
        std::mutex mutex;
        std::condition_variable changed;
        std::size_t done = 0;
        bool inTime = false;
        forEachInTurn(Executor(2), count, [&](std::size_t i) {
            std::unique_lock lock(mutex);
            if (i == held) {
                inTime = changed.wait_for(lock, std::chrono::minutes(2), [&] { return done == count - 1; });
                return;
            }
            if (++done == count - 1)
                changed.notify_all();
        });
        EXPECT_TRUE(inTime) << held;
    }
}

TEST(InTurn, BeginsNothingAfterAnException)
{
    for (const int threads : {1, 2}) {
        std::atomic<std::size_t> calls{0};
        const auto body = [&](std::size_t i) {
            ++calls;
            if (i == 10)
                throw std::runtime_error("stop");
        };
        EXPECT_THROW(forEachInTurn(Executor(threads), 1u << 30, body), std::runtime_error);
        EXPECT_GE(calls.load(), 11u);
        EXPECT_LT(calls.load(), 1u << 30);
    }
}

} // namespace
} // namespace brickwall
