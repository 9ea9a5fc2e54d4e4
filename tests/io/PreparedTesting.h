// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/io/PreparedVolume.h"
#include "brickwall/tests/io/ConvertTesting.h"
#include "brickwall/tests/oracles/WriteExa.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

namespace brickwall::prepared_test {

/// Remembers what was said.
class Notes : public Progress
{
public:
    void note(std::string_view line) override { all += std::string(line) + '\n'; }
    std::string all;
};

inline std::string bytesOfFile(const std::string& path)
{
    std::ostringstream text;
    text << std::ifstream(path, std::ios::binary).rdbuf();
    return text.str();
}

/// For structures without gaps.
template <class T>
bool sameBytes(const std::vector<T>& a, const std::vector<T>& b)
{
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

inline bool sameRegions(const RegionTree& a, const RegionTree& b)
{
    const auto same = [](const PaddedBrick& x, const PaddedBrick& y) {
        return x.lower == y.lower && x.size == y.size && x.level == y.level && x.begin == y.begin;
    };
    return a.bounds == b.bounds && sameBytes(a.nodes, b.nodes) && sameBytes(a.regions, b.regions) &&
           a.brickLists == b.brickLists && std::ranges::equal(a.bricks, b.bricks, same) &&
           a.paddedCellCount == b.paddedCellCount && a.depth == b.depth;
}

inline bool sameFields(const PaddedField& a, const PaddedField& b)
{
    return a.values == b.values && a.regionRanges == b.regionRanges && a.regionSlopes == b.regionSlopes &&
           a.regionLogSlopes == b.regionLogSlopes && a.range == b.range;
}

inline void expectSameVolume(const PreparedVolume& a, const PreparedVolume& b)
{
    EXPECT_EQ(a.model.name, b.model.name);
    EXPECT_EQ(a.model.cellCount, b.model.cellCount);
    EXPECT_EQ(a.model.worldFromVoxel, b.model.worldFromVoxel);
    EXPECT_EQ(a.model.notes, b.model.notes);
    ASSERT_EQ(a.model.meshes.size(), b.model.meshes.size());
    for (std::size_t m = 0; m < a.model.meshes.size(); ++m)
        EXPECT_EQ(a.model.meshes[m].vertices, b.model.meshes[m].vertices);
    ASSERT_EQ(a.fields.size(), b.fields.size());
    ASSERT_EQ(a.model.fields.size(), b.model.fields.size());
    EXPECT_TRUE(sameRegions(*a.regions, *b.regions));
    for (std::size_t f = 0; f < a.fields.size(); ++f) {
        EXPECT_EQ(a.model.fields[f].name, b.model.fields[f].name);
        EXPECT_EQ(a.model.fields[f].range, b.model.fields[f].range);
        EXPECT_EQ(a.model.fields[f].preferredRange, b.model.fields[f].preferredRange);
        EXPECT_TRUE(sameFields(*a.fields[f], *b.fields[f]));
    }
    ASSERT_EQ(a.pyramid.size(), b.pyramid.size());
    for (std::size_t m = 0; m < a.pyramid.size(); ++m) {
        EXPECT_EQ(a.pyramid[m].level, b.pyramid[m].level);
        EXPECT_TRUE(sameRegions(*a.pyramid[m].regions, *b.pyramid[m].regions));
        EXPECT_TRUE(sameFields(*a.pyramid[m].fields[0], *b.pyramid[m].fields[0]));
    }
}

/// A data set of three levels with two fields and a mesh, and a cache that keeps even that.
class Prepared : public testing::Test
{
protected:
    void SetUp() override
    {
        Model model = loadData("sample:wake:50k", {"speed", "u"});
        model.meshes = {{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}};
        data = oracles::writeExa(testFolder(), "t", model);
        request = {data, {}, {"speed"}};
        cache.folder = testFolder() + "/cache/of a user";
        cache.leastCells = 0;
        cache.leastFreeBytes = 0;
    }

    PreparedVolume prepare(Progress& progress, int threads = 2) const
    {
        return prepareVolume(*openDataSet(data), request, cache, Executor(threads), progress);
    }
    PreparedVolume prepare() const
    {
        Progress silent;
        return prepare(silent);
    }
    std::string cached() const
    {
        for (const auto& entry : std::filesystem::directory_iterator(cache.folder))
            return entry.path().string();
        return {};
    }
    std::size_t filesInCache() const
    {
        return std::filesystem::exists(cache.folder) ? convert_test::filesIn(cache.folder).size() : 0;
    }

    std::string data;
    VolumeRequest request;
    VolumeCache cache;
};

} // namespace brickwall::prepared_test
