// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/fuzz/ReadAll.h"
#include "brickwall/tests/fuzz/Scratch.h"

/// Our own .brickwall.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count)
{
    using namespace brickwall::fuzz;
    readAll(writeScratch("data.brickwall", asText({bytes, count})));
    return 0;
}
