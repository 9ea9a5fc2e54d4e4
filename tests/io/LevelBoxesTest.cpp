// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/LeafFields.h"
#include "brickwall/tests/io/IoTest.h"

namespace brickwall {
namespace {

LeafPlan plan(const std::vector<BoxLevel>& levels)
{
    Progress silent;
    return planLeaves(levels, "set", Executor(2), silent);
}

LeafPlan disjoint(const std::vector<BoxLevel>& levels)
{
    Progress silent;
    return planDisjoint(levels, "set", silent);
}

TEST(LevelBoxes, LevelsAreNumberedFromTheFinest)
{
    EXPECT_EQ(levelNumbers(std::vector<int>{}, "set"), std::vector<int>{0});
    EXPECT_EQ(levelNumbers(std::vector<int>{2, 4, 8}, "set"), (std::vector<int>{6, 5, 3, 0}));
    for (const int wrong : {-2, 0, 1, 3, 6})
        EXPECT_TRUE(says(errorOf([&] {
                             levelNumbers(std::vector<int>{2, wrong}, "set");
                         }),
                         {"set", "power of two", std::to_string(wrong), "levels 1 and 2"}));
    EXPECT_TRUE(says(errorOf([] { levelNumbers(std::vector<int>(25, 2), "set"); }), {"2^24", "2^25 on level 0"}));
}

TEST(LevelBoxes, PiecesTileTheBricksTheyGoTo)
{
    const std::vector<BoxLevel> levels{{"coarse", 1, {{{0, 0, 0}, {4, 4, 4}}, {{4, 0, 0}, {8, 4, 4}}}},
                                       {"fine", 0, {{{2, 2, 2}, {10, 6, 6}}}}};
    const LeafPlan p = plan(levels);
    EXPECT_EQ(p.coveredCells, 16u);
    EXPECT_EQ(p.cellCount, 128u - 16 + 128);
    std::vector<std::uint64_t> filled(p.bricks.size(), 0);
    std::size_t next = 0;
    for (const LeafJob& job : p.jobs) {
        EXPECT_EQ(job.firstPiece, next);
        next = job.endPiece;
        for (std::size_t i = job.firstPiece; i < job.endPiece; ++i) {
            const LeafPiece& piece = p.pieces[i];
            const int width = 1 << levels[job.levelIndex].level;
            EXPECT_TRUE(levels[job.levelIndex].boxes[job.box].contains(piece.cells));
            EXPECT_TRUE(
                p.bricks[piece.brick].box().contains(Box3i{piece.cells.lower * width, piece.cells.upper * width}));
            filled[piece.brick] += static_cast<std::uint64_t>(volume(piece.cells));
        }
    }
    EXPECT_EQ(next, p.pieces.size());
    for (std::size_t b = 0; b < p.bricks.size(); ++b)
        EXPECT_EQ(filled[b], p.bricks[b].cellCount());
}

TEST(LevelBoxes, CellsBeyondCountingAreRefused)
{
    const int far = coordinateLimit;
    const Box3i all{{-far, -far, -far}, {far, far, far}}; // 2^87 cells: 0 modulo 2^64
    EXPECT_TRUE(says(errorOf([&] { plan({{"level", 0, {all}}}); }), {"set", "2^32", "1.547"}));
    EXPECT_TRUE(says(errorOf([&] { disjoint({{"level", 0, {all}}}); }), {"set", "2^32"}));
    EXPECT_TRUE(says(errorOf([&] { plan({{"level", 0, {{{0, 0, 0}, {1 << 11, 1 << 11, 1 << 10}}}}}); }), {"2^32"}));
    EXPECT_TRUE(says(errorOf([&] { plan({{"level", 1, {all}}}); }), {"level", "box 0", "along x"}));
    EXPECT_TRUE(says(errorOf([&] { plan({{"level", 0, {}}}); }), {"set", "no boxes"}));
}

TEST(LevelBoxes, LeavesThatOverlapAreNamedWithTheirLevels)
{
    const std::vector<BoxLevel> levels{{"fine", 0, {{{0, 0, 0}, {4, 4, 4}}, {{7, 7, 7}, {9, 9, 9}}}},
                                       {"coarse", 2, {{{1, 1, 1}, {2, 2, 2}}, {{2, 2, 2}, {3, 3, 3}}}}};
    EXPECT_TRUE(says(errorOf([&] { disjoint(levels); }), {"box 1 of fine", "box 0 of coarse"}));
    EXPECT_TRUE(says(errorOf([&] { disjoint({{"fine", 0, {{{0, 0, 0}, {4, 0, 4}}}}}); }), {"fine", "box 0 is empty"}));
}

TEST(LevelBoxes, UsualFieldsComeFirst)
{
    EXPECT_EQ(usualField({"pres", "dens", "speed"}), "speed");
    EXPECT_EQ(usualField({"pres", "temp"}), "pres");
    EXPECT_EQ(usualField({}), "");
}

} // namespace
} // namespace brickwall
