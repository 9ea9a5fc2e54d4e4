// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Error.h"

#include <atomic>
#include <cstdint>
#include <string_view>

namespace brickwall {

/// How long work tells how far it is and learns that it should stop. The base class reports nothing, so that
/// `Progress silent;` serves where nobody looks.
///
/// Work calls `begin` once per stage from one thread, then `advance` from any thread, and `check` now and then (at
/// least every tenth of a second); `check` throws Cancelled once `cancel` was called. `cancel` may be called from any
/// thread and from a signal handler.
class Progress
{
public:
    virtual ~Progress() = default;

    /// A stage starts: what is done, in the user's words ("reading bricks"), and how many steps it has, 0 if unknown.
    virtual void begin(std::string_view stage, std::uint64_t steps)
    {
        (void)stage;
        (void)steps;
    }
    virtual void advance(std::uint64_t steps) { (void)steps; }
    /// The stage is over; a following `begin` implies it.
    virtual void end() {}
    /// A line for the user: something was repaired, dropped, chosen.
    virtual void note(std::string_view line) { (void)line; }

    void cancel() noexcept { cancelled_.store(true, std::memory_order_relaxed); }
    bool cancelled() const noexcept { return cancelled_.load(std::memory_order_relaxed); }
    void check() const
    {
        if (cancelled())
            throw Cancelled();
    }

private:
    std::atomic<bool> cancelled_{false};
    static_assert(std::atomic<bool>::is_always_lock_free);
};

} // namespace brickwall
