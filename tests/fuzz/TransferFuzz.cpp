// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/TransferFunctionFile.h"
#include "brickwall/tests/fuzz/ReadAll.h"
#include "brickwall/tests/fuzz/Scratch.h"

/// Transfer functions: .xf and JSON, told apart by content. What was read is written and read again.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count)
{
    using namespace brickwall;
    const std::string path = fuzz::writeScratch("tf.json", fuzz::asText({bytes, count}));
    fuzz::answered([&] {
        const std::vector<ColorPoint> colors{{0.0f, {0.0f, 0.0f, 0.0f}}, {1.0f, {1.0f, 1.0f, 1.0f}}};
        writeTransferFunction(readTransferFunction(path, colors, {0.0f, 1.0f}), path);
    });
    return 0;
}
