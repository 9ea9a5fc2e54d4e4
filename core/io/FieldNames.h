// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace brickwall {

/// The index of each wanted name; an Error at `place` lists the names there are.
std::vector<std::size_t> fieldIndices(std::span<const std::string> names, std::span<const std::string> wanted,
                                      const std::string& place);

/// The Error for a value that is not finite as a float.
[[noreturn]] void failNotFinite(double value, const std::string& place, const std::string& field,
                                const std::string& cell);

} // namespace brickwall
