// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Executor.h"

#include "brickwall/core/base/ThreadCount.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

/// The Executor of the thread-sanitizer build, in place of Executor.cpp: Debian's TBB is not instrumented, so that the
/// sanitizer does not see its synchronisation and reports races that are none. Here threads come and go with each call.
namespace brickwall {

struct Executor::Arena
{
    explicit Arena(int threads) : threads(threads) {}

    /// Takes one of the threads that are not at work, if there is one.
    bool take()
    {
        int found = atWork.load();
        while (found < threads)
            if (atWork.compare_exchange_weak(found, found + 1))
                return true;
        return false;
    }

    int threads;
    std::atomic<int> atWork{1}; ///< the caller is one
};

namespace {

/// The first exception of several threads.
class FirstFailure
{
public:
    void run(const std::function<void()>& body)
    {
        try {
            body();
        } catch (...) {
            const std::scoped_lock lock(mutex_);
            if (!failure_)
                failure_ = std::current_exception();
        }
    }
    void rethrow() const
    {
        if (failure_)
            std::rethrow_exception(failure_);
    }

private:
    std::mutex mutex_;
    std::exception_ptr failure_;
};

} // namespace

Executor::Executor(int threads)
{
    arena_ = std::make_unique<Arena>(threadCount(threads));
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
    const std::size_t piece = std::max<std::size_t>({grain, count / (8 * std::size_t(arena_->threads)), 1});
    if (arena_->threads == 1 || piece >= count)
        return body(0, count);
    std::atomic<std::size_t> next{0};
    FirstFailure failure;
    const auto work = [&] {
        for (std::size_t begin = next.fetch_add(piece); begin < count; begin = next.fetch_add(piece))
            failure.run([&] { body(begin, std::min(begin + piece, count)); });
    };
    std::vector<std::thread> helpers;
    while (helpers.size() * piece < count && arena_->take())
        helpers.emplace_back(work);
    work();
    for (std::thread& helper : helpers) {
        helper.join();
        --arena_->atWork;
    }
    failure.rethrow();
}

void Executor::both(const std::function<void()>& a, const std::function<void()>& b) const
{
    if (!arena_->take()) {
        a();
        b();
        return;
    }
    FirstFailure failure;
    std::thread helper([&] { failure.run(a); });
    failure.run(b);
    helper.join();
    --arena_->atWork;
    failure.rethrow();
}

} // namespace brickwall
