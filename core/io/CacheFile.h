// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Range.h"
#include "brickwall/core/base/Vec.h"

#include <array>
#include <bit>
#include <cstdint>

namespace brickwall {

// The layout of a `.brickwall` file: one data set as it is in memory, little-endian, without compression.
//
//     CacheHeader                          at byte 0
//     float32 values[cellCount]            of each field, at a multiple of 4096, so that they could be mapped
//     the table, from tableOffset to the end of the file:
//         CacheBrick[brickCount]           in the order of their values
//         CacheField[fieldCount]           each followed by its name and its unit, not terminated
//         for each mesh: CacheMesh, float32 vertices[3 * vertexCount], int32 triangles[3 * triangleCount]
//
// A change of any of this is a new version; files of other versions are refused, as they can be made again.

static_assert(std::endian::native == std::endian::little);

inline constexpr std::array<char, 8> cacheMagic{'B', 'R', 'I', 'C', 'K', 'W', 'L', '\n'};
inline constexpr std::uint32_t cacheVersion = 1;
inline constexpr std::uint64_t cacheAlignment = 4096;

/// Written last: a file without it is no cache.
struct CacheHeader
{
    std::array<char, 8> magic{};
    std::uint32_t version = 0;
    std::uint32_t meshCount = 0;
    std::uint64_t fileSize = 0; ///< bytes, in all
    std::uint64_t tableOffset = 0;
    std::uint64_t cellCount = 0;
    std::uint64_t brickCount = 0;
    std::uint64_t fieldCount = 0;
    std::uint64_t zero = 0;
    std::array<double, 16> worldFromVoxel{}; ///< columns one after the other
};
static_assert(sizeof(CacheHeader) == 192);

struct CacheBrick
{
    vec3i lower;
    vec3i size;
    std::int32_t level = 0;
    std::int32_t zero = 0;
};
static_assert(sizeof(CacheBrick) == 32);

struct CacheField
{
    std::uint64_t offset = 0; ///< of its values, in bytes
    Range preferredRange;     ///< lo > hi: none
    std::uint32_t nameSize = 0;
    std::uint32_t unitSize = 0;
};
static_assert(sizeof(CacheField) == 24);

struct CacheMesh
{
    std::uint64_t vertexCount = 0;
    std::uint64_t triangleCount = 0;
};
static_assert(sizeof(CacheMesh) == 16);

} // namespace brickwall
