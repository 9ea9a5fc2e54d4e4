// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <string>
#include <vector>

namespace brickwall {

/// A scalar out of an array of a file: a component, or the magnitude of a vector.
struct ArrayField
{
    static constexpr int magnitude = -1; ///< as `component`

    std::string name;  ///< as users know it
    std::string array; ///< as the file does
    int component = 0;
    int components = 1; ///< of the array
};

/// Appends the fields of an array: one component keeps the name, three are NAME_x, NAME_y, NAME_z and NAME_magnitude,
/// any other number NAME_0, NAME_1 and so on.
void appendArrayFields(const std::string& array, int components, std::vector<ArrayField>& fields);

std::vector<std::string> namesOf(const std::vector<ArrayField>& fields);

} // namespace brickwall
