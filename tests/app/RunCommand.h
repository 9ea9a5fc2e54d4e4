// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/tests/common/ScratchFolder.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

#include <sys/wait.h>

/// Runs the built command as a shell would, and what a test does with its files.
namespace brickwall::testing {

using test::scratchFolder;

inline std::string contentOf(const std::filesystem::path& path)
{
    std::ifstream in(path, std::ios::binary);
    std::ostringstream text;
    text << in.rdbuf();
    return text.str();
}

inline void write(const std::filesystem::path& path, const std::string& content)
{
    std::ofstream(path, std::ios::binary) << content;
}

struct Outcome
{
    int exitCode = -1; ///< -1 if a signal ended it
    std::string out;
    std::string err;
};

/// `arguments` as typed behind `brickwall`, in a shell.
inline Outcome run(const std::string& arguments)
{
    const auto folder = scratchFolder();
    const std::string out = (folder / "stdout").string(), err = (folder / "stderr").string();
    const int status =
        std::system((std::string(BRICKWALL_COMMAND) + " " + arguments + " >" + out + " 2>" + err).c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contentOf(out), contentOf(err)};
}

/// The lines of the error output that are the command's own message.
inline std::string messageOf(const Outcome& outcome)
{
    std::istringstream lines(outcome.err);
    std::string message, line;
    while (std::getline(lines, line))
        if (line.rfind("brickwall: ", 0) == 0)
            message += line + "\n";
    return message;
}

} // namespace brickwall::testing
