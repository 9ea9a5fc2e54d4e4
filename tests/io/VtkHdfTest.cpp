// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/io/LevelCells.h"
#include "brickwall/tests/oracles/WriteHdf5.h"
#include "brickwall/tests/oracles/WriteVtkHdf.h"

#include <cmath>

namespace brickwall {
namespace {

using namespace oracles;

/// Three levels of ratios 2 and 4, with a scalar and a vector.
VtkAmr3 threeLevels()
{
    VtkAmr3 amr;
    amr.arrays = {{"density", "Float64", 1}, {"velocity", "Float32", 3}};
    amr.ratios = {2, 4};
    amr.boxes = {{{{0, 0, 0}, {8, 8, 4}}, {{0, 0, 4}, {8, 8, 8}}},
                 {{{2, 2, 2}, {12, 8, 8}}, {{2, 8, 2}, {6, 10, 6}}},
                 {{{8, 12, 8}, {16, 24, 16}}}};
    amr.origin = {1, 2, 3};
    amr.spacing = {0.5, 0.25, 1};
    amr.value = numbered;
    return amr;
}

/// Component 3 of the vector, which is from 1 to 3, is its magnitude.
CellValues expected(const VtkAmr3& amr, int component)
{
    return leafCells(amr.boxes, amr.ratios, [&](int level, const vec3i& c) {
        const auto v = [&](int k) { return amr.value(level, k, c); };
        return component < 4 ? v(component) : std::hypot(v(1), v(2), v(3));
    });
}

class VtkHdf : public testing::Test
{
protected:
    void SetUp() override { path_ = testFolder() + "/amr.vtkhdf"; }

    template <class Edit>
    std::string errorAfter(const Edit& edit, const std::vector<VtkAmr3>& steps = {threeLevels()})
    {
        writeVtkHdf(path_, steps);
        {
            Hdf5Writer file(path_, Hdf5Writer::Mode::edit);
            edit(file);
        }
        return loadError(path_);
    }
    std::string errorWithBoxes(const std::vector<double>& boxes)
    {
        return errorAfter([&](Hdf5Writer& file) {
            file.remove("VTKHDF/Level1/AMRBox");
            file.numbers("VTKHDF/Level1/AMRBox", {boxes.size() / 6, 6}, boxes, Hdf5Number::int32);
        });
    }

