// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestDisplay.h"

#include <gtest/gtest.h>

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <thread>

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace brickwall::test {
namespace {

std::string why = "the X server was not started";

[[noreturn]] void serve(const int (&ends)[2], const std::vector<std::string>& screens)
{
    prctl(PR_SET_PDEATHSIG, SIGTERM); // also if a test crashes
    close(ends[0]);
    std::vector<std::string> words = {
        "Xvfb", "-displayfd", std::to_string(ends[1]), "+extension", "GLX", "-noreset", "-nolisten", "tcp"};
    for (std::size_t i = 0; i < screens.size(); ++i)
        words.insert(words.end(), {"-screen", std::to_string(i), screens[i] + "x24"});
    std::vector<char*> arguments;
    for (std::string& word : words)
        arguments.push_back(word.data());
    arguments.push_back(nullptr);
    execvp("Xvfb", arguments.data());
    _exit(127);
}

/// Of all tests here.
class CommonServer : public testing::Environment
{
public:
    void SetUp() override
    {
        server_ = std::make_unique<XServer>(std::vector<std::string>{"1600x1200"});
        if (server_->display().empty()) {
            why = "Xvfb is not installed or does not start (Debian: apt-get install xvfb)";
            return;
        }
        setenv("DISPLAY", server_->display().c_str(), 1);
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", 1);
        why.clear();
    }
    void TearDown() override { server_.reset(); }

private:
    std::unique_ptr<XServer> server_;
};

[[maybe_unused]] testing::Environment* const server = testing::AddGlobalTestEnvironment(new CommonServer);

} // namespace

/// Xvfb chooses a free display number itself and writes it to the pipe once it is ready; nothing comes if it cannot
/// start. Without -noreset it would start anew, refusing connections, whenever the last window closes.
XServer::XServer(const std::vector<std::string>& screens)
{
    int ends[2];
    if (pipe(ends) != 0)
        return;
    pid_ = fork();
    if (pid_ == 0)
        serve(ends, screens);
    close(ends[1]);
    for (char c; read(ends[0], &c, 1) == 1 && c != '\n';)
        display_ += c;
    close(ends[0]);
    if (!display_.empty())
        display_.insert(0, ":");
}

XServer::~XServer()
{
    if (pid_ <= 0)
        return;
    // A server that has just said that it is ready may forget what it was told before its main loop: tell it again.
    do {
        kill(pid_, SIGTERM);
        std::this_thread::sleep_for(std::chrono::milliseconds(10));
    } while (waitpid(pid_, nullptr, WNOHANG) == 0);
}

const std::string& whyNoDisplay()
{
    return why;
}

} // namespace brickwall::test
