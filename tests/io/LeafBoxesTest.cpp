// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/LeafBoxes.h"
#include "brickwall/core/model/Model.h"
#include "brickwall/tests/io/IoTest.h"

#include <random>

namespace brickwall {
namespace {

std::vector<LeafBox> subtract(const std::vector<Box3i>& boxes, const std::vector<Box3i>& holes, int threads = 1)
{
    return subtractBoxes(boxes, holes, Executor(threads), Progress());
}

/// The number of boxes that have each cell of [0, n)^3.
std::vector<int> coverage(const std::vector<Box3i>& boxes, int n)
{
    std::vector<int> count(std::size_t(n) * n * n);
    for (const Box3i& b : boxes)
        for (int z = b.lower.z; z < b.upper.z; ++z)
            for (int y = b.lower.y; y < b.upper.y; ++y)
                for (int x = b.lower.x; x < b.upper.x; ++x)
                    ++count[x + n * (y + std::size_t(n) * z)];
    return count;
}

std::vector<Box3i> randomBoxes(unsigned seed, int count, int n)
{
    std::mt19937 random(seed);
    std::vector<Box3i> boxes;
    for (int i = 0; i < count; ++i) {
        vec3i a, e;
        for (int axis = 0; axis < 3; ++axis) {
            a[axis] = static_cast<int>(random() % static_cast<unsigned>(n));
            e[axis] = 1 + static_cast<int>(random() % 6u);
        }
        boxes.push_back({a, glm::min(a + e, vec3i(n))});
    }
    return boxes;
}

OverlappingLevel level(int number, std::vector<Box3i> boxes)
{
    return {"Level_" + std::to_string(number) + "/Cell_H", number, std::move(boxes)};
}

std::string leafError(const std::vector<OverlappingLevel>& levels)
{
    return errorOf([&] { leafBoxes(levels, Executor(1), Progress()); });
}

TEST(LeafBoxes, WithoutHolesAreTheBoxes)
{
    const std::vector<Box3i> boxes{{{0, 0, 0}, {4, 4, 4}}, {{4, 0, 0}, {8, 2, 1}}};
    const auto pieces = subtract(boxes, {{{100, 0, 0}, {101, 1, 1}}, {{8, 0, 0}, {9, 2, 1}}});
    ASSERT_EQ(pieces.size(), 2u);
    EXPECT_EQ(pieces[0], (LeafBox{boxes[0], 0, 0}));
    EXPECT_EQ(pieces[1], (LeafBox{boxes[1], 0, 1}));
}

TEST(LeafBoxes, OfACoveredBoxThereAreNone)
{
    EXPECT_TRUE(subtract({{{0, 0, 0}, {4, 4, 4}}}, {{{-1, -1, -1}, {9, 9, 9}}}).empty());
    // covered by two together, neither of which covers it alone
    EXPECT_TRUE(subtract({{{0, 0, 0}, {4, 4, 4}}}, {{{0, 0, 0}, {2, 4, 4}}, {{2, 0, 0}, {4, 4, 4}}}).empty());
}

TEST(LeafBoxes, ACornerHoleLeavesThreePieces)
{
    EXPECT_EQ(subtract({{{0, 0, 0}, {4, 4, 4}}}, {{{0, 0, 0}, {2, 2, 2}}}).size(), 3u);
}

TEST(LeafBoxes, AndHolesCoverEachCellOfTheBoxesOnce)
{
    constexpr int n = 16;
    for (unsigned seed = 0; seed < 40; ++seed) {
        // Eight octants, and holes that may overlap each other and cross the octants' faces.
        std::vector<Box3i> boxes;
        for (int i = 0; i < 8; ++i) {
            const vec3i low = 8 * vec3i(i & 1, i >> 1 & 1, i >> 2);
            boxes.push_back({low, low + 8});
        }
        const auto holes = randomBoxes(seed, static_cast<int>(seed), n);
        std::vector<Box3i> pieces;
        for (const LeafBox& piece : subtract(boxes, holes)) {
            EXPECT_TRUE(boxes[piece.source].contains(piece.box));
            EXPECT_FALSE(piece.box.empty());
            pieces.push_back(piece.box);
        }
        const auto leaf = coverage(pieces, n), hole = coverage(holes, n);
        for (std::size_t i = 0; i < leaf.size(); ++i)
            ASSERT_EQ(leaf[i], hole[i] > 0 ? 0 : 1) << "seed " << seed << ", cell " << i;
    }
}

TEST(LeafBoxes, DoNotDependOnTheThreads)
{
    const auto boxes = randomBoxes(1, 100, 16), holes = randomBoxes(2, 100, 16);
    EXPECT_EQ(subtract(boxes, holes, 1), subtract(boxes, holes, 4));
}

TEST(LeafBoxes, StayFewWithManyHoles)
{
    // 8000 separate cubes in one box: about six pieces each, not a piece per pair of cubes.
    std::vector<Box3i> holes;
    for (int z = 0; z < 20; ++z)
        for (int y = 0; y < 20; ++y)
            for (int x = 0; x < 20; ++x)
                holes.push_back({vec3i(x, y, z) * 4, vec3i(x, y, z) * 4 + 2});
    const auto pieces = subtract({{{0, 0, 0}, {80, 80, 80}}}, holes);
    EXPECT_LT(pieces.size(), 7 * holes.size());
    std::int64_t cells = 0;
    for (const LeafBox& piece : pieces)
        cells += volume(piece.box);
    EXPECT_EQ(cells, 80 * 80 * 80 - 8 * 8000);
}

TEST(LeafBoxes, OfLevelsCoverTheUnionOnce)
{
    // Level 0 sticks out of level 1 into level 2, as no proper nesting allows, but aligned to level 2.
    const std::vector<OverlappingLevel> levels{level(2, {{{0, 0, 0}, {16, 16, 8}}, {{0, 0, 8}, {16, 16, 16}}}),
                                               level(1, {{{4, 4, 4}, {12, 12, 8}}}),
                                               level(0, {{{8, 8, 4}, {12, 16, 12}}})};
    std::vector<Box3i> pieces;
    for (const LeafBox& leaf : leafBoxes(levels, Executor(1), Progress())) {
        const int width = 1 << levels[leaf.levelIndex].level;
        EXPECT_EQ(leaf.box.lower % width, vec3i(0));
        EXPECT_EQ(leaf.box.upper % width, vec3i(0));
        EXPECT_TRUE(levels[leaf.levelIndex].boxes[leaf.source].contains(leaf.box));
        for (std::size_t finer = leaf.levelIndex + 1; finer < levels.size(); ++finer)
            EXPECT_FALSE(leaf.box.overlaps(levels[finer].boxes[0]));
        pieces.push_back(leaf.box);
    }
    EXPECT_EQ(coverage(pieces, 16), std::vector<int>(16 * 16 * 16, 1));
}

TEST(LeafBoxes, RefuseMisalignedBoxes)
{
    EXPECT_TRUE(says(
        leafError({level(1, {{{0, 0, 0}, {8, 8, 8}}}), level(0, {{{0, 0, 0}, {2, 2, 2}}, {{3, 2, 2}, {4, 4, 4}}})}),
        {"Level_0/Cell_H", "box 1", "misaligned", "[3,2,2"}));
    EXPECT_TRUE(says(leafError({level(1, {{{0, 0, 0}, {8, 8, 7}}})}), {"Level_1/Cell_H", "box 0", "not aligned"}));
}

TEST(LeafBoxes, ThatCoverNoOthersNeedNoAlignmentToThem)
{
    const std::vector<OverlappingLevel> levels{level(2, {{{0, 0, 0}, {8, 8, 8}}}), level(0, {{{8, 1, 3}, {9, 2, 8}}})};
    const std::vector<LeafBox> leaves = leafBoxes(levels, Executor(1), Progress());
    ASSERT_EQ(leaves.size(), 2u);
    EXPECT_EQ(leaves[0], (LeafBox{levels[0].boxes[0], 0, 0}));
    EXPECT_EQ(leaves[1], (LeafBox{levels[1].boxes[0], 1, 0}));
}

TEST(LeafBoxes, MayBeWholeCoarserCellsTogether)
{
    // Two boxes, three and five cells wide, that fill the left half of a coarse one.
    const std::vector<OverlappingLevel> levels{level(1, {{{0, 0, 0}, {16, 8, 8}}}),
                                               level(0, {{{0, 0, 0}, {3, 8, 8}}, {{3, 0, 0}, {8, 8, 8}}})};
    const std::vector<LeafBox> leaves = leafBoxes(levels, Executor(1), Progress());
    ASSERT_EQ(leaves.size(), 3u);
    EXPECT_EQ(leaves[0], (LeafBox{{{8, 0, 0}, {16, 8, 8}}, 0, 0}));
    EXPECT_EQ(leaves[2], (LeafBox{levels[1].boxes[1], 1, 1}));
}

TEST(LeafBoxes, RefuseOverlapsWithinALevel)
{
    const Box3i a{{0, 0, 0}, {8, 8, 8}}, b{{8, 0, 0}, {9, 8, 8}}, c{{6, 7, 7}, {7, 8, 9}};
    EXPECT_TRUE(says(leafError({level(0, {a, b, c})}), {"Level_0/Cell_H", "boxes 0 and 2", "overlap"}));
    EXPECT_EQ(findOverlap(std::vector{a, b}), std::nullopt);
}

TEST(LeafBoxes, RefuseEmptyAndFarBoxes)
{
    EXPECT_TRUE(says(leafError({level(0, {{{0, 0, 0}, {0, 8, 8}}})}), {"Level_0/Cell_H", "box 0", "is empty"}));
    const int far = coordinateLimit;
    EXPECT_TRUE(says(leafError({level(0, {{{far, 0, 0}, {far + 1, 8, 8}}})}), {"Level_0/Cell_H", "box 0", "outside"}));
}

TEST(LeafBoxes, CanBeCancelled)
{
    Progress progress;
    progress.cancel();
    const std::vector<Box3i> boxes{{{0, 0, 0}, {1, 1, 1}}};
    EXPECT_THROW(subtractBoxes(boxes, {}, Executor(1), progress), Cancelled);
}

} // namespace
} // namespace brickwall
