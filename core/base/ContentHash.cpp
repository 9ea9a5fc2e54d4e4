// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/ContentHash.h"

#include "brickwall/core/base/SplitMix.h"

#include <array>
#include <cstring>

namespace brickwall {
std::uint64_t contentHash(std::span<const std::byte> bytes, std::uint64_t start)
{
    // Four sums side by side, as one would wait for each of its multiplications.
    constexpr std::size_t width = 4 * sizeof(std::uint64_t);
    std::array<std::uint64_t, 4> sums{start, ~start, start ^ 0x9e3779b97f4a7c15u, start + bytes.size()};
    std::size_t at = 0;
    const auto add = [&](const std::byte* from) {
        std::array<std::uint64_t, 4> words;
        std::memcpy(words.data(), from, width);
        for (std::size_t i = 0; i < 4; ++i) {
            sums[i] = (sums[i] ^ words[i]) * 0x9ddfea08eb382d69u;
            sums[i] ^= sums[i] >> 32; // the highest bit of a word reaches no other by multiplication
        }
    };
    for (; at + width <= bytes.size(); at += width)
        add(bytes.data() + at);
    std::array<std::byte, width> rest{};
    if (at < bytes.size()) {
        std::memcpy(rest.data(), bytes.data() + at, bytes.size() - at);
        add(rest.data());
    }
    std::uint64_t hash = bytes.size();
    for (const std::uint64_t sum : sums)
        hash = splitMix(hash + sum);
    return hash;
}

} // namespace brickwall
