// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/shade/ColorMaps.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/shade/ColorMapData.h"
#include "brickwall/core/shade/Srgb.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>

namespace brickwall {
namespace {

/// Small letters and digits alone, so that "Cool to Warm (Extended)" is cooltowarmextended.
std::string keyOf(std::string_view name)
{
    std::string key;
    for (const char c : name) {
        if (c >= 'A' && c <= 'Z')
            key += char(c - 'A' + 'a');
        else if ((c >= 'a' && c <= 'z') || (c >= '0' && c <= '9'))
            key += c;
    }
    return key;
}

bool hasName(const NamedColorMap& map, const std::string& key)
{
    if (keyOf(map.name) == key)
        return true;
    for (std::size_t begin = 0; begin < map.aliases.size();) {
        const std::size_t end = std::min(map.aliases.find(' ', begin), map.aliases.size());
        if (map.aliases.substr(begin, end - begin) == key)
            return true;
        begin = end + 1;
    }
    return false;
}

vec3f srgbOf(const ColorStop& stop)
{
    return vec3f((stop.srgb >> 16) & 255u, (stop.srgb >> 8) & 255u, stop.srgb & 255u) / 255.0f;
}

vec3f linearOf(const vec3f& srgb)
{
    return {linearFromSrgb(srgb.x), linearFromSrgb(srgb.y), linearFromSrgb(srgb.z)};
}

/// The published maps are meant to be interpolated in display values, ours in linear ones: points so close to each
/// other that the difference cannot be seen.
std::vector<ColorPoint> linearPoints(std::span<const ColorStop> stops)
{
    constexpr float spacing = 1.0f / 64.0f;
    std::vector<ColorPoint> points{{stops[0].t, linearOf(srgbOf(stops[0]))}};
    for (std::size_t i = 1; i < stops.size(); ++i) {
        const float t0 = stops[i - 1].t;
        const float t1 = stops[i].t;
        const vec3f a = srgbOf(stops[i - 1]);
        const vec3f b = srgbOf(stops[i]);
        const int pieces = std::max(1, int(std::ceil((t1 - t0) / spacing)));
        for (int k = 1; k <= pieces; ++k) {
            const float f = float(k) / float(pieces);
            points.push_back({k == pieces ? t1 : t0 + (t1 - t0) * f, linearOf(a + (b - a) * f)});
        }
    }
    return points;
}

} // namespace

std::vector<std::string> colorMapNames()
{
    std::vector<std::string> names;
    for (const NamedColorMap& map : namedColorMaps())
        names.emplace_back(map.name);
    return names;
}

std::vector<ColorPoint> colorMap(std::string_view name)
{
    const std::string key = keyOf(name);
    for (const NamedColorMap& map : namedColorMaps())
        if (hasName(map, key))
            return linearPoints(map.stops);
    throw Error("colour map",
                fmt::format("there is none named '{}'; there are: {}", name, fmt::join(colorMapNames(), ", ")));
}

} // namespace brickwall
