// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/RigFiles.h"
#include "brickwall/tests/fuzz/Container.h"
#include "brickwall/tests/fuzz/ReadAll.h"

/// Rigs: our TOML and JSON, COVISE XML with the files that it includes, ParaView .pvx, told apart by content. What was
/// read is written in every format.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count)
{
    using namespace brickwall;
    fuzz::emptyScratchFolder();
    const std::string path = fuzz::unpack({bytes, count});
    if (path.empty())
        return 0;
    fuzz::answered([&] {
        const Rig rig = loadRig(path);
        for (const RigFormat format : {RigFormat::toml, RigFormat::json, RigFormat::covise, RigFormat::pvx})
            fuzz::answered([&] {
                std::vector<std::string> lost;
                writeRig(rig, format, lost);
            });
    });
    fuzz::answered([&] { loadRig(path, {"node1", "node0", 1}); });
    return 0;
}
