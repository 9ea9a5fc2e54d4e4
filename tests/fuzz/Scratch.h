// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

namespace brickwall::fuzz {

using Input = std::span<const std::uint8_t>;

/// A folder of this process alone, below TMPDIR (scripts/fuzz has it in memory); it is gone when the process ends.
const std::string& scratchFolder();

/// Removes what is in it.
void emptyScratchFolder();

/// A file in the scratch folder, whose sub-folders are made. Returns its path.
std::string writeScratch(const std::string& name, std::string_view bytes);

inline std::string_view asText(Input input)
{
    return {reinterpret_cast<const char*>(input.data()), input.size()};
}

} // namespace brickwall::fuzz
