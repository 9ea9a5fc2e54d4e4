// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/Regions.h"

#include "Interpolant.h"
#include "Layouts.h"

#include "brickwall/core/model/CheckModel.h"
#include "brickwall/core/model/PadField.h"
#include "brickwall/tests/oracles/ReferenceReconstruction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstring>

namespace brickwall {
namespace {

Box3i boxOf(const Region& r)
{
    return {r.lower, r.upper};
}

std::span<const std::uint32_t> listOf(const RegionTree& tree, const Region& r)
{
    return std::span(tree.brickLists).subspan(r.firstBrick, r.brickCount);
}

/// Points inside the regions (a few random ones each) or, every fourth, anywhere in the bounds and a little around
/// them.
class Points
{
public:
    Points(const RegionTree& tree, std::uint64_t seed) : tree_(tree), random_(seed) {}

    vec3d next()
    {
        Box3d box{vec3d(tree_.bounds.lower) - 2.0, vec3d(tree_.bounds.upper) + 2.0};
        if (++count_ % 4 != 0) {
            const Region& r = tree_.regions[std::size_t(random_.below(int(tree_.regions.size())))];
            box = {vec3d(r.lower), vec3d(r.upper)};
        }
        return box.lower + (box.upper - box.lower) * vec3d(random_.real(), random_.real(), random_.real());
    }

private:
    const RegionTree& tree_;
    oracles::Random random_;
    int count_ = 0;
};

Model modelOf(const std::vector<Brick>& bricks)
{
    Model model;
    model.bricks = bricks;
    return model;
}

class RegionsOf : public testing::TestWithParam<NamedLayout>
{
protected:
    const std::vector<Brick>& bricks = GetParam().bricks;
    Executor serial{1};
    Progress silent;
    RegionTree tree = buildRegions(bricks, serial, silent);
    Field field = oracles::randomField(bricks, 9);
    PaddedField padded = padField(field, bricks, tree, serial, silent);
    oracles::ReferenceReconstruction basis{modelOf(bricks), field};
};

TEST_P(RegionsOf, ALayoutThatIsAModel)
{
    EXPECT_NO_THROW(checkBricks(bricks, "layout"));
}

TEST_P(RegionsOf, PadAFieldThatGoesAsOneThatStays)
{
    Field goes = field;
    const PaddedField consumed = padField(std::move(goes), bricks, tree, Executor(3), silent);
    EXPECT_EQ(consumed.values, padded.values);
    EXPECT_EQ(consumed.regionRanges, padded.regionRanges);
    EXPECT_EQ(consumed.range, padded.range);
}

TEST_P(RegionsOf, TileTheUnionOfSupports)
{
    Points points(tree, 11);
    for (int i = 0; i < 3000; ++i) {
        const vec3d p = points.next();
        const bool reached =
            std::any_of(bricks.begin(), bricks.end(), [&](const Brick& b) { return supportBox(b).contains(p); });
        const std::int64_t found = findRegion(tree, p);
        ASSERT_EQ(found >= 0, reached) << p.x << " " << p.y << " " << p.z;
        if (found >= 0) {
            const Region& r = tree.regions[std::size_t(found)];
            ASSERT_TRUE((Box3d{vec3d(r.lower), vec3d(r.upper)}.contains(p)));
        }
    }
}

TEST_P(RegionsOf, DoNotOverlapAndFillTheBoundsWithTheEmptyLeaves)
{
    for (std::size_t i = 0; i < std::min<std::size_t>(tree.regions.size(), 1500); ++i)
        for (std::size_t j = 0; j < i; ++j)
            ASSERT_FALSE(boxOf(tree.regions[i]).overlaps(boxOf(tree.regions[j]))) << i << " and " << j;

    // Walk the tree: leaf boxes are what the regions say, and volumes add up (in long double, which has 64 bits here).
    long double filled = 0.0L;
    std::size_t leaves = 0;
    int deepest = 0;
    const auto walk = [&](const auto& self, std::uint32_t node, Box3i box, int depth) -> void {
        const KdNode n = tree.nodes[node];
        ASSERT_FALSE(box.empty());
        deepest = std::max(deepest, depth);
        if (n.axis == 3) {
            const vec3d e(box.extent());
            filled += static_cast<long double>(e.x) * e.y * e.z;
            if (n.child != KdNode::emptyLeaf) {
                ++leaves;
                ASSERT_EQ(boxOf(tree.regions.at(n.child)), box);
            }
            return;
        }
        ASSERT_GT(n.child, node);
        Box3i lower = box, upper = box;
        lower.upper[n.axis] = upper.lower[n.axis] = n.plane;
        self(self, n.child, lower, depth + 1);
        self(self, n.child + 1, upper, depth + 1);
    };
    walk(walk, 0, tree.bounds, 0);
    const vec3d e(tree.bounds.extent());
    const long double whole = static_cast<long double>(e.x) * e.y * e.z;
    EXPECT_NEAR(double(filled / whole), 1.0, 1e-12);
    EXPECT_EQ(leaves, tree.regions.size());
    EXPECT_EQ(deepest, tree.depth);
}

TEST_P(RegionsOf, ListExactlyTheBricksThatContributeEverywhere)
{
    for (const Region& r : tree.regions) {
        const auto list = listOf(tree, r);
        ASSERT_GE(list.size(), 1u);
        ASSERT_TRUE(std::is_sorted(list.begin(), list.end()));
        const Box3d box{vec3d(r.lower), vec3d(r.upper)};
        std::vector<std::uint32_t> reaching;
        for (std::uint32_t b = 0; b < bricks.size(); ++b)
            if (supportBox(bricks[b]).overlaps(box))
                reaching.push_back(b);
        if (list.size() > 1) {
            ASSERT_TRUE(std::equal(list.begin(), list.end(), reaching.begin(), reaching.end()));
        } else {
            for (const std::uint32_t b : reaching)
                ASSERT_EQ(bricks[b].level, bricks[list[0]].level);
        }
        int finest = maxLevel, coarsest = 0;
        for (const std::uint32_t b : list) {
            ASSERT_TRUE(supportBox(bricks[b]).contains(box));
            finest = std::min(finest, bricks[b].level);
            coarsest = std::max(coarsest, bricks[b].level);
        }
        ASSERT_EQ(r.finestLevel, finest);
        ASSERT_EQ(r.coarsestLevel, coarsest);
    }
}

TEST_P(RegionsOf, OneBrickReproduceTheFieldFromPaddedValues)
{
    Points points(tree, 12);
    const int count = field.values.size() > 4000 ? 2000 : 10000;
    for (int i = 0; i < count; ++i) {
        const vec3d p = points.next();
        const std::int64_t found = findRegion(tree, p);
        if (found < 0 || tree.regions[std::size_t(found)].brickCount > 1)
            continue;
        const std::uint32_t b = listOf(tree, tree.regions[std::size_t(found)])[0];
        const auto expected = basis.atVoxel(0.5 * p);
        if (expected.valid) { // a support's outermost face, where D is 0, belongs to the half-open region
            ASSERT_NEAR(trilinear(p, tree.bricks[b], padded.values), expected.value, 1e-5);
        }
    }
}

TEST_P(RegionsOf, HaveRangesThatBoundTheFieldAndAreTakenByCells)
{
    Points points(tree, 13);
    for (int i = 0; i < 1000; ++i) {
        const vec3d p = points.next();
        const std::int64_t found = findRegion(tree, p);
        if (found < 0)
            continue;
        const Range range = padded.regionRanges[std::size_t(found)];
        if (const auto expected = basis.atVoxel(0.5 * p); expected.valid) {
            ASSERT_GE(expected.value, range.lo - 1e-6);
            ASSERT_LE(expected.value, range.hi + 1e-6);
        }
    }
}

TEST_P(RegionsOf, HaveTheRangesOfExactlyTheCellsThatReachThem)
{
    for (std::size_t r = 0; r < tree.regions.size(); r += 1 + tree.regions.size() / 300) {
        const Box3d box{vec3d(tree.regions[r].lower), vec3d(tree.regions[r].upper)};
        Range expected;
        for (const Brick& b : bricks) {
            std::size_t slot = b.begin;
            for (const Cell& c : oracles::cellsOfBricks(std::span(&b, 1))) {
                const double w = 2.0 * b.cellWidth();
                const vec3d centre = 2.0 * vec3d(c.lower) + 0.5 * w;
                if (Box3d{centre - w, centre + w}.overlaps(box))
                    expected.extend(field.values[slot]);
                ++slot;
            }
        }
        ASSERT_EQ(padded.regionRanges[r], expected) << "region " << r;
    }
}

TEST_P(RegionsOf, OneBrickHaveSlopesThatBoundTheFieldAndTheLogarithmsOfItsCells)
{
    Field decades = field;
    for (float& v : decades.values)
        v = std::exp(3.0f * v);
    const PaddedField values = padField(decades, bricks, tree, serial, silent);
    Points points(tree, 14);
    for (int i = 0; i < 2000; ++i) {
        const vec3d p = points.next();
        const std::int64_t found = findRegion(tree, p);
        if (found < 0 || tree.regions[std::size_t(found)].brickCount > 1)
            continue;
        const Region& r = tree.regions[std::size_t(found)];
        const PaddedBrick& brick = tree.bricks[listOf(tree, r)[0]];
        const auto at = [&](const vec3d& x) { return trilinear(x, brick, values.values); };
        const vec3d q = glm::clamp(p + vec3d(0.02, -0.01, 0.015) * double(i % 7 - 3), vec3d(r.lower), vec3d(r.upper));
        ASSERT_LE(std::abs(at(q) - at(p)),
                  values.regionSlopes[std::size_t(found)] * 0.5 * glm::length(q - p) * 1.0001 + 1e-9);
        // Two of the cells around the point.
        const double w = 2.0 * brick.cellWidth();
        const vec3d lower = 2.0 * vec3d(brick.lower) + 0.5 * w;
        const vec3d cell = lower + glm::clamp(glm::floor((p - lower) / w), -1.0, 1e9) * w;
        vec3d next = cell;
        next[i % 3] += w;
        ASSERT_LE(std::abs(std::log(at(next) / at(cell))),
                  values.regionLogSlopes[std::size_t(found)] * 0.5 * w * 1.0001 + 1e-9);
    }
}

TEST_P(RegionsOf, AreTheSameOnOneCoreAndOnMany)
{
    const Executor many(4);
    const RegionTree other = buildRegions(bricks, many, silent);
    const auto same = [](const auto& a, const auto& b) {
        return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(a[0])) == 0;
    };
    EXPECT_TRUE(same(tree.nodes, other.nodes));
    EXPECT_TRUE(same(tree.regions, other.regions));
    EXPECT_TRUE(same(tree.brickLists, other.brickLists));
    EXPECT_EQ(tree.depth, other.depth);
    const PaddedField otherField = padField(field, bricks, other, many, silent);
    EXPECT_TRUE(same(padded.values, otherField.values));
    EXPECT_TRUE(same(padded.regionRanges, otherField.regionRanges));
}

TEST_P(RegionsOf, LeaveNoPaddedValueUnset)
{
    EXPECT_EQ(padded.values.size(), tree.paddedCellCount);
    EXPECT_TRUE(
        std::all_of(padded.values.begin(), padded.values.end(), [&](float v) { return field.range.contains(v); }));
    EXPECT_EQ(padded.range, field.range);
}

INSTANTIATE_TEST_SUITE_P(Layouts, RegionsOf, testing::ValuesIn(layouts()), [](const auto& info) {
    std::string name = info.param.name;
    std::replace_if(
        name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)); }, '_');
    return name;
});

