// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/BrickBuilder.h"

#include "Layouts.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/model/CheckModel.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <utility>

namespace brickwall {
namespace {

std::vector<Cell> shuffled(std::vector<Cell> cells, std::uint64_t seed)
{
    oracles::Random random(seed);
    for (std::size_t i = cells.size(); i > 1; --i)
        std::swap(cells[i - 1], cells[std::size_t(random.below(int(i)))]);
    return cells;
}

BrickLayout build(std::span<const Cell> cells, int maxBrickWidth = 64, int threads = 1)
{
    Progress silent;
    return buildBricks(cells, "test.cells", {maxBrickWidth}, Executor(threads), silent);
}

BrickLayout merge(std::span<const Brick> bricks, int maxBrickWidth = 64, int threads = 1)
{
    Progress silent;
    return mergeBricks(bricks, {maxBrickWidth}, Executor(threads), silent);
}

std::string messageOf(std::span<const Cell> cells)
{
    try {
        build(cells);
    } catch (const Error& e) {
        return e.what();
    }
    return "no error";
}

bool sameBricks(std::span<const Brick> a, std::span<const Brick> b)
{
    return std::equal(a.begin(), a.end(), b.begin(), b.end(), [](const Brick& x, const Brick& y) {
        return x.lower == y.lower && x.size == y.size && x.level == y.level && x.begin == y.begin;
    });
}

/// Every slot of the layout is the cell that its source says, and every source is used once.
void expectKeepsCells(const BrickLayout& layout, std::span<const Cell> source)
{
    const std::vector<Cell> cells = oracles::cellsOfBricks(layout.bricks);
    ASSERT_EQ(cells.size(), layout.source.size());
    std::vector<bool> used(source.size());
    for (std::size_t i = 0; i < cells.size(); ++i) {
        const std::uint32_t s = layout.source[i];
        ASSERT_LT(s, source.size());
        ASSERT_FALSE(used[s]);
        used[s] = true;
        ASSERT_EQ(cells[i].lower, source[s].lower);
        ASSERT_EQ(cells[i].level, source[s].level);
    }
}

class BricksOf : public testing::TestWithParam<NamedLayout>
{
protected:
    const std::vector<Brick>& bricks = GetParam().bricks;
};

TEST_P(BricksOf, LooseCellsKeepEveryCell)
{
    const std::vector<Cell> cells = shuffled(oracles::cellsOfBricks(bricks), 5);
    for (const int width : {1, 3, 64}) {
        const BrickLayout layout = build(cells, width);
        EXPECT_EQ(layout.source.size(), cells.size());
        EXPECT_EQ(layout.duplicates, 0u);
        expectKeepsCells(layout, cells);
        EXPECT_NO_THROW(checkBricks(layout.bricks, "built"));
        for (const Brick& b : layout.bricks)
            EXPECT_LE(std::max({b.size.x, b.size.y, b.size.z}), width);
    }
    EXPECT_LE(build(cells).bricks.size(), cells.size());
}

TEST_P(BricksOf, MergingKeepEveryCellAndAreNoMore)
{
    const BrickLayout merged = merge(bricks);
    const std::vector<Cell> cells = oracles::cellsOfBricks(bricks);
    EXPECT_EQ(merged.source.size(), cells.size());
    expectKeepsCells(merged, cells);
    EXPECT_LE(merged.bricks.size(), bricks.size());
    EXPECT_NO_THROW(checkBricks(merged.bricks, "merged"));
    EXPECT_TRUE(sameBricks(merge(merged.bricks).bricks, merged.bricks)) << "nothing is left to merge";
}

TEST_P(BricksOf, AreTheSameOnOneCoreAndOnMany)
{
    const std::vector<Cell> cells = shuffled(oracles::cellsOfBricks(bricks), 6);
    const BrickLayout a = build(cells, 8, 1), b = build(cells, 8, 4);
    EXPECT_TRUE(sameBricks(a.bricks, b.bricks));
    EXPECT_EQ(a.source, b.source);
    EXPECT_EQ(merge(bricks, 8, 1).source, merge(bricks, 8, 4).source);
}

INSTANTIATE_TEST_SUITE_P(Layouts, BricksOf, testing::ValuesIn(layouts()), [](const auto& info) {
    std::string name = info.param.name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
});

TEST(BrickBuilder, FindsTheBlocksOfOneLevelAgain)
{
    const auto cells = shuffled(oracles::cellsOfBricks(oracles::uniformBlocks({4, 2, 2}, 8, 2)), 1);
    EXPECT_EQ(build(cells, 16).bricks.size(), 2u);
    EXPECT_EQ(build(cells, 64).bricks.size(), 1u);
}

TEST(BrickBuilder, MakesFewLargeBricksOfNestedLevels)
{
    const auto bricks = oracles::nestedLevels(3, 8, 4);
    EXPECT_LE(build(oracles::cellsOfBricks(bricks)).bricks.size(), 40u); // of 1408 blocks
}

TEST(BrickBuilder, SortsTheSameWayOnManyCores)
{
    const auto cells = shuffled(oracles::cellsOfBricks(oracles::uniformBlocks({3, 3, 3}, 24)), 2);
    ASSERT_GT(cells.size(), std::size_t(1) << 18);
    EXPECT_EQ(build(cells, 32, 1).source, build(cells, 32, 4).source);
}

TEST(BrickBuilder, DropsAndCountsDuplicatesKeepingTheFirst)
{
    const std::vector<Cell> cells{{{1, 0, 0}, 0}, {{0, 0, 0}, 0}, {{1, 0, 0}, 0}, {{0, 0, 0}, 0}, {{0, 0, 0}, 0}};
    const BrickLayout layout = build(cells);
    EXPECT_EQ(layout.duplicates, 3u);
    EXPECT_EQ(layout.bricks.size(), 1u);
    EXPECT_EQ(layout.source, (std::vector<std::uint32_t>{1, 0}));
}

TEST(BrickBuilder, TakesNoCellsForNoBricks)
{
    EXPECT_TRUE(build({}).bricks.empty());
    EXPECT_TRUE(merge({}).bricks.empty());
}

TEST(BrickBuilder, RefusesOverlappingLevelsNamingBothRecords)
{
    const std::vector<Cell> cells{{{8, 0, 0}, 0}, {{0, 0, 0}, 2}, {{4, 0, 0}, 2}, {{3, 2, 1}, 0}};
    const std::string message = messageOf(cells);
    EXPECT_NE(message.find("test.cells: "), std::string::npos) << message;
    EXPECT_NE(message.find("cell 1 (lower 0 0 0, level 2) and cell 3 (lower 3 2 1, level 0) overlap at voxel 3 2 1"),
              std::string::npos)
        << message;
}

TEST(BrickBuilder, RefusesWhatIsNoCellNamingTheRecord)
{
    const auto expect = [](const Cell& bad, const std::string& words) {
        const std::vector<Cell> cells{{{0, 0, 0}, 0}, bad};
        const std::string message = messageOf(cells);
        EXPECT_NE(message.find("cell 1 ("), std::string::npos) << message;
        EXPECT_NE(message.find(words), std::string::npos) << message;
    };
    expect({{4, 2, 4}, 2}, "multiple of the cell width 4, found 2 along y");
    expect({{0, 0, 0}, -1}, "level from 0 to 24");
    expect({{0, 0, 0}, 25}, "level from 0 to 24");
    expect({{0, 0, 2000000000}, 0}, "found 2000000000 to 2000000001 along z");
    expect({{std::numeric_limits<int>::min(), 0, 0}, 0}, "along x");
    expect({{coordinateLimit, 0, 0}, 0}, "along x");
}

TEST(BrickBuilder, RefusesABrickWidthOfNothing)
{
    EXPECT_THROW(build({}, 0), Error);
    EXPECT_THROW(merge({}, -1), Error);
}

TEST(BrickBuilder, CanBeCancelled)
{
    const auto bricks = oracles::uniformBlocks({2, 2, 2}, 4);
    const auto cells = oracles::cellsOfBricks(bricks);
    Progress progress;
    progress.cancel();
    EXPECT_THROW(buildBricks(cells, "x", {}, Executor(1), progress), Cancelled);
    EXPECT_THROW(mergeBricks(bricks, {}, Executor(1), progress), Cancelled);
}

TEST(BrickBuilder, GathersValuesInTheOrderOfTheLayout)
{
    const std::vector<float> values{10, 11, 12};
    const std::vector<std::uint32_t> source{2, 0, 0, 1};
    EXPECT_EQ(gather(values, source, Executor(2)), (std::vector<float>{12, 10, 10, 11}));
}

} // namespace
} // namespace brickwall
