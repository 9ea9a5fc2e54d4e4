// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/model/Model.h"

#include "Layouts.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/model/CheckModel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace brickwall {
namespace {

Model smallModel()
{
    Model model;
    model.name = "small";
    model.bricks = oracles::nestedLevels(2, 4, 2);
    model.fields = {oracles::randomField(model.bricks, 1), oracles::randomField(model.bricks, 2)};
    model.fields[1].name = "other";
    model.cellCount = model.fields[0].values.size();
    return model;
}

/// What checkModel says after `spoil`.
std::string fault(const std::function<void(Model&)>& spoil)
{
    Model model = smallModel();
    spoil(model);
    try {
        checkModel(model, "small.file");
    } catch (const Error& e) {
        return e.what();
    }
    return "no fault";
}

void expectFault(const std::string& words, const std::function<void(Model&)>& spoil)
{
    const std::string message = fault(spoil);
    EXPECT_NE(message.find(words), std::string::npos) << message;
    EXPECT_EQ(message.find("small.file: "), 0u) << message;
}

TEST(CheckModel, AcceptsWhatKeepsTheInvariants)
{
    EXPECT_EQ(fault([](Model&) {}), "no fault");
}

TEST(CheckModel, NamesBothBricksOfAnOverlap)
{
    expectFault("brick 3 (", [](Model& m) { m.bricks[5].lower = m.bricks[3].lower; });
    expectFault("brick 5 (", [](Model& m) { m.bricks[5].lower = m.bricks[3].lower; });
    expectFault("overlap at voxel 4 0 0", [](Model& m) { m.bricks.back().lower = {4, 0, 0}; });
}

TEST(CheckModel, RefusesBricksThatAreNone)
{
    expectFault("brick 2 (", [](Model& m) { m.bricks[2].size.y = 0; });
    expectFault("at least one cell along y, found -3", [](Model& m) { m.bricks[2].size.y = -3; });
    expectFault("multiple of the cell width 2, found 1 along x", [](Model& m) { m.bricks[0].lower.x = 1; });
    expectFault("level from 0 to 24", [](Model& m) { m.bricks[0].level = 25; });
    expectFault("level from 0 to 24", [](Model& m) { m.bricks[0].level = -1; });
    expectFault("expected coordinates from", [](Model& m) { m.bricks[0].lower.z = coordinateLimit; });
    expectFault("expected coordinates from", [](Model& m) { m.bricks[0].size.z = 2147483647; });
    expectFault("begin at 8, found 9", [](Model& m) { m.bricks[1].begin = 9; });
}

TEST(CheckModel, RefusesValuesThatAreMissingOrNotFinite)
{
    expectFault("in field 'other', found nan in cell 1 0 1 of brick 2 (",
                [](Model& m) { m.fields[1].values[21] = std::nanf(""); });
    expectFault("found inf", [](Model& m) { m.fields[0].values.back() = INFINITY; });
    expectFault("values in field 'random', one per cell", [](Model& m) { m.fields[0].values.pop_back(); });
    expectFault("expected a cell count of", [](Model& m) { ++m.cellCount; });
}

TEST(CheckModel, RefusesTransformsThatCannotBeInverted)
{
    expectFault("invertible", [](Model& m) { m.worldFromVoxel[1][1] = 0.0; });
    expectFault("affine", [](Model& m) { m.worldFromVoxel[0][3] = 1.0; });
    expectFault("finite", [](Model& m) { m.worldFromVoxel[2][0] = NAN; });
}

TEST(CheckModel, TakesTinyCellsForInvertible)
{
    EXPECT_EQ(fault([](Model& m) {
                  m.worldFromVoxel = mat4d(1e-9);
                  m.worldFromVoxel[3][3] = 1.0;
              }),
              "no fault");
}

TEST(Model, KnowsItsBounds)
{
    Model model = smallModel();
    EXPECT_EQ(voxelBounds(model.bricks), (Box3i{vec3i(0), vec3i(16)}));
    model.worldFromVoxel[0] = {0, 2, 0, 0}; // x becomes 2y, y becomes -x
    model.worldFromVoxel[1] = {-1, 0, 0, 0};
    model.worldFromVoxel[3] = {5, 0, 0, 1};
    EXPECT_EQ(worldBounds(model), (Box3d{{-11, 0, 0}, {5, 32, 16}}));
}

TEST(Model, CountsCellsPerLevel)
{
    EXPECT_EQ(cellsPerLevel(smallModel().bricks), (std::vector<std::uint64_t>{512, 448}));
    EXPECT_TRUE(cellsPerLevel({}).empty());
}

TEST(Model, FindsFieldsAndListsThemIfNot)
{
    const Model model = smallModel();
    EXPECT_EQ(fieldNamed(model, "other").name, "other");
    try {
        fieldNamed(model, "dens");
        FAIL();
    } catch (const Error& e) {
        EXPECT_STREQ(e.what(), "small: has no field 'dens'; it has random, other");
    }
}

TEST(Model, RangesArePoisonedByNan)
{
    EXPECT_EQ(rangeOf(std::vector<float>{2, -1, 3}), (Range{-1, 3}));
    EXPECT_TRUE(std::isnan(rangeOf(std::vector<float>{2, NAN, 3}).lo));
    EXPECT_TRUE(rangeOf({}).empty());
}

} // namespace
} // namespace brickwall
