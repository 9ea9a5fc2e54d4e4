// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/io/IoTest.h"
#include "brickwall/tests/oracles/WriteExa.h"

#include <numeric>

namespace brickwall {
namespace {

using namespace oracles;

std::vector<std::int32_t> ids(int count, int first = 0)
{
    std::vector<std::int32_t> v(static_cast<std::size_t>(count));
    std::iota(v.begin(), v.end(), first);
    return v;
}

class Bricks : public testing::Test
{
protected:
    void SetUp() override { folder_ = testFolder(); }

    std::string bricks(const std::vector<BrickRecord>& records)
    {
        writeBricks(folder_ + "/t.bricks", records);
        return folder_ + "/t.bricks";
    }
    void shorten(std::uintmax_t bytes)
    {
        const std::string path = folder_ + "/t.bricks";
        std::filesystem::resize_file(path, std::filesystem::file_size(path) - bytes);
    }

    std::string folder_;
};

TEST_F(Bricks, OpenedAloneHaveNoFields)
{
    const std::string path = bricks({{{2, 3, 4}, {2, 4, 8}, 1, ids(24)}});
    EXPECT_TRUE(openDataSet(path)->fieldNames().empty());
    EXPECT_EQ(openDataSet(path)->defaultField(), "");
    const Model model = loadData(path);
    EXPECT_EQ(model.cellCount, 24u);
    EXPECT_EQ(model.bricks[0].box(), (Box3i{{2, 4, 8}, {6, 10, 16}}));
}

TEST_F(Bricks, FindTheScalarsBesideThem)
{
    const std::string path = bricks({{{2, 1, 1}, {0, 0, 0}, 0, {1, 0}}});
    writeScalars(folder_ + "/t.scalars", std::vector<float>{1, 2});
    writeScalars(folder_ + "/t.dens.scalar", std::vector<float>{3, 4});
    writeScalars(folder_ + "/t.x.velocity.scalars", std::vector<float>{5, 6});
    writeScalars(folder_ + "/t.other.scalars", std::vector<float>{7, 8}); // belongs to t.other.bricks
    writeText(folder_ + "/t.other.bricks", "");
    writeScalars(folder_ + "/toto.scalars", std::vector<float>{9, 10});
    EXPECT_EQ(openDataSet(path)->fieldNames(), (std::vector<std::string>{"dens", "scalar", "x.velocity"}));
    EXPECT_EQ(loadData(path, {"x.velocity"}).fields[0].values, (std::vector<float>{6, 5}));
}

TEST_F(Bricks, ScalarsOfBothEndingsAreBothThere)
{
    const std::string path = bricks({{{2, 1, 1}, {0, 0, 0}, 0, {1, 0}}});
    writeScalars(folder_ + "/t.p.scalars", std::vector<float>{1, 2});
    writeScalars(folder_ + "/t.p.scalar", std::vector<float>{3, 4});
    EXPECT_EQ(openDataSet(path)->fieldNames(), (std::vector<std::string>{"p", "p.scalars"}));
    EXPECT_EQ(loadData(path, {"p.scalars"}).fields[0].values, (std::vector<float>{2, 1}));
}

TEST_F(Bricks, EmptyCellsAreCarvedOut)
{
    // A brick of 4^3 without its first cell and without the last plane, beside a full one.
    auto holed = ids(64, 8);
    holed[0] = -1;
    std::fill(holed.begin() + 48, holed.end(), -1);
    const std::string path = bricks({{{4, 4, 4}, {0, 0, 0}, 1, holed}, {{2, 2, 2}, {8, 0, 0}, 0, ids(8)}});
    std::vector<float> values(72);
    std::iota(values.begin(), values.end(), 0.f);
    writeScalars(folder_ + "/t.scalars", values);
    const Model model = loadData(path);
    EXPECT_EQ(model.cellCount, 47u + 8u);
    const CellValues cells = cellValues(model);
    EXPECT_FALSE(cells.contains({0, 0, 0, 1}));
    EXPECT_FALSE(cells.contains({0, 0, 6, 1}));
    for (int i = 1; i < 48; ++i)
        EXPECT_EQ(cells.at({i % 4 * 2, i / 4 % 4 * 2, i / 16 * 2, 1}), static_cast<float>(i + 8));
    EXPECT_EQ(cells.at({9, 1, 1, 0}), 7);
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_TRUE(says(model.notes[0], {"t.bricks", "17 empty cells", "1 bricks", "47 cells"}));
    EXPECT_EQ(cellValues(loadData(path, {}, 1)), cells);
}

TEST_F(Bricks, NothingButEmptyCellsIsAnError)
{
    EXPECT_TRUE(says(loadError(bricks({{{2, 1, 1}, {0, 0, 0}, 0, {-1, -1}}})), {"t.bricks", "nothing but empty"}));
}

TEST_F(Bricks, OtherNegativeIDsAreErrors)
{
    EXPECT_TRUE(says(loadError(bricks({{{1, 1, 1}, {0, 0, 0}, 0, {0}}, {{2, 1, 1}, {4, 0, 0}, 0, {1, -2}}})),
                     {"t.bricks", "found -2", "cell (1,0,0) of brick 1"}));
}

TEST_F(Bricks, TruncationNamesRecordAndByte)
{
    const std::vector<BrickRecord> two{{{2, 2, 2}, {0, 0, 0}, 0, ids(8)}, {{2, 2, 2}, {2, 0, 0}, 0, ids(8)}};
    bricks(two);
    shorten(4);
    EXPECT_TRUE(
        says(loadError(folder_ + "/t.bricks"), {"t.bricks", "brick record 1 at byte 60", "2 x 2 x 2", "28 bytes"}));
    bricks(two);
    shorten(33); // in the header of the second
    EXPECT_TRUE(says(loadError(folder_ + "/t.bricks"), {"t.bricks", "brick record 1 at byte 60", "found 27"}));
    bricks({{{2, 2, 2}, {0, 0, 0}, 0, {}}});
    EXPECT_TRUE(says(loadError(folder_ + "/t.bricks"), {"brick record 0 at byte 0"}));
}

TEST_F(Bricks, TheOtherByteOrderIsRecognised)
{
    const auto swapped = [](int v) { return static_cast<int>(__builtin_bswap32(static_cast<unsigned>(v))); };
    EXPECT_TRUE(says(loadError(bricks({{vec3i(swapped(4)), {0, 0, 0}, 0, ids(64)}})),
                     {"t.bricks", "brick record 0 at byte 0", "not little-endian", "67108864"}));
}

TEST_F(Bricks, AbsurdSizesAreRefusedBeforeMemoryIsAsked)
{
    const int huge = 0x7fffffff;
    EXPECT_TRUE(says(loadError(bricks({{vec3i(huge), {0, 0, 0}, 0, ids(8)}})), {"brick record 0", "2147483647"}));
    // 2^24 * 2^24 * 2^16 is 0 in 64 bits
    EXPECT_TRUE(says(loadError(bricks({{{1 << 24, 1 << 24, 1 << 16}, {0, 0, 0}, 0, {}}})), {"brick record 0"}));
}

TEST_F(Bricks, NegativeAndZeroSizesAreErrors)
{
    EXPECT_TRUE(
        says(loadError(bricks({{{2, -1, 2}, {0, 0, 0}, 0, ids(4)}})), {"brick record 0", "positive size", "(2,-1,2)"}));
    EXPECT_TRUE(says(loadError(bricks({{{1, 1, 1}, {0, 0, 0}, 0, {0}}, {{0, 1, 1}, {4, 0, 0}, 0, {}}})),
                     {"brick record 1 at byte 32", "(0,1,1)"}));
}

TEST_F(Bricks, LevelsPositionsAndAlignmentAreChecked)
{
    EXPECT_TRUE(
        says(loadError(bricks({{{1, 1, 1}, {0, 0, 0}, 25, {0}}})), {"brick record 0", "level from 0 to 24, found 25"}));
    EXPECT_TRUE(says(loadError(bricks({{{1, 1, 1}, {0, 0, 0}, -1, {0}}})), {"brick record 0", "found -1"}));
    EXPECT_TRUE(says(loadError(bricks({{{1, 1, 1}, {0, 3, 0}, 1, {0}}})), {"brick record 0", "misaligned", "(0,3,0)"}));
    EXPECT_TRUE(
        says(loadError(bricks({{{1, 1, 1}, {coordinateLimit, 0, 0}, 0, {0}}})), {"brick record 0", "coordinates"}));
}

TEST_F(Bricks, OverlapsNameBothBricks)
{
    EXPECT_TRUE(says(
        loadError(bricks(
            {{{2, 2, 2}, {0, 0, 0}, 1, ids(8)}, {{2, 2, 2}, {8, 0, 0}, 0, ids(8)}, {{2, 2, 2}, {3, 3, 3}, 0, ids(8)}})),
        {"t.bricks", "brick 0", "brick 2", "overlap"}));
}

TEST_F(Bricks, EmptyFilesAreErrors)
{
    EXPECT_TRUE(says(loadError(bricks({})), {"t.bricks", "empty"}));
}

TEST_F(Bricks, LoadsCanBeCancelled)
{
    const auto set = openDataSet(bricks({{{2, 2, 2}, {0, 0, 0}, 0, ids(8)}}));
    Progress progress;
    progress.cancel();
    EXPECT_THROW(set->load({}, Executor(1), progress), Cancelled);
}

} // namespace
} // namespace brickwall
