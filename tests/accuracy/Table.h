// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Measure.h"

#include <string>

namespace brickwall::test {

/// Makes a subject with a transfer function a row of the table, which is written as Markdown to the file that the
/// environment variable BRICKWALL_ACCURACY_TABLE names, when all tests of the program are done: first the worst
/// transfer function of each subject, then everything.
void addToTable(const std::string& subject, const std::string& transferFunction, const KeptOfShading& off,
                const KeptOfShading& headlight);

} // namespace brickwall::test
