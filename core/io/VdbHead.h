// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/InputFile.h"

#include <cstdint>
#include <string>
#include <vector>

namespace brickwall {

/// One entry of the list of grids in an OpenVDB file.
struct VdbEntry
{
    std::string name; ///< unique in the file
    std::string type;
    std::int64_t begin = 0; ///< of the entry in the file
};

/// Reads the list of grids, and walks over all metadata without keeping them: OpenVDB believes every length that it
/// finds there, so that they are checked against the file first. Throws Error, naming the byte, for a length that does
/// not fit, and for files without a table of grids (written to a pipe).
///
/// The layout is that of openvdb/io/Archive.cc, file versions 222 to 224: magic, versions, flag, 36 characters of an
/// identifier; metadata; the number of grids; for each its name, type, parent and three positions, and at the first of
/// them compression flags and metadata. A text is its length in 32 bits and its characters.
std::vector<VdbEntry> readVdbHead(const InputFile& file);

} // namespace brickwall
