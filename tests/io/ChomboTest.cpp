// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/io/LevelCells.h"
#include "brickwall/tests/oracles/WriteChombo.h"
#include "brickwall/tests/oracles/WriteHdf5.h"

#include <cmath>
#include <numeric>

namespace brickwall {
namespace {

using namespace oracles;

const std::vector<std::string> boxMembers{"lo_i", "lo_j", "lo_k", "hi_i", "hi_j", "hi_k"};

/// Three levels in two components, from ratios 4 and 2, with negative indices.
Chombo3 threeLevels()
{
    Chombo3 c;
    c.components = {"density", "x-velocity"};
    c.ratios = {4, 2};
    c.boxes = {{{{-4, 2, 0}, {4, 10, 4}}, {{-4, 2, 4}, {4, 10, 8}}},
               {{{-8, 16, 8}, {8, 28, 16}}, {{-16, 16, 16}, {4, 20, 20}}},
               {{{-16, 32, 16}, {8, 40, 24}}}};
    c.cellSize = 0.5;
    c.value = numbered;
    return c;
}

CellValues expected(const Chombo3& c, int component)
{
    return leafCells(c.boxes, c.ratios, [&](int level, const vec3i& cell) { return c.value(level, component, cell); });
}

class Chombo : public testing::Test
{
protected:
    void SetUp() override { path_ = testFolder() + "/plt000100.3d.hdf5"; }

    /// The message after a good file was edited.
    template <class Edit>
    std::string errorAfter(const Edit& edit)
    {
        writeChombo(path_, threeLevels());
        {
            Hdf5Writer file(path_, Hdf5Writer::Mode::edit);
            edit(file);
        }
        return loadError(path_);
    }
    std::string errorWithAttribute(const std::string& object, const std::string& name, double value)
    {
        return errorAfter([&](Hdf5Writer& file) {
            file.removeAttribute(object, name);
            file.attribute(object, name, {value});
        });
    }
    std::string errorWithBoxes(const std::string& level, const std::vector<std::int64_t>& boxes)
    {
        return errorAfter([&](Hdf5Writer& file) {
            file.remove(level + "/boxes");
            file.records(level + "/boxes", boxMembers, boxes);
        });
    }

