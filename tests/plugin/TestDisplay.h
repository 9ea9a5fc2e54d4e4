// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace brickwall::test {

/// An X server without a screen to look at, for this program alone, started before the first test and ended with it;
/// DISPLAY names it. Empty if it runs, otherwise why it does not.
const std::string& whyNoDisplay();

/// Another such server, with screens of these sizes ("200x150"), for as long as this lives.
class XServer
{
public:
    explicit XServer(const std::vector<std::string>& screens);
    ~XServer();
    XServer(const XServer&) = delete;
    XServer& operator=(const XServer&) = delete;

    /// ":7", without a screen; empty if it does not start.
    const std::string& display() const { return display_; }

private:
    int pid_ = -1;
    std::string display_;
};

} // namespace brickwall::test

/// At the start of every test that opens windows.
#define BRICKWALL_NEEDS_DISPLAY()                                                                                      \
    if (!brickwall::test::whyNoDisplay().empty())                                                                      \
    GTEST_SKIP() << brickwall::test::whyNoDisplay()
