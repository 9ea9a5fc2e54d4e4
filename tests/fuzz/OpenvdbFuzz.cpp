// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/fuzz/ReadAll.h"
#include "brickwall/tests/fuzz/Scratch.h"

/// When packed values turn out to be broken, libopenvdb throws and forgets the nodes that it was reading.
extern "C" int __lsan_is_turned_off()
{
    return 1;
}

/// The bytes of a .vdb as they are: what libopenvdb must not see is for core/io/VdbHead and VdbTreeCheck to refuse.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count)
{
    using namespace brickwall::fuzz;
    readAll(writeScratch("data.vdb", asText({bytes, count})));
    return 0;
}
