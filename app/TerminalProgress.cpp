// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TerminalProgress.h"

#include <fmt/format.h>

#include <algorithm>
#include <csignal>
#include <cstdio>

#include <unistd.h>

namespace brickwall {
namespace {

constexpr int barWidth = 30;
constexpr std::int64_t drawInterval = 100'000'000; // ns

std::atomic<Progress*> current{nullptr};
static_assert(std::atomic<Progress*>::is_always_lock_free);

/// The second signal finds the default action: it ends the process even if the work does not look.
void onSignal(int signal)
{
    if (Progress* progress = current.load())
        progress->cancel();
    std::signal(signal, SIG_DFL);
}

std::int64_t nanoseconds(std::chrono::steady_clock::time_point t)
{
    return std::chrono::duration_cast<std::chrono::nanoseconds>(t.time_since_epoch()).count();
}

} // namespace

TerminalProgress::TerminalProgress(bool quiet) : quiet_(quiet), terminal_(isatty(STDERR_FILENO) == 1)
{
    current = this;
    std::signal(SIGINT, onSignal);
    std::signal(SIGTERM, onSignal);
}

TerminalProgress::~TerminalProgress()
{
    finishStage();
    std::signal(SIGINT, SIG_DFL);
    std::signal(SIGTERM, SIG_DFL);
    current = nullptr;
}

void TerminalProgress::begin(std::string_view stage, std::uint64_t steps)
{
    const std::scoped_lock lock(mutex_);
    finishStage();
    stage_ = stage;
    steps_ = steps;
    done_ = 0;
    started_ = Clock::now();
    if (terminal_ && !quiet_)
        draw();
}

void TerminalProgress::advance(std::uint64_t steps)
{
    done_ += steps;
    if (!terminal_ || quiet_)
        return;
    const std::int64_t now = nanoseconds(Clock::now());
    std::int64_t next = nextDraw_.load();
    if (now >= next && nextDraw_.compare_exchange_strong(next, now + drawInterval)) {
        const std::scoped_lock lock(mutex_);
        draw();
    }
}

void TerminalProgress::end()
{
    const std::scoped_lock lock(mutex_);
    finishStage();
}

void TerminalProgress::note(std::string_view line)
{
    const std::scoped_lock lock(mutex_);
    if (!noted_.emplace(line).second)
        return;
    fmt::print(stderr, "{}{}\n", terminal_ && !stage_.empty() ? "\r\033[K" : "", line);
}

void TerminalProgress::draw()
{
    if (stage_.empty())
        return;
    const double fraction = steps_ == 0 ? 0.0 : std::min(1.0, double(done_.load()) / double(steps_));
    const int filled = static_cast<int>(fraction * barWidth);
    fmt::print(stderr, "\r\033[K{:<32} [{:#<{}}{:<{}}] {:3.0f} %", stage_, "", filled, "", barWidth - filled,
               100.0 * fraction);
    std::fflush(stderr);
}

void TerminalProgress::finishStage()
{
    if (stage_.empty())
        return;
    const double seconds = std::chrono::duration<double>(Clock::now() - started_).count();
    if (!quiet_)
        fmt::print(stderr, "{}{:<32} {:.2f} s\n", terminal_ ? "\r\033[K" : "", stage_, seconds);
    stage_.clear();
}

} // namespace brickwall
