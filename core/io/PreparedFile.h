// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/PreparedVolume.h"

#include <array>
#include <bit>
#include <cstdint>
#include <string>

namespace brickwall {

// The layout of a file of a prepared volume, which is a cache and nothing else: as it is in memory, little-endian.
//
//     PreparedHeader     at byte 0
//     arrays             each at a multiple of 4096
//     the table          from tableOffset to the end: what PreparedVisit.h visits, in this order; numbers and
//                        structures as they are, texts as a uint64 length and their bytes, arrays as a PreparedArray
//
// All of it is hashed. A file of another version or with another request or stamp is not read, but made again.

static_assert(std::endian::native == std::endian::little);

inline constexpr std::array<char, 8> preparedMagic{'B', 'R', 'I', 'C', 'K', 'P', 'R', '\n'};
inline constexpr std::uint32_t preparedVersion = 1; ///< also new when bricks, regions or padding are made otherwise

struct PreparedHeader
{
    std::array<char, 8> magic{};
    std::uint32_t version = 0;
    std::uint32_t zero = 0;
    std::uint64_t fileSize = 0; ///< bytes, in all
    std::uint64_t tableOffset = 0;
    std::uint64_t tableHash = 0;
};
static_assert(sizeof(PreparedHeader) == 40);

struct PreparedArray
{
    std::uint64_t count = 0;
    std::uint64_t offset = 0; ///< bytes
    std::uint64_t hash = 0;   ///< of the hashes of pieces of preparedPiece bytes
};
static_assert(sizeof(PreparedArray) == 24);

inline constexpr std::uint64_t preparedPiece = 1 << 20;

/// What a volume is kept for: the file is used if the same text would be written today.
std::string preparedKey(const VolumeRequest& request, const std::string& stamp);

/// Reads what was written; throws Error for anything else, and Cancelled.
PreparedVolume readPrepared(const std::string& path, const std::string& key, const Executor& executor,
                            Progress& progress);

/// Writes under a temporary name beside `path`, and renames. Throws Error and Cancelled; nothing is left then.
void writePrepared(const std::string& path, const std::string& key, const PreparedVolume& volume,
                   const Executor& executor, Progress& progress);

} // namespace brickwall
