// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/common/EditFile.h"
#include "brickwall/tests/io/LevelCells.h"
#include "brickwall/tests/oracles/WriteAmrex.h"

#include <cmath>
#include <fstream>
#include <iterator>

namespace brickwall {
namespace {

using namespace oracles;

/// Three levels in two components, from ratios 2 and 4, with odd origins and anisotropic cells.
Plotfile3 threeLevels()
{
    Plotfile3 p;
    p.components = {"temperature", "x velocity"};
    p.domain = {{-4, 2, 0}, {4, 10, 8}};
    p.ratios = {2, 4};
    p.boxes = {{{{-4, 2, 0}, {4, 10, 4}}, {{-4, 2, 4}, {4, 10, 8}}},
               {{{-4, 8, 2}, {4, 14, 8}}, {{-8, 8, 8}, {4, 16, 12}}},
               {{{-8, 36, 16}, {8, 48, 24}}}};
    p.lower = {1, 2, 3};
    p.cellSize = {0.5, 0.25, 1};
    p.value = numbered;
    return p;
}

CellValues expected(const Plotfile3& p, int component)
{
    return leafCells(p.boxes, p.ratios, [&](int level, const vec3i& cell) { return p.value(level, component, cell); });
}

class Amrex : public testing::Test
{
protected:
    void SetUp() override { folder_ = testFolder() + "/plt00010"; }

    void write(const Plotfile3& p) { writePlotfile(folder_, p); }

    /// Replaces the first `from` in a file of the plotfile.
    void edit(const std::string& file, const std::string& from, const std::string& to)
    {
        editFile(folder_ + "/" + file, from, to);
    }
    std::string errorAfter(const std::string& file, const std::string& from, const std::string& to)
    {
        write(threeLevels());
        edit(file, from, to);
        return loadError(folder_);
    }

