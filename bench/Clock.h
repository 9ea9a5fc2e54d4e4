// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <ctime>

namespace brickwall::bench {

/// Of CLOCK_MONOTONIC, or the processor time of CLOCK_THREAD_CPUTIME_ID or CLOCK_PROCESS_CPUTIME_ID.
inline double seconds(clockid_t clock)
{
    timespec t{};
    clock_gettime(clock, &t);
    return double(t.tv_sec) + 1e-9 * double(t.tv_nsec);
}

template <class F>
double secondsOf(clockid_t clock, const F& work)
{
    const double begin = seconds(clock);
    work();
    return seconds(clock) - begin;
}

} // namespace brickwall::bench
