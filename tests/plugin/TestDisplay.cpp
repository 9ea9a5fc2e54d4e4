// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestDisplay.h"

#include <gtest/gtest.h>

#include <csignal>
#include <cstdlib>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace brickwall::test {
namespace {

std::string why = "the X server was not started";

/// Xvfb chooses a free display number itself and writes it to the pipe once it is ready; nothing comes if it cannot
/// start. Without -noreset it would start anew, refusing connections, whenever the last window closes.
class XServer : public testing::Environment
{
public:
    void SetUp() override
    {
        int ends[2];
        if (pipe(ends) != 0)
            return;
        pid_ = fork();
        if (pid_ == 0)
            serve(ends);
        close(ends[1]);
        std::string number;
        for (char c; read(ends[0], &c, 1) == 1 && c != '\n';)
            number += c;
        close(ends[0]);
        if (number.empty()) {
            why = "Xvfb is not installed or does not start (Debian: apt-get install xvfb)";
            return;
        }
        setenv("DISPLAY", (":" + number).c_str(), 1);
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
        why.clear();
    }

    void TearDown() override
    {
        if (pid_ <= 0)
            return;
        kill(pid_, SIGTERM);
        waitpid(pid_, nullptr, 0);
    }

private:
    [[noreturn]] static void serve(const int (&ends)[2])
    {
        prctl(PR_SET_PDEATHSIG, SIGTERM); // also if a test crashes
        close(ends[0]);
        const std::string fd = std::to_string(ends[1]);
        execlp("Xvfb", "Xvfb", "-displayfd", fd.c_str(), "-screen", "0", "1600x1200x24", "+extension", "GLX",
               "-noreset", "-nolisten", "tcp", static_cast<char*>(nullptr));
        _exit(127);
    }

    pid_t pid_ = -1;
};

[[maybe_unused]] testing::Environment* const server = testing::AddGlobalTestEnvironment(new XServer);

} // namespace

const std::string& whyNoDisplay()
{
    return why;
}

} // namespace brickwall::test