    std::string path_;
};

TEST_F(Chombo, EveryUncoveredCellHasItsValue)
{
    const Chombo3 c = threeLevels();
    writeChombo(path_, c);
    const auto set = openDataSet(path_);
    EXPECT_EQ(set->format(), "Chombo");
    EXPECT_EQ(set->fieldNames(), c.components);
    const Model model = loadData(path_);
    EXPECT_EQ(cellValues(model, 0), expected(c, 0));
    EXPECT_EQ(cellValues(model, 1), expected(c, 1));
    EXPECT_EQ(cellsPerLevel(model.bricks).size(), 4u);
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_TRUE(says(model.notes[0], {"finer levels cover"}));
}

TEST_F(Chombo, GhostCellsAreIgnored)
{
    Chombo3 c = threeLevels();
    for (const vec3i ghosts : {vec3i(2), vec3i(1, 0, 3)}) {
        c.ghosts = ghosts;
        writeChombo(path_, c); // ghost cells are NaN
        EXPECT_EQ(cellValues(loadData(path_, {"x-velocity"})), expected(c, 1));
    }
}

TEST_F(Chombo, FilesMayLackWhatFollowsFromTheRest)
{
    Chombo3 c = threeLevels();
    c.outputGhost = false;
    writeChombo(path_, c); // "ghost" says 3, but the offsets say that none are there
    EXPECT_EQ(cellValues(loadData(path_, {"density"})), expected(c, 0));
    c.ghosts = {3, 3, 3};
    writeChombo(path_, c);
    EXPECT_EQ(cellValues(loadData(path_, {"density"})), expected(c, 0));
    c.offsets = false;
    writeChombo(path_, c);
    EXPECT_EQ(cellValues(loadData(path_, {"density"})), expected(c, 0));
    c.vectorRatios = true;
    c.floats = true;
    writeChombo(path_, c);
    EXPECT_EQ(cellValues(loadData(path_, {"density"})), expected(c, 0));
}

TEST_F(Chombo, ALevelMayHaveNoBoxes)
{
    Chombo3 c = threeLevels();
    c.boxes[2].clear();
    writeChombo(path_, c);
    EXPECT_EQ(cellValues(loadData(path_, {"density"})), expected(c, 0));
}

TEST_F(Chombo, CellZeroHasItsCornerAtTheOrigin)
{
    writeChombo(path_, threeLevels());
    const Model model = loadData(path_, {"density"});
    EXPECT_EQ(worldBounds(model).lower, vec3d(-2, 1, 0));
    EXPECT_EQ(worldBounds(model).upper, vec3d(2, 5, 4));
}

TEST_F(Chombo, PlutoSaysWhereTheDomainBeginsAndHowWideCellsAre)
{
    Chombo3 c = threeLevels();
    c.plutoOrigin = {-10, 20, 0.25};
    c.plutoStretch = {2, 0.5};
    writeChombo(path_, c);
    const Model model = loadData(path_, {"density"});
    EXPECT_EQ(cellValues(model), expected(c, 0));
    EXPECT_EQ(worldBounds(model).lower, vec3d(-10 - 2, 20 + 2 * 1, 0.25));
    EXPECT_EQ(worldBounds(model).upper, vec3d(-10 + 2, 20 + 2 * 5, 0.25 + 0.5 * 4));
}

TEST_F(Chombo, PlutoInOtherCoordinatesIsRefused)
{
    Chombo3 c = threeLevels();
    c.plutoOrigin = {1, 0, 0};
    c.plutoGeometry = 4;
    writeChombo(path_, c);
    EXPECT_TRUE(says(loadError(path_), {"'geometry' of /level_0", "Cartesian", "found 4"}));
    c.plutoGeometry = 1;
    c.plutoStretch = {1, -1};
    writeChombo(path_, c);
    EXPECT_TRUE(says(loadError(path_), {"'g_x3stretch' of /level_0", "positive", "-1"}));
}

TEST_F(Chombo, TheLowerCornerMayBeAnAttribute)
{
    for (const bool compound : {false, true}) {
        writeChombo(path_, threeLevels());
        {
            Hdf5Writer file(path_, Hdf5Writer::Mode::edit);
            if (compound)
                file.recordAttribute("", "prob_lo", {"x", "y", "z"}, {-10, 20, 30});
            else
                file.attribute("", "prob_lo", {-10, 20, 30});
        }
        const Model model = loadData(path_, {"density"});
        EXPECT_EQ(worldBounds(model).lower, vec3d(-12, 21, 30));
        EXPECT_EQ(worldBounds(model).upper, vec3d(-8, 25, 34));
    }
    EXPECT_TRUE(says(errorAfter([](Hdf5Writer& file) {
                         file.attribute("", "prob_lo", {1, 2});
                     }),
                     {"'prob_lo'", "three numbers", "1, 2"}));
}

TEST_F(Chombo, ThreadsDoNotMatter)
{
    writeChombo(path_, threeLevels());
    EXPECT_EQ(loadData(path_, {}, 1).fields[1].values, loadData(path_, {}, 4).fields[1].values);
}

TEST_F(Chombo, NonFiniteValuesNameFileFieldAndCell)
{
    Chombo3 c = threeLevels();
    c.value = [](int level, int component, const vec3i& cell) {
        return level == 0 && component == 1 && cell == vec3i(-4, 2, 0) ? INFINITY : 0.0;
    };
    writeChombo(path_, c);
    EXPECT_TRUE(says(loadError(path_), {"/level_0/data:datatype=0", "'x-velocity'", "inf", "cell (-4,2,0)"}));
}

TEST_F(Chombo, TwoDimensionsAreRefused)
{
    EXPECT_TRUE(says(errorWithAttribute("Chombo_global", "SpaceDim", 2), {"plt000100", "three dimensions", "found 2"}));
}

TEST_F(Chombo, CountsAreChecked)
{
    EXPECT_TRUE(says(errorWithAttribute("", "num_levels", 4), {"/level_3/boxes", "found none"}));
    EXPECT_TRUE(says(errorWithAttribute("", "num_levels", 1e12), {"'num_levels'", "1 to 64", "1000000000000"}));
    EXPECT_TRUE(says(errorWithAttribute("", "num_levels", -1), {"'num_levels'", "-1"}));
    EXPECT_TRUE(says(errorWithAttribute("level_1/data_attributes", "comps", 1), {"offsets", "expected"}));
    EXPECT_TRUE(says(errorWithAttribute("level_0/data_attributes", "comps", 0), {"'comps'", "found 0"}));
}

TEST_F(Chombo, RatiosAndCellSizesHaveToFit)
{
    EXPECT_TRUE(says(errorWithAttribute("level_0", "ref_ratio", 3), {"power of two", "3", "levels 0 and 1"}));
    EXPECT_TRUE(says(errorWithAttribute("level_0", "ref_ratio", 2), {"'dx' of /level_0", "expected 0.25"}));
    EXPECT_TRUE(says(errorWithAttribute("level_1", "dx", -1), {"'dx' of /level_1", "positive", "-1"}));
    EXPECT_TRUE(says(errorWithAttribute("level_0", "ref_ratio", 1 << 20), {"'dx' of /level_0", "expected 131072"}));
}

TEST_F(Chombo, BoxesAreChecked)
{
    EXPECT_TRUE(says(errorWithBoxes("level_2", {-16, 32, 16, -17, 39, 23}),
                     {"/level_2/boxes", "box 0", "from low to high", "(-17,39,23)"}));
    EXPECT_TRUE(says(errorWithBoxes("level_2", {-16, 32, 16, 2147483647, 39, 23}), {"/level_2/boxes", "2147483647"}));
    EXPECT_TRUE(says(errorWithBoxes("level_0", {-4, 2, 0, 3, 9, 3, -4, 2, 3, 3, 9, 7}),
                     {"/level_0/boxes", "boxes 0 and 1", "overlap"}));
    EXPECT_TRUE(says(errorWithBoxes("level_1", {-8, 16, 8, 6, 27, 15, -16, 16, 16, 3, 19, 19}), {"/level_1/boxes"}));
    EXPECT_TRUE(says(errorAfter([](Hdf5Writer& file) {
                         file.remove("level_0/boxes");
                         file.records("level_0/boxes", {"lo_i", "lo_j", "hi_i", "hi_j"}, {0, 0, 7, 7});
                     }),
                     {"/level_0/boxes", "lo_k"}));
}

TEST_F(Chombo, CellsBeyondWhatCanBeCountedAreRefused)
{
    const std::int64_t end = (1 << 24) - 1;
    EXPECT_TRUE(says(errorWithBoxes("level_0", {0, 0, 0, end, end, end}), {"plt000100", "2^32"}));
}

TEST_F(Chombo, OffsetsHaveToMeetTheBoxes)
{
    const auto offsets = [](const std::vector<double>& values) {
        return [values](Hdf5Writer& file) {
            file.remove("level_1/data:offsets=0");
            file.numbers("level_1/data:offsets=0", {values.size()}, values, Hdf5Number::int64);
        };
    };
    EXPECT_TRUE(says(errorAfter(offsets({0, 3072})), {"offsets=0", "shape of (3)", "(2)"}));
    EXPECT_TRUE(says(errorAfter(offsets({0, 3000, 3640})), {"offsets=0", "box 0", "expected 3072 values", "3000"}));
    EXPECT_TRUE(says(errorAfter(offsets({-3072, 0, 640})), {"offsets=0", "box 0", "-3072"}));
    EXPECT_TRUE(says(errorAfter(offsets({8, -0x1p63, 640})), {"offsets=0", "box 0", "-9223372036854775808"}));
    EXPECT_TRUE(says(errorAfter(offsets({500, 3572, 4212})), {"datatype=0", "truncated", "box 1", "4212"}));
}

TEST_F(Chombo, MissingValuesAreNamed)
{
    EXPECT_TRUE(says(errorAfter([](Hdf5Writer& file) { file.remove("level_2/data:datatype=0"); }),
                     {"/level_2/data:datatype=0", "found none"}));
    EXPECT_TRUE(says(errorAfter([](Hdf5Writer& file) {
                         file.remove("level_2/data:datatype=0");
                         file.unwritten("level_2/data:datatype=0", {3072});
                     }),
                     {"/level_2/data:datatype=0", "truncated", "only 0 are stored"}));
    EXPECT_TRUE(says(errorAfter([](Hdf5Writer& file) { file.remove("level_0/data:datatype=0"); }),
                     {"/level_0", "values in cells"}));
}

TEST_F(Chombo, TruncationIsNoticed)
{
    writeChombo(path_, threeLevels());
    std::filesystem::resize_file(path_, std::filesystem::file_size(path_) / 2);
    EXPECT_TRUE(says(loadError(path_), {"plt000100", "cannot be opened as HDF5", "truncated"}));
}

TEST_F(Chombo, TwoDimensionalPlotFileIsRefused)
{
    const std::string path = BRICKWALL_SOURCE_DIR "/../shared/data/chombo/plt000100.2d.hdf5";
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << "no sample data: " << path;
    EXPECT_TRUE(says(loadError(path), {"plt000100.2d.hdf5", "three dimensions", "found 2"}));
}

TEST_F(Chombo, CheckpointHasAFieldForEachComponentInCells)
{
    const std::string path = BRICKWALL_SOURCE_DIR "/../shared/data/chombo/chk000100.3d.hdf5";
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << "no sample data: " << path;
    EXPECT_EQ(openDataSet(path)->fieldNames(),
              (std::vector<std::string>{"Bulk concentration", "xDarcy velocity", "yDarcy velocity", "zDarcy velocity",
                                        "Enthalpy", "Pressure", "lambda"})); // but not advVel, which is on faces
    const Model model = loadData(path);
    EXPECT_EQ(model.cellCount, 32768u);
    EXPECT_EQ(voxelBounds(model.bricks), (Box3i{{0, 0, 0}, {32, 32, 32}}));
    EXPECT_EQ(worldBounds(model).upper, vec3d(1));
    const auto& enthalpy = model.fields[4].values;
    EXPECT_FLOAT_EQ(model.fields[4].range.lo, 0.66421169f); // this and what follows as h5py reads it
    EXPECT_FLOAT_EQ(model.fields[4].range.hi, 5.0242419f);
    EXPECT_NEAR(std::accumulate(enthalpy.begin(), enthalpy.end(), 0.0), 154124.51077663898, 1e-6);
    const std::array<int, 4> cell{7, 5, 3, 0};
    EXPECT_FLOAT_EQ(cellValues(model, 1).at(cell), -0.18873423f);
    EXPECT_FLOAT_EQ(cellValues(model, 3).at(cell), -0.11813202f);
    EXPECT_FLOAT_EQ(cellValues(model, 4).at(cell), 5.0103961f);
}

} // namespace
} // namespace brickwall
