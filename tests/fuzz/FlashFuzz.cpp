// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/fuzz/Hdf5Edits.h"
#include "brickwall/tests/oracles/WriteFlash.h"

namespace {

using namespace brickwall;

/// A block of its own, and an octree of two levels with two fields, in chunks.
std::vector<fuzz::Hdf5Edits::Write> validFiles()
{
    oracles::Flash3 one, tree;
    one.blockCells = {2, 2, 2};
    one.floats = false;
    tree.fields = {"dens", "velx"};
    tree.blockCells = {4, 2, 2};
    tree.rootBlocks = {2, 1, 1};
    tree.chunked = true;
    tree.refined = [](int level, const vec3i& block) { return level == 1 && block.x == 1; };
    return {[one](const std::string& path) { oracles::writeFlash(path, one); },
            [tree](const std::string& path) { oracles::writeFlash(path, tree); }};
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count)
{
    static const fuzz::Hdf5Edits edits(validFiles());
    fuzz::readEdited(edits, {bytes, count});
    return 0;
}
