// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Error.h"

#include <algorithm>
#include <string>
#include <thread>

/// What both executors (Executor.cpp, ExecutorThreads.cpp) make of the number of threads asked for.
namespace brickwall {

inline int coreCount()
{
    return static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
}

/// One per core for 0; throws Error for a negative number.
inline int threadCount(int asked)
{
    if (asked < 0)
        throw Error("threads", "expected 0 (one per core) or a positive count, found " + std::to_string(asked));
    return asked == 0 ? coreCount() : asked;
}

} // namespace brickwall
