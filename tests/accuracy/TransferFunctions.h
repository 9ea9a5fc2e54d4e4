// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Subjects.h"

#include <string>
#include <vector>

namespace brickwall::test {

/// What is asked of a renderer, from broad to hardly representable.
std::vector<std::string> transferFunctionNames();

/// The transfer function of that name for these data: what is narrow lies where the data have values. Throws
/// std::invalid_argument for unknown names. Without points for a logarithmic one where the data are not positive.
TransferFunction transferFunctionNamed(const std::string& name, const Subject& subject);

/// The value that a transfer function maps to t.
float valueAt(const TransferFunction& tf, double t);

} // namespace brickwall::test
