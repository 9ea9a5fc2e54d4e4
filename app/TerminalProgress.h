// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Progress.h"

#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <mutex>
#include <set>
#include <string>

namespace brickwall {

/// Progress on standard error: a bar on a terminal, one plain line per stage otherwise. While one exists, Ctrl-C
/// (SIGINT) and SIGTERM cancel it; a second Ctrl-C ends the process at once. At most one may exist.
class TerminalProgress : public Progress
{
public:
    /// `quiet`: only notes.
    explicit TerminalProgress(bool quiet = false);
    ~TerminalProgress() override;

    void begin(std::string_view stage, std::uint64_t steps) override;
    void advance(std::uint64_t steps) override;
    void end() override;
    /// Each line once: work that goes field by field says the same of each.
    void note(std::string_view line) override;

private:
    using Clock = std::chrono::steady_clock;

    void draw();
    void finishStage();

    std::mutex mutex_;
    bool quiet_;
    bool terminal_;
    std::string stage_;
    std::set<std::string, std::less<>> noted_;
    std::uint64_t steps_ = 0;
    std::atomic<std::uint64_t> done_{0};
    Clock::time_point started_;
    std::atomic<std::int64_t> nextDraw_{0}; ///< nanoseconds of the clock
};

} // namespace brickwall
