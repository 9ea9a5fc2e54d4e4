// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/Pyramid.h"

#include "Layouts.h"

#include "brickwall/core/model/CheckModel.h"
#include "brickwall/tests/oracles/Fields.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <string>
#include <tuple>
#include <vector>

namespace brickwall {
namespace {

const Executor serial(1);

Model coarsened(const Model& model, int level, const Executor& executor = serial)
{
    Progress silent;
    return coarsen(model, level, executor, silent);
}

std::vector<PyramidMember> pyramidOf(const Model& model, const PyramidConfig& config = {})
{
    Progress silent;
    return buildPyramid(model, config, serial, silent);
}

/// Value times volume, over all cells.
double integralOf(const Model& model, const Field& field)
{
    double sum = 0.0;
    for (const Brick& b : model.bricks)
        for (std::uint64_t i = 0; i < b.cellCount(); ++i)
            sum += double(field.values[b.begin + i]) * std::pow(double(b.cellWidth()), 3.0);
    return sum;
}

double volumeOf(const Model& model)
{
    double sum = 0.0;
    for (const Brick& b : model.bricks)
        sum += double(b.cellCount()) * std::pow(double(b.cellWidth()), 3.0);
    return sum;
}

/// The cells' lower corners, levels and values, sorted.
std::vector<std::tuple<int, int, int, int, float>> sortedCells(const Model& model)
{
    std::vector<std::tuple<int, int, int, int, float>> cells;
    const std::vector<Cell> all = oracles::cellsOfBricks(model.bricks);
    for (std::size_t i = 0; i < all.size(); ++i)
        cells.emplace_back(all[i].level, all[i].lower.z, all[i].lower.y, all[i].lower.x,
                           model.fields.front().values[i]);
    std::sort(cells.begin(), cells.end());
    return cells;
}

/// Cell by cell, with a search for the seven others.
std::vector<std::tuple<int, int, int, int, float>> plainlyCoarsened(const Model& model, int level)
{
    const auto cells = sortedCells(model);
    std::vector<std::tuple<int, int, int, int, float>> result;
    for (const auto& cell : cells) {
        const auto [l, z, y, x, value] = cell;
        const int w = 1 << level;
        const vec3i parent = (vec3i(x, y, z) >> (level + 1)) << (level + 1);
        double sum = 0.0;
        int found = 0;
        for (int i = 0; l == level && i < 8; ++i) {
            const vec3i p = parent + w * vec3i(i & 1, i >> 1 & 1, i >> 2);
            const auto key = std::tuple(level, p.z, p.y, p.x, -INFINITY);
            const auto at = std::lower_bound(cells.begin(), cells.end(), key);
            if (at != cells.end() && std::tuple(std::get<0>(*at), std::get<1>(*at), std::get<2>(*at),
                                                std::get<3>(*at)) == std::tuple(level, p.z, p.y, p.x)) {
                sum += double(std::get<4>(*at));
                ++found;
            }
        }
        if (found < 8)
            result.push_back(cell);
        else if (vec3i(x, y, z) == parent)
            result.emplace_back(level + 1, z, y, x, static_cast<float>(0.125 * sum));
    }
    std::sort(result.begin(), result.end());
    return result;
}

class OfLayout : public testing::TestWithParam<NamedLayout>
{
protected:
    Model model() const
    {
        Model m;
        m.name = GetParam().name;
        m.bricks = GetParam().bricks;
        m.fields = {oracles::randomField(m.bricks, 1), oracles::randomField(m.bricks, 2)};
        m.fields[1].name = "other";
        m.cellCount = m.fields[0].values.size();
        return m;
    }
};

TEST_P(OfLayout, EightCellsThatFillOneOfTheNextLevelBecomeTheirMeanAndNothingElseChanges)
{
    const Model fine = model();
    for (int level = 0; level < 4; ++level)
        EXPECT_EQ(sortedCells(coarsened(fine, level)), plainlyCoarsened(fine, level)) << level;
}

TEST_P(OfLayout, CoarserModelsAreValidAndKeepVolumeAndSumsOfAllFields)
{
    Model coarser = model();
    const Model fine = coarser;
    for (int level = 0; level < 6; ++level) {
        coarser = coarsened(coarser, level);
        checkModel(coarser, "coarser");
        EXPECT_DOUBLE_EQ(volumeOf(coarser), volumeOf(fine));
        EXPECT_LE(coarser.cellCount, fine.cellCount);
        for (std::size_t f = 0; f < 2; ++f) {
            EXPECT_EQ(coarser.fields[f].name, fine.fields[f].name);
            EXPECT_NEAR(integralOf(coarser, coarser.fields[f]), integralOf(fine, fine.fields[f]),
                        1e-6 * volumeOf(fine));
            EXPECT_GE(coarser.fields[f].range.lo, fine.fields[f].range.lo);
            EXPECT_LE(coarser.fields[f].range.hi, fine.fields[f].range.hi);
        }
    }
}

TEST_P(OfLayout, IsTheSameWhateverTheExecutor)
{
    const Model a = coarsened(model(), 0), b = coarsened(model(), 0, Executor(4));
    ASSERT_EQ(a.bricks.size(), b.bricks.size());
    for (std::size_t i = 0; i < a.bricks.size(); ++i)
        EXPECT_EQ(a.bricks[i].box(), b.bricks[i].box());
    EXPECT_EQ(a.fields[1].values, b.fields[1].values);
}

INSTANTIATE_TEST_SUITE_P(Pyramid, OfLayout, testing::ValuesIn(layouts()),
                         [](const auto& info) { return "Layout" + std::to_string(info.index); });

TEST(Pyramid, MembersOfAConstantFieldAreThatConstant)
{
    const Model model = oracles::modelOf(oracles::nestedLevels(3, 8, 4), [](const vec3d&) { return 0.7; });
    const auto members = pyramidOf(model, {.mostCells = 1.0, .leastCells = 8});
    ASSERT_GE(members.size(), 3u);
    for (const PyramidMember& member : members)
        EXPECT_EQ(member.fields.front()->range, (Range{0.7f, 0.7f}));
}

TEST(Pyramid, AnAffineFieldStaysItselfAtTheCentresOfAveragedCells)
{
    const oracles::AffineField affine{0.25, {0.01, -0.02, 0.03}};
    Model model = oracles::modelOf(oracles::nestedLevels(3, 8, 4), affine);
    for (int level = 0; level < 4; ++level) {
        model = coarsened(model, level);
        const Model exact = oracles::modelOf(model.bricks, affine);
        for (std::size_t i = 0; i < model.fields.front().values.size(); ++i)
            ASSERT_NEAR(model.fields.front().values[i], exact.fields.front().values[i], 1e-6) << level;
    }
}

TEST(Pyramid, AllMembersOfOneLevelTakeASeventhOfItsCellsAndPaddingOnTop)
{
    const Model model = oracles::modelOf(oracles::oneLevelBricks(vec3i(0), vec3i(64), vec3i(32), 0),
                                         [](const vec3d& p) { return std::sin(p.x); });
    const auto members = pyramidOf(model, {.leastCells = 64});
    std::uint64_t cells = 0, padded = 0;
    for (const PyramidMember& member : members) {
        cells += member.cells;
        padded += member.regions->paddedCellCount;
    }
    EXPECT_EQ(cells, std::uint64_t(32 * 32 * 32 + 16 * 16 * 16 + 8 * 8 * 8 + 4 * 4 * 4));
    EXPECT_LE(7 * cells, model.cellCount);
    EXPECT_LE(5 * padded, model.cellCount); // 34^3 instead of 32^3, and so on
}

TEST(Pyramid, MembersShrinkAsTheConfigSaysSoThatAllTogetherAreNoMoreThanTheData)
{
    for (const NamedLayout& layout : layouts()) {
        Model model;
        model.bricks = layout.bricks;
        model.fields = {oracles::randomField(model.bricks, 1)};
        model.cellCount = model.fields[0].values.size();
        std::uint64_t before = model.cellCount, all = 0;
        int level = -1;
        for (const PyramidMember& member : pyramidOf(model, {.leastCells = 1})) {
            EXPECT_LE(2 * member.cells, before) << layout.name;
            EXPECT_GT(member.level, level) << layout.name;
            level = member.level;
            before = member.cells;
            all += member.cells;
        }
        EXPECT_LE(all, model.cellCount) << layout.name;
    }
}

TEST(Pyramid, DataWithoutCellsOrOfFewCellsHaveNone)
{
    EXPECT_TRUE(pyramidOf(Model{}).empty());
    EXPECT_TRUE(
        pyramidOf(oracles::modelOf(oracles::uniformBlocks({2, 2, 2}, 8), [](const vec3d&) { return 1.0; })).empty());
}

} // namespace
} // namespace brickwall
