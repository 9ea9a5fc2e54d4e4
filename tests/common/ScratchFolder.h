// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <gtest/gtest.h>

#include <filesystem>
#include <set>
#include <string>

#include <unistd.h>

namespace brickwall::test {

/// A folder for the running test alone, also while others run at the same time; empty when it is first asked for.
inline std::filesystem::path scratchFolder()
{
    static std::set<std::filesystem::path> known;
    const auto* info = testing::UnitTest::GetInstance()->current_test_info();
    std::filesystem::path folder =
        std::filesystem::path(testing::TempDir()) /
        ("brickwall_" + std::string(info->test_suite_name()) + "_" + info->name() + "_" + std::to_string(::getpid()));
    if (known.insert(folder).second) {
        std::filesystem::remove_all(folder);
        std::filesystem::create_directories(folder);
    }
    return folder;
}

/// The path of a file of this name in it.
inline std::string scratchFile(const std::string& name)
{
    return (scratchFolder() / name).string();
}

} // namespace brickwall::test
