// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace brickwall {

/// The generator SplitMix64 for one state: numbers that look random, of which neighbours have nothing in common
/// (Steele, Lea, Flood, Fast splittable pseudorandom number generators, 2014).
inline std::uint64_t splitMix(std::uint64_t x)
{
    x += 0x9e3779b97f4a7c15u;
    x = (x ^ (x >> 30)) * 0xbf58476d1ce4e5b9u;
    x = (x ^ (x >> 27)) * 0x94d049bb133111ebu;
    return x ^ (x >> 31);
}

} // namespace brickwall
