// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/io/IoTest.h"
#include "brickwall/tests/oracles/WriteExa.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace brickwall {
namespace {

using namespace oracles;

class Cells : public testing::Test
{
protected:
    void SetUp() override { folder_ = testFolder(); }

    std::string cells(const std::vector<Cell>& records)
    {
        writeCells(folder_ + "/t.cells", records);
        return folder_ + "/t.cells";
    }

    std::string folder_;
};

TEST_F(Cells, InAnyOrderKeepTheirValues)
{
    std::vector<Cell> all;
    for (int i = 0; i < 64; ++i)
        all.push_back({2 * vec3i(i % 4, i / 4 % 4, i / 16), 1});
    for (int i = 0; i < 512; ++i)
        all.push_back({vec3i(-8, 0, 0) + vec3i(i % 8, i / 8 % 8, i / 64), 0});
    std::shuffle(all.begin(), all.end(), std::mt19937(7));
    std::vector<float> values(all.size());
    std::iota(values.begin(), values.end(), 0.5f);
    const std::string path = cells(all);
    writeScalars(folder_ + "/t.dens.scalars", values);
    EXPECT_EQ(openDataSet(path)->fieldNames(), std::vector<std::string>{"dens"});
    const Model model = loadData(path);
    const CellValues found = cellValues(model);
    ASSERT_EQ(found.size(), all.size());
    for (std::size_t i = 0; i < all.size(); ++i)
        EXPECT_EQ(found.at({all[i].lower.x, all[i].lower.y, all[i].lower.z, all[i].level}), values[i]);
    EXPECT_LT(model.bricks.size(), 10u);
}

TEST_F(Cells, DuplicatesAreDroppedAndNoted)
{
    const std::string path = cells({{{0, 0, 0}, 0}, {{1, 0, 0}, 0}, {{0, 0, 0}, 0}});
    writeScalars(folder_ + "/t.scalars", std::vector<float>{1, 2, 3});
    const Model model = loadData(path);
    EXPECT_EQ(model.cellCount, 2u);
    EXPECT_EQ(cellValues(model).at({0, 0, 0, 0}), 1);
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_TRUE(says(model.notes[0], {"t.cells", "1 duplicate"}));
}

TEST_F(Cells, OddSizesAreTruncated)
{
    const std::string path = cells({{{0, 0, 0}, 0}, {{1, 0, 0}, 0}});
    std::filesystem::resize_file(path, 27);
    EXPECT_TRUE(says(loadError(path), {"t.cells", "cell record 1 at byte 16", "found 11"}));
    EXPECT_TRUE(says(loadError(cells({})), {"t.cells", "empty"}));
}

TEST_F(Cells, AreCheckedOneByOne)
{
    EXPECT_TRUE(says(loadError(cells({{{0, 0, 0}, 1 << 24}})), {"t.cells", "cell record 0", "little-endian"}));
    EXPECT_TRUE(says(loadError(cells({{{0, 0, 0}, 0}, {{0, 0, 0}, -3}})), {"cell record 1 at byte 16", "found -3"}));
    EXPECT_TRUE(says(loadError(cells({{{0, 0, 0}, 0}, {{2, 2, 3}, 1}})),
                     {"cell record 1 at byte 16", "misaligned", "(2,2,3)"}));
    EXPECT_TRUE(says(loadError(cells({{{1 << 30, 0, 0}, 0}})), {"cell record 0", "coordinates"}));
}

TEST_F(Cells, OverlapsOfLevelsAreErrors)
{
    EXPECT_TRUE(says(loadError(cells({{{0, 0, 0}, 1}, {{4, 0, 0}, 0}, {{1, 1, 1}, 0}})), {"t.cells"}));
}

TEST_F(Cells, TooFewScalarsNameTheCell)
{
    const std::string path = cells({{{0, 0, 0}, 0}, {{1, 0, 0}, 0}});
    writeScalars(folder_ + "/t.scalars", std::vector<float>{1});
    EXPECT_TRUE(says(loadError(path), {"t.cells", "cell ID 1", "voxel (1,0,0)", "t.scalars", "1 values"}));
}

TEST_F(Cells, NonFiniteValuesNameTheCell)
{
    const std::string path = cells({{{0, 0, 0}, 0}, {{1, 0, 0}, 0}});
    writeScalars(folder_ + "/t.scalars", std::vector<float>{1, std::numeric_limits<float>::quiet_NaN()});
    EXPECT_TRUE(says(loadError(path), {"t.scalars", "'scalar'", "nan", "voxel (1,0,0)"}));
}

} // namespace
} // namespace brickwall
