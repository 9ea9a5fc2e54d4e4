// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/tests/oracles/WriteVtk.h"

#include <string>
#include <vector>

namespace brickwall::oracles {

/// Writes overlapping AMR as VTKHDF. Several steps, which have the same arrays, levels and spacing, make a file with
/// steps (their times are 0, 0.5, 1 ...), one a file without. `version` 2.2 has its names of lists without an "s".
/// Numbers are as the arrays' types Float32 and Float64 say. Throws Error if it cannot.
void writeVtkHdf(const std::string& path, const std::vector<VtkAmr3>& steps, double version = 2.3);

} // namespace brickwall::oracles
