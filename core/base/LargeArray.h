// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"

#include <cstddef>
#include <span>
#include <vector>

namespace brickwall {

/// `count` zeros, for a field's values: memory comes in large pages where the system has them, and all threads ask for
/// it. In small pages and by one thread that takes as long as reading the values from a file.
std::vector<float> makeLargeArray(std::size_t count, const Executor& executor);

/// An empty array with room for `count` values; the memory is asked for as growLargeArray makes them.
std::vector<float> roomForLargeArray(std::size_t count);

/// Makes an array with room for them `count` values long, at least what it is already. New values are zeros, and come
/// as those of makeLargeArray.
void growLargeArray(std::vector<float>& values, std::size_t count, const Executor& executor);

/// Gives the memory of values back that nobody will look at again, for arrays that are consumed from front to back.
/// What is read there afterwards is not said.
void releaseValues(std::span<float> values);

} // namespace brickwall
