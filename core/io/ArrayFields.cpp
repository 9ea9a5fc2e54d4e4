// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/ArrayFields.h"

namespace brickwall {

void appendArrayFields(const std::string& array, int components, std::vector<ArrayField>& fields)
{
    if (components == 1) {
        fields.push_back({array, array, 0, 1});
        return;
    }
    for (int c = 0; c < components; ++c) {
        const std::string suffix = components == 3 ? std::string(1, "xyz"[c]) : std::to_string(c);
        fields.push_back({array + "_" + suffix, array, c, components});
    }
    if (components == 3)
        fields.push_back({array + "_magnitude", array, ArrayField::magnitude, components});
}

std::vector<std::string> namesOf(const std::vector<ArrayField>& fields)
{
    std::vector<std::string> names;
    for (const ArrayField& field : fields)
        names.push_back(field.name);
    return names;
}

} // namespace brickwall