    std::string folder_;
};

TEST_F(Amrex, EveryUncoveredCellHasItsValue)
{
    const Plotfile3 p = threeLevels();
    write(p);
    const auto set = openDataSet(folder_);
    EXPECT_EQ(set->format(), "AMReX plotfile");
    EXPECT_EQ(set->fieldNames(), p.components);
    const Model model = loadData(folder_);
    EXPECT_EQ(model.name, "plt00010");
    EXPECT_EQ(cellValues(model, 0), expected(p, 0));
    EXPECT_EQ(cellValues(model, 1), expected(p, 1));
    EXPECT_EQ(cellsPerLevel(model.bricks).size(), 4u);
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_TRUE(says(model.notes[0], {"finer levels cover"}));
}

TEST_F(Amrex, NumbersAreReadInEitherPrecisionAndByteOrder)
{
    Plotfile3 p = threeLevels();
    const CellValues cells = expected(p, 1);
    for (const bool floats : {false, true})
        for (const bool bigEndian : {false, true}) {
            p.floats = floats;
            p.bigEndian = bigEndian;
            write(p);
            EXPECT_EQ(cellValues(loadData(folder_, {"x velocity"})), cells) << floats << bigEndian;
        }
}

TEST_F(Amrex, GhostCellsAreIgnored)
{
    Plotfile3 p = threeLevels();
    p.ghosts = 2;
    write(p); // ghost cells are NaN
    EXPECT_EQ(cellValues(loadData(folder_, {"x velocity"})), expected(p, 1));
    edit("Level_0/Cell_H", "\n2\n(", "\n(2,2,2)\n(");
    EXPECT_EQ(cellValues(loadData(folder_, {"x velocity"})), expected(p, 1));
}

TEST_F(Amrex, SeveralDataFilesAreOne)
{
    Plotfile3 p = threeLevels();
    p.boxesPerFile = 1;
    write(p);
    EXPECT_TRUE(std::filesystem::exists(folder_ + "/Level_1/Cell_D_00001"));
    EXPECT_EQ(cellValues(loadData(folder_, {"temperature"})), expected(p, 0));
}

TEST_F(Amrex, OneRatioMayStandForAll)
{
    Plotfile3 p = threeLevels();
    p.ratios = {2, 2};
    p.boxes[2] = {{{-4, 20, 8}, {4, 24, 12}}};
    p.oneRatioForAll = true;
    write(p);
    EXPECT_EQ(cellValues(loadData(folder_, {"temperature"})), expected(p, 0));
    edit("Header", "\n2 \n", "\n(2,2,2) (2,2,2) \n");
    EXPECT_EQ(cellValues(loadData(folder_, {"temperature"})), expected(p, 0));
}

TEST_F(Amrex, OneLevelHasNoRatios)
{
    Plotfile3 p;
    p.value = numbered;
    p.version = "NavierStokes-V1.1";
    write(p);
    const Model model = loadData(folder_);
    EXPECT_EQ(cellValues(model), expected(p, 0));
    EXPECT_EQ(model.bricks.size(), 1u);
    EXPECT_TRUE(model.notes.empty());
}

TEST_F(Amrex, VoxelsAreTheFinestIndices)
{
    write(threeLevels());
    const Model model = loadData(folder_, {"temperature"});
    // The domain's lower corner is coarse index (-4,2,0), and a voxel is an eighth of a coarse cell.
    const vec3d corner = transformPoint(model.worldFromVoxel, vec3d(-32, 16, 0));
    const vec3d next = transformPoint(model.worldFromVoxel, vec3d(-31, 17, 1));
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_DOUBLE_EQ(corner[axis], vec3d(1, 2, 3)[axis]);
        EXPECT_DOUBLE_EQ(next[axis] - corner[axis], vec3d(0.0625, 0.03125, 0.125)[axis]);
    }
    EXPECT_EQ(worldBounds(model).lower, vec3d(1, 2, 3));
    EXPECT_EQ(worldBounds(model).upper, vec3d(5, 4, 11));
}

TEST_F(Amrex, TheHeaderItselfMayBeOpened)
{
    write(threeLevels());
    EXPECT_EQ(openDataSet(folder_ + "/Header")->format(), "AMReX plotfile");
    EXPECT_EQ(loadData(folder_ + "/", {"temperature"}).name, "plt00010");
}

TEST_F(Amrex, TheDefaultFieldIsASpeedOrDensityElseTheFirst)
{
    Plotfile3 p;
    p.components = {"vfrac", "density"};
    write(p);
    EXPECT_EQ(openDataSet(folder_)->defaultField(), "density");
    p.components = {"vfrac", "Temp"};
    write(p);
    EXPECT_EQ(openDataSet(folder_)->defaultField(), "vfrac");
}

TEST_F(Amrex, ThreadsDoNotMatter)
{
    write(threeLevels());
    const Model one = loadData(folder_, {}, 1), four = loadData(folder_, {}, 4);
    ASSERT_EQ(one.bricks.size(), four.bricks.size());
    for (std::size_t i = 0; i < one.bricks.size(); ++i)
        EXPECT_EQ(one.bricks[i].box(), four.bricks[i].box());
    EXPECT_EQ(one.fields[1].values, four.fields[1].values);
}

TEST_F(Amrex, ANestedPatchMayStickOutOfTheLevelBetween)
{
    Plotfile3 p;
    p.ratios = {2, 2};
    p.boxes = {{{{0, 0, 0}, {8, 8, 8}}}, {{{4, 4, 4}, {8, 8, 8}}}, {{{12, 12, 12}, {20, 16, 16}}}};
    p.value = numbered;
    write(p);
    std::uint64_t volumeOfCells = 0;
    for (const auto& [cell, value] : cellValues(loadData(folder_)))
        volumeOfCells += std::uint64_t(1) << 3 * cell[3];
    EXPECT_EQ(volumeOfCells, 32u * 32 * 32);
}

TEST_F(Amrex, NonFiniteValuesNameFileFieldAndCell)
{
    Plotfile3 p = threeLevels();
    p.value = [](int level, int component, const vec3i& c) {
        return level == 0 && component == 1 && c == vec3i(-4, 2, 0) ? 1e300 : 0.0; // no float
    };
    write(p);
    EXPECT_TRUE(
        says(loadError(folder_), {"Level_0/Cell_D_00000", "byte 0", "'x velocity'", "1e+300", "cell (-4,2,0)"}));
    EXPECT_NO_THROW(loadData(folder_, {"temperature"}));
    p.value = [](int level, int, const vec3i& c) { return level == 0 && c == vec3i(0, 5, 3) ? NAN : 0.0; }; // covered
    write(p);
    EXPECT_NO_THROW(loadData(folder_));
}

TEST_F(Amrex, NonFiniteValuesBecomeEmptyCellsIfAskedFor)
{
    Plotfile3 p = threeLevels();
    write(p);
    const CellValues all = cellValues(loadData(folder_, {"temperature"}));
    p.value = [](int level, int, const vec3i& c) { return level == 0 && c == vec3i(-4, 2, 0) ? INFINITY : 1.0; };
    write(p);
    const auto set = openDataSet(folder_);
    Progress silent;
    const Model model = set->load(std::vector<std::string>{"temperature"}, Executor(2), silent, NonFinite::empty);
    EXPECT_EQ(model.cellCount, all.size() - 1);
    EXPECT_EQ(model.fields[0].range.hi, 1.0f);
    EXPECT_TRUE(says(model.notes.back(), {"1 cells without a finite value left out", "1 bricks"}));
    EXPECT_EQ(cellValues(model).size(), all.size() - 1);
}

TEST_F(Amrex, UnknownFieldsAreErrors)
{
    write(threeLevels());
    EXPECT_TRUE(says(errorOf([&] { loadData(folder_, {"vorticity"}); }),
                     {"plt00010", "'vorticity'", "temperature, x velocity"}));
}

TEST_F(Amrex, TwoDimensionsAreRefused)
{
    EXPECT_TRUE(says(errorAfter("Header", "\n3\n", "\n2\n"), {"Header:5", "three dimensions", "found one of 2"}));
}

TEST_F(Amrex, AnEmptyHeaderIsAnError)
{
    write(threeLevels());
    std::filesystem::resize_file(folder_ + "/Header", 0);
    EXPECT_TRUE(says(loadError(folder_), {"plt00010/Header", "empty"}));
}

TEST_F(Amrex, AFolderThatIsNoPlotfileIsNotMine)
{
    std::filesystem::create_directories(folder_ + "/inner");
    EXPECT_TRUE(says(loadError(folder_), {"plt00010", "no format", "HyperCLaw-V1.1"}));
    std::ofstream(folder_ + "/Header") << "something else\n";
    EXPECT_TRUE(says(loadError(folder_), {"plt00010", "no format"}));
    std::filesystem::remove_all(folder_);
    std::filesystem::create_directories(folder_);
    EXPECT_TRUE(says(loadError(folder_), {"plt00010", "folder is empty"}));
}

TEST_F(Amrex, MissingFilesAreNamed)
{
    write(threeLevels());
    std::filesystem::remove(folder_ + "/Level_1/Cell_H");
    EXPECT_TRUE(says(loadError(folder_), {"Level_1/Cell_H", "cannot be opened"}));
    write(threeLevels());
    std::filesystem::remove(folder_ + "/Level_2/Cell_D_00000");
    EXPECT_TRUE(says(loadError(folder_), {"Level_2/Cell_D_00000", "cannot be opened"}));
}

TEST_F(Amrex, ListsOfManyBoxesAreReadPieceByPiece)
{
    Plotfile3 p;
    p.domain = {{0, 0, 0}, {32, 32, 20}};
    p.boxes = {{}};
    for (int i = 0; i < 32 * 32 * 20; ++i)
        p.boxes[0].push_back({vec3i(i % 32, i / 32 % 32, i / 1024), vec3i(i % 32, i / 32 % 32, i / 1024) + 1});
    p.value = numbered;
    p.boxesPerFile = 5000;
    write(p);
    EXPECT_GT(std::filesystem::file_size(folder_ + "/Level_0/Cell_H"), 1u << 20); // more than one piece
    EXPECT_EQ(cellValues(loadData(folder_)), expected(p, 0));
    edit("Level_0/Cell_H", "Cell_D_00004 0\n", "Cell_D_00004 x\n");
    EXPECT_TRUE(says(loadError(folder_), {"Level_0/Cell_H:40488", "an offset in a data file", "'x'"}));
    std::ofstream(folder_ + "/Level_0/Cell_H") << "1\n1\n1\n0\n(1 " << std::string(3 << 20, '7');
    EXPECT_TRUE(says(loadError(folder_), {"Level_0/Cell_H:5", "the hash of the boxes", "at most 1048576 bytes"}));
}

TEST_F(Amrex, AbsurdCountsAreRefusedBeforeMemoryIsAsked)
{
    EXPECT_TRUE(says(errorAfter("Header", "HyperCLaw-V1.1\n2\n", "HyperCLaw-V1.1\n2000000000\n"),
                     {"Header:2", "number of components", "2000000000"}));
    EXPECT_TRUE(says(errorAfter("Header", "\n2\n1 2 3", "\n2000000\n1 2 3"), {"Header:7", "finest level", "2000000"}));
    EXPECT_TRUE(
        says(errorAfter("Header", "\n1 2 0.25", "\n1 999999999 0.25"), {"Header", "number of grids", "999999999"}));
    EXPECT_TRUE(says(errorAfter("Level_1/Cell_H", "(2 0", "(888888888 0"), {"Level_1/Cell_H:5", "boxes", "888888888"}));
    EXPECT_TRUE(says(errorAfter("Level_1/Cell_H", "(2 0", "(-2 0"), {"Level_1/Cell_H:5", "'-2'"}));
    EXPECT_TRUE(
        says(errorAfter("Level_1/Cell_H", "\n0\n(", "\n99999\n("), {"Level_1/Cell_H:4", "ghost cells", "99999"}));
}

TEST_F(Amrex, HeaderAndCellHeaderHaveToAgree)
{
    EXPECT_TRUE(says(errorAfter("Level_0/Cell_H", "1\n1\n2\n", "1\n1\n3\n"),
                     {"Level_0/Cell_H", "expected 2 components", "found 3"}));
    write(threeLevels());
    edit("Level_1/Cell_H", "(2 0\n((-4,8,2) (3,13,7) (0,0,0))\n", "(1 0\n");
    edit("Level_1/Cell_H", ")\n2\nFabOnDisk: Cell_D_00000 0\n", ")\n1\n");
    EXPECT_TRUE(says(loadError(folder_), {"Level_1/Cell_H", "expected 2 boxes", "found 1"}));
}

TEST_F(Amrex, TheFabHasToBeTheBoxOfItsLevel)
{
    EXPECT_TRUE(says(errorAfter("Level_0/Cell_D_00000", "(3,9,3)", "(3,8,3)"),
                     {"Level_0/Cell_D_00000: FAB at byte 0", "expected box 0", "(3,9,3)", "(3,8,3)"}));
    EXPECT_TRUE(says(errorAfter("Level_0/Cell_D_00000", "(0,0,0)) 2\n", "(0,0,0)) 1\n"), {"2 components", "with 1"}));
    EXPECT_TRUE(says(errorAfter("Level_0/Cell_D_00000", "(3,9,3)", "(1073741824,9,3)"), // no int may hold the extent
                     {"Level_0/Cell_D_00000: FAB at byte 0", "along x", "to 1073741824"}));
}

TEST_F(Amrex, OffsetsHaveToMeetFabs)
{
    const std::string beyond = errorAfter("Level_0/Cell_H", "Cell_D_00000 0\n", "Cell_D_00000 99999999\n");
    EXPECT_TRUE(says(beyond, {"Level_0/Cell_D_00000: FAB at byte 99999999", "end of the file"}));
    EXPECT_TRUE(
        says(errorAfter("Level_0/Cell_H", "Cell_D_00000 0\n", "Cell_D_00000 5\n"), {"FAB at byte 5", "header line"}));
    EXPECT_TRUE(says(errorAfter("Level_0/Cell_H", "Cell_D_00000 0\n", "Cell_D_00000 -5\n"),
                     {"Level_0/Cell_H", "offset", "'-5'"}));
}

TEST_F(Amrex, TruncationIsNoticed)
{
    write(threeLevels());
    const std::string data = folder_ + "/Level_2/Cell_D_00000";
    std::filesystem::resize_file(data, std::filesystem::file_size(data) - 1);
    EXPECT_TRUE(says(loadError(folder_), {"Level_2/Cell_D_00000: FAB at byte 0", "truncated"}));
    write(threeLevels());
    std::filesystem::resize_file(folder_ + "/Header", 150);
    EXPECT_TRUE(says(loadError(folder_), {"Header:"}));
    write(threeLevels());
    std::filesystem::resize_file(folder_ + "/Level_0/Cell_H", 30);
    EXPECT_TRUE(says(loadError(folder_), {"Level_0/Cell_H:"}));
}

TEST_F(Amrex, OtherNumberFormatsAreRefused)
{
    EXPECT_TRUE(says(errorAfter("Level_0/Cell_D_00000", "(64 11 52 0 1 12 0 1023)", "(64 15 48 1 16 0 1 16384)"),
                     {"FAB at byte 0", "IEEE"}));
    EXPECT_TRUE(says(errorAfter("Level_0/Cell_D_00000", "(8 7 6 5 4 3 2 1)", "(2 1 4 3 6 5 8 7)"),
                     {"byte order", "(2 1 4 3 6 5 8 7)"}));
    EXPECT_TRUE(says(errorAfter("Level_0/Cell_D_00000", "FAB ((", "FAB: 8"), {"FAB at byte 0", "header line"}));
    EXPECT_TRUE(
        says(errorAfter("Level_0/Cell_H", "1\n1\n2\n", "2\n1\n2\n"), {"Level_0/Cell_H:1", "vismf.headerversion"}));
}

TEST_F(Amrex, OverlapsAndMisalignmentNameTheBoxes)
{
    Plotfile3 p = threeLevels();
    p.boxes[1][1].upper.z = 11;
    write(p);
    EXPECT_TRUE(says(loadError(folder_), {"Level_1/Cell_H", "box 1", "misaligned"}));
    p = threeLevels();
    p.boxes[1][1].lower.z = 6;
    write(p);
    EXPECT_TRUE(says(loadError(folder_), {"Level_1/Cell_H", "boxes 0 and 1", "overlap"}));
}

TEST_F(Amrex, BoxesFarAwayAreRefused)
{
    Plotfile3 p = threeLevels();
    write(p);
    edit("Level_0/Cell_H", "((-4,2,4) (3,9,7)", "((-4,2,4) (900000000,9,7)");
    EXPECT_TRUE(says(loadError(folder_), {"Level_0/Cell_H", "box 1", "900000000"}));
    EXPECT_TRUE(says(errorAfter("Level_0/Cell_H", "((-4,2,4) (3,9,7)", "((-4,2,4) (-5,9,7)"),
                     {"Level_0/Cell_H:7", "-4 to -5"}));
}

TEST_F(Amrex, RatiosDomainsAndCellSizesHaveToFit)
{
    EXPECT_TRUE(says(errorAfter("Header", "\n2 4 \n", "\n3 4 \n"), {"Header:10", "power of two", "(3,3,3)"}));
    EXPECT_TRUE(says(errorAfter("Header", "\n2 4 \n", "\n2 2 \n"), {"Header", "domain of level 2", "refined by 2"}));
    EXPECT_TRUE(
        says(errorAfter("Header", "\n0.25 0.125 0.5\n", "\n0.25 0.25 0.5\n"), {"Header:14", "cell size", "0.25"}));
    EXPECT_TRUE(says(errorAfter("Header", "\n0.5 0.25 1\n", "\n0.5 0 1\n"), {"Header:13", "positive cell size"}));
    EXPECT_TRUE(says(errorAfter("Header", "\n0\n0\n0 2", "\n1\n0\n0 2"), {"Header", "Cartesian"}));
}

TEST_F(Amrex, NodalDataAreRefused)
{
    EXPECT_TRUE(
        says(errorAfter("Level_0/Cell_H", "(0,0,0))", "(1,1,1))"), {"Level_0/Cell_H:6", "cell centres", "(1,1,1)"}));
}

} // namespace
} // namespace brickwall
