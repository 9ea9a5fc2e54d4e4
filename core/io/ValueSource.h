// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <span>

namespace brickwall {

/// Values of one field that are made or read when they are asked for: fills `out` with those of a brick's cells from
/// its cell number `first` on, x fastest. Any number of threads may ask at the same time. Throws Error.
using ValueSource = std::function<void(std::size_t brick, std::uint64_t first, std::span<float> out)>;

} // namespace brickwall
