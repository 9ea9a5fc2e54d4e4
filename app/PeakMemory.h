// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>

namespace brickwall {

/// The largest memory that this process had so far, in bytes.
std::uint64_t peakMemory();

} // namespace brickwall
