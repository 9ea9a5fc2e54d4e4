// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace brickwall::test {

/// An X server without a screen to look at, for this program alone, started before the first test and ended with it;
/// DISPLAY names it. Empty if it runs, otherwise why it does not.
const std::string& whyNoDisplay();

} // namespace brickwall::test

/// At the start of every test that opens windows.
#define BRICKWALL_NEEDS_DISPLAY()                                                                                      \
    if (!brickwall::test::whyNoDisplay().empty())                                                                      \
    GTEST_SKIP() << brickwall::test::whyNoDisplay()
