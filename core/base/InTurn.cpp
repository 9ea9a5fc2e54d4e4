// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/InTurn.h"

#include <algorithm>
#include <atomic>

namespace brickwall {

void forEachInTurn(const Executor& executor, std::size_t count, const std::function<void(std::size_t i)>& body)
{
    std::atomic<std::size_t> next{0};
    const std::size_t workers = std::min(count, std::size_t(executor.threads()));
    executor.forEach(workers, 1, [&](std::size_t, std::size_t) {
        try {
            for (std::size_t i = next++; i < count; i = next++)
                body(i);
        } catch (...) {
            next = count;
            throw;
        }
    });
}

} // namespace brickwall
