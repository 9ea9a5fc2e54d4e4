// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/InputFile.h"

#include <cstdint>
#include <string>

namespace brickwall {

/// How a grid's values are stored.
struct VdbStorage
{
    std::uint32_t compression = 0; ///< OpenVDB's flags
    std::uint32_t valueBytes = 4;  ///< of a value in memory
    std::uint32_t storedBytes = 4; ///< of a value in a node; less than valueBytes if stored as 16-bit numbers
};

/// Walks over a tree (5,4,3) that begins at byte `at`, without unpacking values: OpenVDB believes the sizes, masks and
/// positions that it finds there and would write beyond its nodes. Throws Error at `place`, naming the byte, for sizes
/// that fit neither node nor file, nodes with a child and a value in one place, and nodes off the grid of their level.
///
/// The layout is that of OpenVDB 10's RootNode.h, InternalNode.h, LeafNode.h and io/Compression.h for file versions
/// from 222.
void checkVdbTree(const InputFile& file, std::uint64_t at, const VdbStorage& storage, const std::string& place);

/// Throws Error at `place` unless the `packed` bytes at `at` begin with a header of Blosc (version 1) that agrees, and
/// that holds `bytes` at most: the library reads what the header says.
void checkBlosc(const InputFile& file, std::uint64_t at, std::uint64_t packed, std::uint64_t bytes,
                const std::string& place);

} // namespace brickwall