TEST(Regions, AreAsManyAsBricksWhereOneLevelFillsABox)
{
    const auto bricks = oracles::uniformBlocks({8, 8, 8}, 16);
    Progress silent;
    const RegionTree tree = buildRegions(bricks, Executor(1), silent);
    EXPECT_EQ(tree.regions.size(), 512u);
    EXPECT_TRUE(
        std::all_of(tree.regions.begin(), tree.regions.end(), [](const Region& r) { return r.brickCount == 1; }));
}

TEST(Regions, OfNoBricksAreNone)
{
    Progress silent;
    const RegionTree tree = buildRegions({}, Executor(1), silent);
    EXPECT_TRUE(tree.regions.empty());
    EXPECT_EQ(findRegion(tree, vec3d(0.0)), -1);
}

TEST(Regions, LargeEnoughForManyCoresAreTheSameOnOne)
{
    const auto bricks = oracles::randomLayout({.seed = 8, .rootBlocks = {4, 4, 4}, .blockWidth = 2, .cut = 0.0});
    ASSERT_GT(bricks.size(), 512u);
    Progress silent;
    const RegionTree a = buildRegions(bricks, Executor(1), silent), b = buildRegions(bricks, Executor(4), silent);
    ASSERT_EQ(a.nodes.size(), b.nodes.size());
    EXPECT_EQ(std::memcmp(a.nodes.data(), b.nodes.data(), a.nodes.size() * sizeof(KdNode)), 0);
    EXPECT_EQ(a.brickLists, b.brickLists);
}

TEST(Regions, OfBricksInALineStayShallow)
{
    std::vector<Brick> line; // each twice as far away: the cost alone would peel off one after the other
    for (int i = 0; i < 24; ++i)
        for (int j = 0; j < 64; ++j)
            line.push_back({{(2 << i) + 3 * j * (1 << i) / 192, 4 * j, 4 * i}, {1, 1, 1}, 0, 0});
    oracles::numberCells(line);
    Progress silent;
    EXPECT_LT(buildRegions(line, Executor(1), silent).depth, 64);
}

TEST(Regions, CanBeCancelled)
{
    const auto bricks = oracles::uniformBlocks({4, 4, 4}, 2);
    Progress progress;
    const RegionTree tree = buildRegions(bricks, Executor(1), progress);
    const Field field = oracles::randomField(bricks, 1);
    progress.cancel();
    EXPECT_THROW(buildRegions(bricks, Executor(2), progress), Cancelled);
    EXPECT_THROW(padField(field, bricks, tree, Executor(2), progress), Cancelled);
}

} // namespace
} // namespace brickwall
