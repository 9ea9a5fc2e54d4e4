// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/fuzz/Container.h"
#include "brickwall/tests/fuzz/ReadAll.h"

/// A plotfile, which is a folder.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count)
{
    using namespace brickwall::fuzz;
    emptyScratchFolder();
    if (!unpack({bytes, count}, "plt").empty())
        readAll(scratchFolder() + "/plt");
    return 0;
}
