// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/fuzz/Container.h"
#include "brickwall/tests/fuzz/ReadAll.h"

/// Data whose first file says what they are. Which reader is tried is a matter of the seeds and the dictionary.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count)
{
    using namespace brickwall::fuzz;
    emptyScratchFolder();
    if (const std::string data = unpack({bytes, count}); !data.empty())
        readAll(data);
    return 0;
}
