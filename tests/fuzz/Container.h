// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/tests/fuzz/Scratch.h"

#include <string>

namespace brickwall::fuzz {

/// Formats of several files come as one input, whose sections are files:
///
///     === NAME[ OPTIONS]
///     the bytes of the file
///     === FOLDER/NAME
///     ...
///
/// The line end in front of a "=== " belongs to no file. Names lead nowhere but down; sections with others, or whose
/// name cannot be a file beside those before, are dropped.
///
/// Writes them into the scratch folder, below `folder`, and returns the path of the first, with ":OPTIONS" if it has
/// any; empty if there is none.
std::string unpack(Input input, const std::string& folder = {});

} // namespace brickwall::fuzz
