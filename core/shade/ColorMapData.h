// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

namespace brickwall {

/// A stop of a colour map as published: display (sRGB) components, interpolated as such.
struct ColorStop
{
    float t;
    std::uint32_t srgb; ///< 0xRRGGBB
};

struct NamedColorMap
{
    std::string_view name;
    std::string_view aliases;         ///< in small letters and digits alone, separated by blanks
    std::span<const ColorStop> stops; ///< ascending t from 0 to 1
};

/// All maps, in the order in which they are listed for people.
std::span<const NamedColorMap> namedColorMaps();

} // namespace brickwall
