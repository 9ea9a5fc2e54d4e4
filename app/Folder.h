// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>

namespace brickwall {

/// Makes the folder of --out with those above it, where there is none yet. Throws Error.
void makeOutputFolder(const std::string& folder);

} // namespace brickwall