    std::string path_;
};

TEST_F(VtkHdf, EveryUncoveredCellHasItsValue)
{
    const VtkAmr3 amr = threeLevels();
    writeVtkHdf(path_, {amr});
    const auto set = openDataSet(path_);
    EXPECT_EQ(set->format(), "VTKHDF overlapping AMR");
    EXPECT_EQ(set->fieldNames(),
              (std::vector<std::string>{"density", "velocity_x", "velocity_y", "velocity_z", "velocity_magnitude"}));
    const Model model = loadData(path_);
    for (int field = 0; field < 5; ++field)
        EXPECT_EQ(cellValues(model, static_cast<std::size_t>(field)), expected(amr, field)) << field;
    EXPECT_EQ(cellsPerLevel(model.bricks).size(), 4u);
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_TRUE(says(model.notes[0], {"finer levels cover"}));
    EXPECT_EQ(worldBounds(model).lower, vec3d(1, 2, 3));
    EXPECT_EQ(worldBounds(model).upper, vec3d(5, 4, 11));
}

TEST_F(VtkHdf, StepsAreChosenByNumber)
{
    std::vector<VtkAmr3> steps(3, threeLevels());
    steps[1].boxes[1] = {{{4, 0, 0}, {8, 4, 4}}};
    steps[1].boxes[2] = {};
    steps[2].boxes[1].pop_back();
    for (int i = 0; i < 3; ++i)
        steps[static_cast<std::size_t>(i)].value = [i](int level, int component, const vec3i& c) {
            return numbered(level, component, c) + 0.25 * i;
        };
    for (const double version : {2.2, 2.3}) {
        writeVtkHdf(path_, steps, version);
        EXPECT_EQ(cellValues(loadData(path_, {"density"})), expected(steps[0], 0));
        for (const int step : {0, 1, 2}) {
            const Model model = loadData(path_ + ":step=" + std::to_string(step), {"density", "velocity_z"});
            EXPECT_EQ(cellValues(model, 0), expected(steps[static_cast<std::size_t>(step)], 0)) << step;
            EXPECT_EQ(cellValues(model, 1), expected(steps[static_cast<std::size_t>(step)], 3)) << step;
            EXPECT_EQ(model.name, "amr");
            EXPECT_TRUE(says(model.notes.back(), {"step " + std::to_string(step) + " of 0 to 2", "step=N"}));
        }
    }
    EXPECT_TRUE(says(errorOf([&] { openDataSet(path_ + ":step=3"); }), {"from 0 to 2", "'step=3'"}));
    EXPECT_TRUE(says(errorOf([&] { openDataSet(path_ + ":time=1"); }), {"step=N", "'time=1'"}));
}

TEST_F(VtkHdf, TextsMayBeOfVariableLength)
{
    writeVtkHdf(path_, {threeLevels()});
    {
        Hdf5Writer file(path_, Hdf5Writer::Mode::edit);
        file.removeAttribute("VTKHDF", "Type");
        file.variableText("VTKHDF", "Type", "OverlappingAMR");
    }
    EXPECT_EQ(openDataSet(path_)->format(), "VTKHDF overlapping AMR");
}

TEST_F(VtkHdf, OtherTypesAreRefused)
{
    EXPECT_TRUE(says(errorAfter([](Hdf5Writer& file) {
                         file.removeAttribute("VTKHDF", "Type");
                         file.textAttribute("VTKHDF", "Type", "UnstructuredGrid");
                     }),
                     {"'Type' of /VTKHDF", "OverlappingAMR", "UnstructuredGrid"}));
}

TEST_F(VtkHdf, ValuesOfPointsAreRefused)
{
    EXPECT_TRUE(says(errorAfter([](Hdf5Writer& file) {
                         file.remove("VTKHDF/Level0/CellData");
                         file.group("VTKHDF/Level0/PointData");
                         file.numbers("VTKHDF/Level0/PointData/data", {729}, std::vector<double>(729));
                     }),
                     {"/VTKHDF/Level0/CellData", "points alone"}));
}

TEST_F(VtkHdf, GhostTypesAreNoField)
{
    writeVtkHdf(path_, {threeLevels()});
    Hdf5Writer(path_, Hdf5Writer::Mode::edit)
        .numbers("VTKHDF/Level0/CellData/vtkGhostType", {512}, std::vector<double>(512), Hdf5Number::int32);
    EXPECT_EQ(openDataSet(path_)->fieldNames().size(), 5u);
}

TEST_F(VtkHdf, LevelsHaveNoGaps)
{
    EXPECT_TRUE(says(errorAfter([](Hdf5Writer& file) { file.remove("VTKHDF/Level1"); }),
                     {"Level0, Level1 and so on", "no VTKHDF/Level1"}));
}

TEST_F(VtkHdf, SpacingsHaveToFit)
{
    const auto spacing = [](const std::vector<double>& numbers) {
        return [numbers](Hdf5Writer& file) {
            file.removeAttribute("VTKHDF/Level1", "Spacing");
            file.attribute("VTKHDF/Level1", "Spacing", numbers);
        };
    };
    EXPECT_TRUE(says(errorAfter(spacing({0.25, 0.25, 0.5})), {"'Spacing' of /VTKHDF/Level1", "all axes", "2, 1"}));
    EXPECT_TRUE(says(errorAfter(spacing({0.25, 0.0, 0.5})), {"'Spacing' of /VTKHDF/Level1", "positive"}));
    EXPECT_TRUE(says(errorAfter(spacing({0.25, 0.125})), {"three numbers", "0.25, 0.125"}));
}

TEST_F(VtkHdf, BoxesAreChecked)
{
    EXPECT_TRUE(says(errorWithBoxes({2, 11, 2, 1, 2, 7}), {"/VTKHDF/Level1/AMRBox", "box 0", "2 to 1 along y"}));
    EXPECT_TRUE(says(errorWithBoxes({2, 11, 2, 7, 0, -1}), {"/VTKHDF/Level1/AMRBox", "three dimensions"}));
    EXPECT_TRUE(says(errorWithBoxes({2, 2000000000, 2, 7, 2, 7}), {"/VTKHDF/Level1/AMRBox", "along x"}));
    EXPECT_TRUE(says(errorWithBoxes({2, 11, 2, 9, 2, 7, 2, 5, 8, 9, 2, 5}), {"boxes 0 and 1", "overlap"}));
    EXPECT_TRUE(says(errorAfter([](Hdf5Writer& file) {
                         file.remove("VTKHDF/Level1/AMRBox");
                         file.numbers("VTKHDF/Level1/AMRBox", {2, 4}, std::vector<double>(8));
                     }),
                     {"/VTKHDF/Level1/AMRBox", "(2, 4)"}));
}

TEST_F(VtkHdf, ArraysHaveToFitTheBoxes)
{
    EXPECT_TRUE(says(errorAfter([](Hdf5Writer& file) {
                         file.remove("VTKHDF/Level2/CellData/density");
                         file.numbers("VTKHDF/Level2/CellData/density", {767}, std::vector<double>(767));
                     }),
                     {"/VTKHDF/Level2/CellData/density", "truncated", "box 0", "767"}));
    EXPECT_TRUE(says(errorAfter([](Hdf5Writer& file) { file.remove("VTKHDF/Level2/CellData/velocity"); }),
                     {"/VTKHDF/Level2/CellData/velocity", "found none"}));
    EXPECT_TRUE(says(errorAfter([](Hdf5Writer& file) {
                         file.remove("VTKHDF/Level2/CellData/velocity");
                         file.numbers("VTKHDF/Level2/CellData/velocity", {768, 2}, std::vector<double>(1536));
                     }),
                     {"/VTKHDF/Level2/CellData/velocity", "3 components", "(768, 2)"}));
}

TEST_F(VtkHdf, StepsAreChecked)
{
    const std::vector<VtkAmr3> steps(2, threeLevels());
    const auto replace = [&](const std::string& name, const std::vector<double>& values) {
        return errorAfter(
            [&](Hdf5Writer& file) {
                file.remove("VTKHDF/Steps/" + name);
                file.numbers("VTKHDF/Steps/" + name, {values.size()}, values, Hdf5Number::int64);
            },
            steps);
    };
    EXPECT_TRUE(says(replace("Level1/AMRBoxOffsets", {3, 2}), {"/VTKHDF/Level1/AMRBox", "truncated", "(4, 6)"}));
    EXPECT_TRUE(says(replace("Level1/AMRBoxOffsets", {-1, 2}), {"AMRBoxOffsets", "-1"}));
    EXPECT_TRUE(says(replace("Level1/NumberOfAMRBoxes", {1e15, 2}), {"/VTKHDF/Level1/AMRBox", "truncated"}));
    EXPECT_TRUE(says(replace("Level2/CellDataOffsets/density", {1e18, 768}), {"Level2/CellData/density", "truncated"}));
}

} // namespace
} // namespace brickwall
