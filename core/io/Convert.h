// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/CellSelection.h"
#include "brickwall/core/io/DataSet.h"

#include <string>
#include <vector>

namespace brickwall {

/// What of a data set is written, and how.
struct ConvertOptions
{
    std::vector<std::string> fields; ///< by name; none: all that the data set lists
    CellChoice cells;
    NonFinite nonFinite = NonFinite::error;
    bool compress = false;  ///< .vthb: zlib
    bool overwrite = false; ///< what is there is replaced
};

/// Writes a data set in the format that the destination's extension names: .exa, .vdb, .vthb or .brickwall. Leaf cells
/// and values stay exactly what they are.
///
/// One field after the other is read and written, so that memory is that of one field (of all with NonFinite::empty,
/// which makes holes where any of the fields has no value), and of what the writer says. Data that can be streamed
/// (samples) need no memory for fields. Everything is written under
/// temporary names and renamed when it is whole, the file that a user opens last. Throws Error and Cancelled; nothing
/// of the destination is there then, or all that was there before.
void convert(const DataSet& source, const std::string& destination, const ConvertOptions& options,
             const Executor& executor, Progress& progress);

/// The extensions that can be written, for help texts: ".exa, .vdb, ...".
std::string targetExtensions();

/// Throws Error, before any work, for a destination of no known format, or in no folder.
void checkDestination(const std::string& destination);

} // namespace brickwall
