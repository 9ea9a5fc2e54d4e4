// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/Convert.h"
#include "brickwall/core/io/DerivedFields.h"
#include "brickwall/tests/io/IoTest.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

namespace brickwall::convert_test {

using Texts = std::vector<std::string>;

/// A cell where it is relative to the lower corner of all, and the bits of its value. Formats may count voxels from
/// another corner, and have no finer levels than there are cells of.
struct PlacedValue
{
    std::array<int, 4> cell;
    std::uint32_t bits;

    auto operator<=>(const PlacedValue&) const = default;
};

inline std::vector<PlacedValue> placedValues(const Model& model, std::size_t field)
{
    const vec3i corner = voxelBounds(model.bricks).lower;
    int finest = maxLevel;
    for (const Brick& b : model.bricks)
        finest = std::min(finest, b.level);
    std::vector<PlacedValue> values;
    for (const Brick& b : model.bricks)
        for (std::uint64_t i = 0; i < b.cellCount(); ++i) {
            const vec3i c = b.lower - corner +
                            b.cellWidth() * vec3i(i % b.size.x, i / b.size.x % b.size.y, i / b.size.x / b.size.y);
            values.push_back({{c.x >> finest, c.y >> finest, c.z >> finest, b.level - finest},
                              std::bit_cast<std::uint32_t>(model.fields[field].values[b.begin + i])});
        }
    std::sort(values.begin(), values.end());
    return values;
}

/// The same cells with the same bits, field by field in this order, in the same place of the world.
inline void expectSame(const Model& found, const Model& expected)
{
    ASSERT_EQ(found.cellCount, expected.cellCount);
    ASSERT_EQ(found.fields.size(), expected.fields.size());
    for (std::size_t f = 0; f < expected.fields.size(); ++f) {
        EXPECT_EQ(found.fields[f].range, expected.fields[f].range) << expected.fields[f].name;
        EXPECT_TRUE(placedValues(found, f) == placedValues(expected, f)) << expected.fields[f].name;
    }
    const Box3d a = worldBounds(found), b = worldBounds(expected);
    for (int axis = 0; axis < 3; ++axis) {
        const double digits = 1e-13 * (std::abs(b.lower[axis]) + std::abs(b.upper[axis]));
        EXPECT_NEAR(a.lower[axis], b.lower[axis], digits);
        EXPECT_NEAR(a.upper[axis], b.upper[axis], digits);
    }
}

/// A data set without a file.
class ModelData : public DataSet
{
public:
    explicit ModelData(Model model) : model_(std::move(model)) {}

    std::string format() const override { return "test"; }
    std::vector<std::string> fieldNames() const override
    {
        Texts names;
        for (const Field& field : model_.fields)
            names.push_back(field.name);
        return names;
    }
    std::string defaultField() const override { return model_.fields.empty() ? "" : model_.fields[0].name; }
    Model load(std::span<const std::string> fields, const Executor&, Progress& progress, NonFinite) const override
    {
        progress.check();
        Model model = model_;
        model.fields.clear();
        for (const std::string& name : fields)
            model.fields.push_back(fieldNamed(model_, name));
        return model;
    }

private:
    Model model_;
};

inline void convertTo(const std::string& destination, const DataSet& source, const ConvertOptions& options = {})
{
    Progress silent;
    convert(source, destination, options, Executor(2), silent);
}

/// The names of all that is in a folder, and below.
inline std::set<std::string> filesIn(const std::filesystem::path& folder)
{
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
        names.insert(std::filesystem::relative(entry.path(), folder).string());
    return names;
}

inline Model loaded(const DataSet& set, const Texts& fields)
{
    Progress silent;
    return set.load(fields, Executor(2), silent);
}

} // namespace brickwall::convert_test
