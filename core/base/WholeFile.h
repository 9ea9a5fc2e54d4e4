// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <string_view>

namespace brickwall {

/// The bytes of a file. Throws Error with the path and the system's reason.
std::string readWholeFile(const std::string& path);

/// Writes a file under a temporary name beside `path` and renames it, so that nothing partial ever looks complete and
/// an older file survives a failure. Throws Error with the path and the system's reason; the temporary file is gone
/// then. Devices, pipes and links (/dev/stdout) are written to directly.
void writeWholeFile(const std::string& path, std::string_view bytes);

} // namespace brickwall
