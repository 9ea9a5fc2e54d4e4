// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Executor.h"

#include "brickwall/core/base/ThreadCount.h"

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/parallel_invoke.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <optional>

namespace brickwall {

struct Executor::Arena
{
    Arena(int threads, int cores) : threads(threads), tbb(threads)
    {
        if (threads > cores)
            allowed.emplace(tbb::global_control::max_allowed_parallelism, static_cast<std::size_t>(threads));
    }

    int threads;
    /// More threads than cores only happen if TBB is told so. Not otherwise: of several controls the least one counts.
    std::optional<tbb::global_control> allowed;
    tbb::task_arena tbb;
};

Executor::Executor(int threads)
{
    arena_ = std::make_unique<Arena>(threadCount(threads), coreCount());
}

Executor::~Executor() = default;
Executor::Executor(Executor&&) noexcept = default;
Executor& Executor::operator=(Executor&&) noexcept = default;

int Executor::threads() const
{
    return arena_->threads;
}

void Executor::forEach(std::size_t count, std::size_t grain,
                       const std::function<void(std::size_t, std::size_t)>& body) const
{
    if (count == 0)
        return;
    if (arena_->threads == 1)
        return body(0, count);
    const tbb::blocked_range<std::size_t> all(0, count, grain == 0 ? 1 : grain);
    arena_->tbb.execute(
        [&] { tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& r) { body(r.begin(), r.end()); }); });
}

void Executor::both(const std::function<void()>& a, const std::function<void()>& b) const
{
    if (arena_->threads == 1) {
        a();
        b();
        return;
    }
    arena_->tbb.execute([&] { tbb::parallel_invoke(a, b); });
}

} // namespace brickwall
