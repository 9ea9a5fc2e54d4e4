// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string_view>
#include <vector>

namespace brickwall {

/// One file of config/: its name without .toml, and its text. CMakeLists.txt makes the list, so that the names work
/// wherever the library is.
struct BuiltInRig
{
    std::string_view name;
    std::string_view text;
};

/// Sorted by name.
const std::vector<BuiltInRig>& builtInRigFiles();

} // namespace brickwall
