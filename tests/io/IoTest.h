// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/DataSet.h"
#include "brickwall/tests/common/ErrorOf.h"
#include "brickwall/tests/common/ScratchFolder.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>
#include <vector>

namespace brickwall {

using test::errorOf;

inline std::string testFolder()
{
    return test::scratchFolder().string();
}

/// All fields of a data set, or those that are named.
inline Model loadData(const std::string& data, std::vector<std::string> fields = {}, int threads = 2)
{
    const auto set = openDataSet(data);
    Progress silent;
    return set->load(fields.empty() ? set->fieldNames() : fields, Executor(threads), silent);
}

/// By one thread: where a file is broken in several places, several threads may find another one first.
inline std::string loadError(const std::string& data)
{
    return errorOf([&] { loadData(data, {}, 1); });
}

/// True, or what is missing: the message names all of these, in one line.
inline testing::AssertionResult says(const std::string& message, std::vector<std::string> parts)
{
    for (const std::string& part : parts)
        if (message.find(part) == std::string::npos)
            return testing::AssertionFailure() << "\"" << message << "\" does not say \"" << part << "\"";
    if (message.find('\n') != std::string::npos)
        return testing::AssertionFailure() << "\"" << message << "\" is more than one line";
    return testing::AssertionSuccess();
}

/// Lower corner in voxels and level of every cell, with its value.
using CellValues = std::map<std::array<int, 4>, float>;

inline CellValues cellValues(const Model& model, std::size_t field = 0)
{
    CellValues cells;
    for (const Brick& b : model.bricks)
        for (std::uint64_t i = 0; i < b.cellCount(); ++i) {
            const vec3i c =
                b.lower + b.cellWidth() * vec3i(i % b.size.x, i / b.size.x % b.size.y, i / b.size.x / b.size.y);
            cells[{c.x, c.y, c.z, b.level}] = model.fields.empty() ? 0.f : model.fields[field].values[b.begin + i];
        }
    EXPECT_EQ(cells.size(), model.cellCount);
    return cells;
}

} // namespace brickwall
