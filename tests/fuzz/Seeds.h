// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace brickwall::fuzz {

/// Writes .vdb files of every kind of grid and packing, one small seed each.
void writeOpenvdbSeeds(const std::string& folder);

} // namespace brickwall::fuzz
