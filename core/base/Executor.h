// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <functional>
#include <memory>

namespace brickwall {

/// Parallelism as an argument: whoever may work on several cores takes an Executor. With one thread everything runs in
/// order on the calling thread, so that a test can demand the identical result from a serial and a parallel run.
///
/// Bodies may throw; the first exception reaches the caller after all running bodies have ended. Calls may be nested.
/// The only place that includes TBB.
class Executor
{
public:
    /// `threads` = 0: one per core. Negative counts are refused with Error.
    explicit Executor(int threads = 0);
    ~Executor();
    Executor(Executor&&) noexcept;
    Executor& operator=(Executor&&) noexcept;

    int threads() const;

    /// Calls body(begin, end) over disjoint pieces of [0, count) that are not split further below `grain`.
    void forEach(std::size_t count, std::size_t grain,
                 const std::function<void(std::size_t begin, std::size_t end)>& body) const;

    /// Runs both, possibly side by side, and returns when both have ended.
    void both(const std::function<void()>& a, const std::function<void()>& b) const;

private:
    struct Arena;
    std::unique_ptr<Arena> arena_;
};

} // namespace brickwall
