// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/fuzz/Hdf5Edits.h"
#include "brickwall/tests/oracles/WriteVtkHdf.h"

namespace {

using namespace brickwall;

/// One level; two levels with a vector; two steps, with the names of version 2.2 and those of 2.3.
std::vector<fuzz::Hdf5Edits::Write> validFiles()
{
    oracles::VtkAmr3 one, levels;
    one.boxes = {{{{0, 0, 0}, {4, 4, 4}}}};
    levels.arrays = {{"density", "Float64", 1}, {"velocity", "Float32", 3}};
    levels.boxes = {{{{0, 0, 0}, {2, 2, 2}}, {{2, 0, 0}, {4, 2, 2}}}, {{{0, 0, 0}, {4, 2, 2}}}};
    levels.ratios = {2};
    return {[one](const std::string& path) { oracles::writeVtkHdf(path, {one}); },
            [levels](const std::string& path) { oracles::writeVtkHdf(path, {levels}); },
            [levels](const std::string& path) {
                oracles::writeVtkHdf(path, {levels, levels}, 2.2);
            },
            [levels](const std::string& path) {
                oracles::writeVtkHdf(path, {levels, levels});
            }};
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t count)
{
    static const fuzz::Hdf5Edits edits(validFiles());
    fuzz::readEdited(edits, {bytes, count});
    return 0;
}
