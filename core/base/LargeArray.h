// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"

#include <cstddef>
#include <vector>

namespace brickwall {

/// `count` zeros, for a field's values: memory comes in large pages where the system has them, and all threads ask for
/// it. In small pages and by one thread that takes as long as reading the values from a file.
std::vector<float> makeLargeArray(std::size_t count, const Executor& executor);

} // namespace brickwall
