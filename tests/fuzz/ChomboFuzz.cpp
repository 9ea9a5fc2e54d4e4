// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/fuzz/Hdf5Edits.h"
#include "brickwall/tests/oracles/WriteChombo.h"

namespace {

using namespace brickwall;

/// One box; three levels with ghost cells; what older files leave out.
std::vector<fuzz::Hdf5Edits::Write> validFiles()
{
    oracles::Chombo3 one, levels, older;
    one.boxes = {{{{0, 0, 0}, {4, 4, 4}}}};
    levels.components = {"density", "x-velocity"};
    levels.boxes = {
        {{{-2, 0, 0}, {0, 2, 2}}, {{0, 0, 0}, {2, 2, 2}}}, {{{0, 0, 0}, {4, 4, 2}}}, {{{4, 4, 0}, {8, 8, 4}}}};
    levels.ratios = {2, 4};
    levels.ghosts = {1, 1, 1};
    levels.vectorRatios = true;
    older.boxes = {{{{0, 0, 0}, {2, 2, 2}}, {{2, 0, 0}, {4, 2, 2}}}, {{{0, 0, 0}, {2, 2, 2}}}};
    older.ratios = {2};
    older.outputGhost = false;
    older.offsets = false;
    older.floats = true;
    std::vector<fuzz::Hdf5Edits::Write> files;
    for (const oracles::Chombo3& chombo : {one, levels, older})
        files.push_back([chombo](const std::string& path) { oracles::writeChombo(path, chombo); });
    return files;
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count)
{
    static const fuzz::Hdf5Edits edits(validFiles());
    fuzz::readEdited(edits, {bytes, count});
    return 0;
}
