// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/VectorFields.h"

#include <algorithm>
#include <optional>
#include <string_view>

namespace brickwall {
namespace {

constexpr std::array<std::string_view, 5> separators{"_", "-", ".", " ", ""};
constexpr std::array<std::string_view, 3> axisNames{"xyz", "XYZ", "012"};

using Names = std::span<const std::string>;

bool hasAll(Names fields, const std::array<std::string, 3>& components)
{
    return std::all_of(components.begin(), components.end(), [&](const std::string& component) {
        return std::find(fields.begin(), fields.end(), component) != fields.end();
    });
}

/// The vector whose x component is BASE, separator, axis, or the other way round, if the others are there.
std::optional<VectorFields> vectorOf(Names fields, const std::string& x, std::string_view separator,
                                     std::string_view axes, bool axisLast)
{
    const std::string affix =
        axisLast ? std::string(separator) + axes[0] : std::string(1, axes[0]) + std::string(separator);
    if (x.size() <= affix.size() || (axisLast ? !x.ends_with(affix) : !x.starts_with(affix)))
        return {};
    VectorFields vector;
    vector.name = axisLast ? x.substr(0, x.size() - affix.size()) : x.substr(affix.size());
    for (int axis = 0; axis < 3; ++axis) {
        vector.components[axis] = x;
        vector.components[axis][axisLast ? x.size() - 1 : 0] = axes[axis];
    }
    if (!hasAll(fields, vector.components))
        return {};
    return vector;
}

std::optional<VectorFields> vectorWithX(Names fields, const std::string& x)
{
    if (x == "u" || x == "U") {
        VectorFields vector{"velocity", {x, x == "u" ? "v" : "V", x == "u" ? "w" : "W"}};
        if (hasAll(fields, vector.components))
            return vector;
    }
    for (const std::string_view separator : separators)
        for (const std::string_view axes : axisNames)
            for (const bool axisLast : {true, false}) {
                const bool numbered = axes[0] == '0';
                if (numbered && (separator.empty() || !axisLast)) // dye0 dye1 dye2 are three dyes
                    continue;
                if (auto vector = vectorOf(fields, x, separator, axes, axisLast))
                    return vector;
            }
    return {};
}

} // namespace

std::vector<VectorFields> findVectors(Names fields)
{
    std::vector<VectorFields> vectors;
    for (const std::string& field : fields)
        if (auto vector = vectorWithX(fields, field))
            vectors.push_back(*vector);
    return vectors;
}

} // namespace brickwall
