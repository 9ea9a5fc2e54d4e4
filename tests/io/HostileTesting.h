// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/tests/io/IoTest.h"

#include <chrono>
#include <fstream>
#include <string>

namespace brickwall {

/// A number of /proc/self/status in MiB: VmRSS, what is in memory, or VmHWM, the most that was.
inline double memoryMiB(const std::string& key)
{
    std::ifstream status("/proc/self/status");
    for (std::string word; status >> word;)
        if (double kibibytes = 0; word == key + ":" && status >> kibibytes)
            return kibibytes / 1024.0;
    ADD_FAILURE() << "no " << key;
    return 0.0;
}

/// What is said about hostile data: one line, within a second and 100 MB.
inline std::string hostileError(const std::string& data)
{
    std::ofstream("/proc/self/clear_refs") << "5"; // the peak begins anew
    const double before = memoryMiB("VmRSS");
    const auto start = std::chrono::steady_clock::now();
    const std::string line = loadError(data);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    EXPECT_LT(seconds.count(), 1.0) << line;
    EXPECT_LT(memoryMiB("VmHWM") - before, 100.0) << line;
    return line;
}

} // namespace brickwall
