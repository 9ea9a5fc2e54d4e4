// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/FieldNames.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <string_view>
#include <unordered_map>

namespace brickwall {

std::vector<std::size_t> fieldIndices(std::span<const std::string> names, std::span<const std::string> wanted,
                                      const std::string& place)
{
    std::unordered_map<std::string_view, std::size_t> known; // the first of each name; there may be very many
    for (std::size_t i = 0; i < names.size(); ++i)
        known.emplace(names[i], i);
    std::vector<std::size_t> indices;
    for (const std::string& name : wanted) {
        const auto found = known.find(name);
        if (found == known.end())
            throw Error(place, names.empty() ? fmt::format("there is no field '{}'; the data have no fields", name)
                                             : fmt::format("there is no field '{}'; the fields are {}", name,
                                                           fmt::join(names, ", ")));
        indices.push_back(found->second);
    }
    return indices;
}

void failNotFinite(double value, const std::string& place, const std::string& field, const std::string& cell)
{
    throw Error(place, fmt::format("expected a finite value, found {} in field '{}', {}", value, field, cell));
}

} // namespace brickwall
