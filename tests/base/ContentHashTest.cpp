// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/ContentHash.h"

#include <gtest/gtest.h>

#include <set>
#include <vector>

namespace brickwall {
namespace {

TEST(ContentHash, TellsEveryBitAndEveryLength)
{
    std::set<std::uint64_t> hashes;
    std::size_t inputs = 0;
    std::vector<std::byte> bytes;
    for (std::size_t size = 0; size < 130; ++size, bytes.push_back(std::byte(0))) {
        hashes.insert(contentHash(bytes));
        ++inputs;
        for (std::size_t bit = 0; bit < 8 * size; ++bit, ++inputs) {
            bytes[bit / 8] ^= std::byte(1 << bit % 8);
            hashes.insert(contentHash(bytes));
            bytes[bit / 8] ^= std::byte(1 << bit % 8);
        }
    }
    EXPECT_EQ(hashes.size(), inputs);
}

TEST(ContentHash, TellsTheOrderOfWordsAndTheStart)
{
    std::vector<std::byte> a(256), b(256);
    for (std::size_t i = 0; i < a.size(); ++i)
        a[i] = std::byte(i), b[i] = std::byte(i ^ 32); // blocks of 32 bytes change places
    EXPECT_NE(contentHash(a), contentHash(b));
    EXPECT_NE(contentHash(a, 1), contentHash(a, 2));
    EXPECT_EQ(contentHash(a, 1), contentHash(a, 1));
}

} // namespace
} // namespace brickwall
