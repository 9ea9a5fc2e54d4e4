// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "PeakMemory.h"

#include <sys/resource.h>

namespace brickwall {

std::uint64_t peakMemory()
{
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return std::uint64_t(usage.ru_maxrss) * 1024; // Linux counts kilobytes
}

} // namespace brickwall
