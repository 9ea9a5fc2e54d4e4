// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestDisplay.h"

#include <gtest/gtest.h>

namespace brickwall::test {
namespace {

TEST(XServerOfTests, EndsHoweverEarlyItIsTold)
{
    // It forgot a signal that came before its main loop, and a test without a window waited for it for ever.
    BRICKWALL_NEEDS_DISPLAY();
    for (int i = 0; i < 10; ++i)
        EXPECT_FALSE(XServer({"64x64"}).display().empty()) << i;
}

} // namespace
} // namespace brickwall::test
