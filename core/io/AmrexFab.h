// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Box.h"
#include "brickwall/core/io/InputFile.h"

#include <cstdint>
#include <vector>

namespace brickwall {

/// Where and how a FAB's numbers lie in its file: component after component, each over the whole box, x fastest.
struct FabLayout
{
    Box3i box; ///< with ghost cells, in its level's indices, upper exclusive
    std::int64_t components = 0;
    int bytes = 8; ///< per number: IEEE double, or 4 for float
    bool bigEndian = false;
    std::uint64_t offset = 0; ///< of the first number
};

/// Reads the FAB's header at `offset`:
/// `FAB ((8, (64 11 52 0 1 12 0 1023)),(8, (8 7 6 5 4 3 2 1)))((0,0,0) (31,31,31) (0,0,0)) 7`, which says the bits of a
/// number, the order of its bytes, the box, and the number of components. Throws Error, naming file and byte, for a
/// number format that is not IEEE float or double and for data that reach beyond the end of the file.
FabLayout readFabLayout(const InputFile& file, std::uint64_t offset);

/// The numbers of one component in the planes zBegin <= z < zEnd of the FAB's box, x fastest, whatever their format.
void readFabPlanes(const InputFile& file, const FabLayout& layout, std::int64_t component, int zBegin, int zEnd,
                   std::vector<double>& values);

} // namespace brickwall
