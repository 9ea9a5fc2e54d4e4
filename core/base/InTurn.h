// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"

#include <cstddef>
#include <functional>

namespace brickwall {

/// Calls body(i) for all i below `count`: every thread that is free takes the next one, in order. So no thread is idle
/// while there is one left to begin, however long others take, and neighbours are worked on at the same time. For
/// bodies that take a thousandth of a second or so; Executor::forEach is for short ones. With one thread everything
/// runs in order on the calling thread. After an exception none is begun any more; the first reaches the caller.
void forEachInTurn(const Executor& executor, std::size_t count, const std::function<void(std::size_t i)>& body);

} // namespace brickwall
