// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/io/LevelCells.h"
#include "brickwall/tests/oracles/WriteFlash.h"
#include "brickwall/tests/oracles/WriteHdf5.h"

#include <cmath>
#include <numeric>

namespace brickwall {
namespace {

using namespace oracles;

/// Blocks of 4 x 6 x 2 cells on refine levels 1 to 4, without leaves on level 2.
Flash3 oblong()
{
    Flash3 f;
    f.fields = {"dens", "fe"};
    f.blockCells = {4, 6, 2};
    f.rootBlocks = {2, 1, 3};
    f.lower = {-1, 0.25, 10};
    f.upper = {1, 1.75, 16};
    f.refined = [](int level, const vec3i& block) {
        return level == 1 ? block == vec3i(1, 0, 1) : level == 2 || (level == 3 && block == vec3i(5, 2, 6));
    };
    f.value = numbered;
    return f;
}

CellValues expected(const Flash3& f, int field)
{
    const std::vector<FlashBlock> blocks = flashBlocks(f);
    int finest = 0;
    for (const FlashBlock& b : blocks)
        finest = std::max(finest, b.refineLevel);
    CellValues cells;
    for (const FlashBlock& b : blocks)
        for (int i = 0; b.leaf && i < f.blockCells.x * f.blockCells.y * f.blockCells.z; ++i) {
            const vec3i n = f.blockCells, c = b.place * n + vec3i(i % n.x, i / n.x % n.y, i / n.x / n.y);
            const int level = finest - b.refineLevel;
            cells[{c.x << level, c.y << level, c.z << level, level}] =
                static_cast<float>(f.value(b.refineLevel, field, c));
        }
    return cells;
}

class Flash : public testing::Test
{
protected:
    void SetUp() override { path_ = testFolder() + "/sedov_hdf5_plt_cnt_0001"; }

    /// The message after a dataset of a good file was replaced by these numbers.
    std::string errorWith(const std::string& dataset, const std::vector<std::uint64_t>& shape,
                          const std::vector<double>& values)
    {
        writeFlash(path_, oblong());
        {
            Hdf5Writer file(path_, Hdf5Writer::Mode::edit);
            file.remove(dataset);
            file.numbers(dataset, shape, values, Hdf5Number::int32);
        }
        return loadError(path_);
    }

    std::string path_;
};

TEST_F(Flash, EveryLeafCellOfOblongBlocksHasItsValue)
{
    for (const bool floats : {true, false})
        for (const bool chunked : {false, true}) {
            Flash3 f = oblong();
            f.floats = floats;
            f.chunked = chunked;
            writeFlash(path_, f);
            const auto set = openDataSet(path_);
            EXPECT_EQ(set->format(), "FLASH");
            EXPECT_EQ(set->fieldNames(), (std::vector<std::string>{"dens", "fe"})); // "fe  " in the file
            EXPECT_EQ(set->defaultField(), "dens");
            const Model model = loadData(path_);
            EXPECT_EQ(cellValues(model, 0), expected(f, 0));
            EXPECT_EQ(cellValues(model, 1), expected(f, 1));
            EXPECT_TRUE(model.notes.empty());
        }
}

TEST_F(Flash, TheWorldIsThatOfTheBoundingBoxes)
{
    writeFlash(path_, oblong());
    const Model model = loadData(path_, {"dens"});
    EXPECT_EQ(worldBounds(model).lower, vec3d(-1, 0.25, 10));
    EXPECT_EQ(worldBounds(model).upper, vec3d(1, 1.75, 16));
    EXPECT_EQ(voxelBounds(model.bricks), (Box3i{{0, 0, 0}, {64, 48, 48}}));
}

TEST_F(Flash, FacesInFloatAreGoodEnoughForDeepLevels)
{
    Flash3 f;
    f.lower = vec3d(-1e18 / 3);
    f.upper = vec3d(2e18 / 3);
    f.blockCells = {2, 2, 2};
    f.refined = [](int level, const vec3i& block) {
        return level < 15 && block == vec3i((1 << (level - 1)) - 1); // towards the upper corner
    };
    f.value = numbered;
    writeFlash(path_, f);
    EXPECT_EQ(cellValues(loadData(path_)), expected(f, 0));
}

/// Refined around one point of a domain that is wide against its deepest blocks, down to `levels`.
Flash3 deep(int levels)
{
    Flash3 f;
    f.lower = vec3d(-1e18 / 3);
    f.upper = vec3d(2e18 / 3);
    f.blockCells = {2, 2, 2};
    f.refined = [levels](int level, const vec3i& block) {
        const vec3i point(0.9 * (1 << (level - 1)), 0.7 * (1 << (level - 1)), 0.99 * (1 << (level - 1)));
        return level < levels && block == point;
    };
    f.value = numbered;
    return f;
}

TEST_F(Flash, FacesThatFloatCannotTellApartFollowFromTheTree)
{
    Flash3 f = deep(25);
    for (const bool floats : {true, false}) {
        f.floats = floats;
        f.tree = true;
        writeFlash(path_, f);
        EXPECT_EQ(cellValues(loadData(path_)), expected(f, 0)) << (floats ? "float" : "double");
    }
}

TEST_F(Flash, WithoutATreeFacesThatFloatCannotTellApartAreNamed)
{
    writeFlash(path_, deep(25));
    EXPECT_TRUE(says(loadError(path_), {"/bounding box", "refine level", "whole number of them"}));
}

TEST_F(Flash, ATreeThatContradictsTheFacesIsRefused)
{
    Flash3 f = deep(25);
    f.tree = true;
    writeFlash(path_, f);
    {
        Hdf5Writer file(path_, Hdf5Writer::Mode::edit);
        const std::size_t count = flashBlocks(f).size();
        file.remove("gid");
        file.numbers("gid", {count, 15}, std::vector<double>(count * 15, 2.0), Hdf5Number::int32);
    }
    EXPECT_TRUE(says(loadError(path_), {"/bounding box", "refine level", "whole number of them"}));
}

TEST_F(Flash, ThreadsDoNotMatter)
{
    writeFlash(path_, oblong());
    EXPECT_EQ(loadData(path_, {}, 1).fields[1].values, loadData(path_, {}, 4).fields[1].values);
}

TEST_F(Flash, NonFiniteValuesNameFileFieldAndCell)
{
    Flash3 f = oblong();
    f.value = [](int level, int, const vec3i& c) { return level == 1 && c == vec3i(3, 5, 1) ? NAN : 1.0; };
    writeFlash(path_, f);
    EXPECT_TRUE(says(loadError(path_), {"plt_cnt_0001: /dens", "'dens'", "nan", "cell (3,5,1)"}));
}

TEST_F(Flash, FewerDimensionsAreRefused)
{
    Flash3 f;
    f.blockCells = {8, 8, 1};
    writeFlash(path_, f);
    EXPECT_TRUE(says(loadError(path_), {"/dens", "three dimensions", "8 x 8 x 1"}));
}

TEST_F(Flash, OtherGeometriesAreRefused)
{
    Flash3 f;
    f.geometry = "spherical";
    writeFlash(path_, f);
    EXPECT_TRUE(says(loadError(path_), {"/string scalars", "'cartesian'", "'spherical'"}));
}

TEST_F(Flash, ParticleFilesAreRefused)
{
    {
        Hdf5Writer file(path_);
        file.texts("sim info", {1}, {"x"}, 4);
        file.texts("particle names", {1, 1}, {"mass"}, 24);
    }
    EXPECT_TRUE(says(loadError(path_), {"particle file", "plt_cnt"}));
}

TEST_F(Flash, MissingDatasetsAreNamed)
{
    for (const std::string name : {"unknown names", "refine level", "dens", "fe  "}) {
        writeFlash(path_, oblong());
        Hdf5Writer(path_, Hdf5Writer::Mode::edit).remove(name);
        EXPECT_TRUE(says(loadError(path_), {path_, name.substr(0, name.find("  ")), "found none"}));
    }
}

TEST_F(Flash, ShapesHaveToAgree)
{
    EXPECT_TRUE(says(errorWith("refine level", {2}, {1, 1}), {"/refine level", "shape of (86)", "(2)"}));
    EXPECT_TRUE(says(errorWith("node type", {2, 2}, {1, 1, 1, 1}), {"/node type", "(2, 2)"}));
    EXPECT_TRUE(says(errorWith("fe  ", {86, 2, 6, 3}, std::vector<double>(86 * 36)), {"/fe", "(86, 2, 6, 4)"}));
    EXPECT_TRUE(says(errorWith("dens", {3, 3, 3}, std::vector<double>(27)), {"/dens", "blocks, z, y and x"}));
}

TEST_F(Flash, BlocksThatAreNotOfAnOctreeAreNamed)
{
    const std::size_t count = flashBlocks(oblong()).size();
    ASSERT_EQ(count, 6u + 8 + 64 + 8);
    std::vector<double> refine;
    for (const FlashBlock& b : flashBlocks(oblong()))
        refine.push_back(b.refineLevel);
    refine[0] = 2;
    EXPECT_TRUE(says(errorWith("refine level", {count}, refine), {"/bounding box", "block 0", "refine level 2"}));
    refine[0] = -7;
    EXPECT_TRUE(says(errorWith("refine level", {count}, refine), {"/refine level", "1 to 64", "-7"}));
    refine[0] = 60;
    EXPECT_TRUE(says(errorWith("refine level", {count}, refine), {"/refine level", "levels", "60"}));
}

TEST_F(Flash, OverlappingLeavesAreNamed)
{
    const std::vector<double> leaves(flashBlocks(oblong()).size(), 1); // parents as well
    EXPECT_TRUE(says(errorWith("node type", {leaves.size()}, leaves), {"leaves", "overlap", "refine level 1"}));
    EXPECT_TRUE(says(errorWith("node type", {leaves.size()}, std::vector<double>(leaves.size(), 2)),
                     {"/node type", "leaf blocks", "found none"}));
}

TEST_F(Flash, NegativeExtentsAreRefused)
{
    const std::size_t count = flashBlocks(oblong()).size();
    std::vector<double> bounds;
    for (std::size_t i = 0; i < count * 3; ++i)
        bounds.insert(bounds.end(), {2, 1});
    EXPECT_TRUE(says(errorWith("bounding box", {count, 3, 2}, bounds), {"/bounding box", "block 0", "2 and 1"}));
}

TEST_F(Flash, HugeShapesWithoutValuesAreRefused)
{
    writeFlash(path_, oblong());
    {
        Hdf5Writer file(path_, Hdf5Writer::Mode::edit);
        file.remove("dens");
        file.unwritten("dens", {86, 1024, 1024, 1024});
    }
    EXPECT_TRUE(says(loadError(path_), {"/dens", "truncated", "(86, 1024, 1024, 1024)"}));
}

TEST_F(Flash, SedovOfFlashXHasItsLeafCells)
{
    const std::string path = BRICKWALL_SOURCE_DIR "/../shared/data/flash/sedov_hdf5_plt_cnt_0001";
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << "no sample data: " << path;
    EXPECT_EQ(openDataSet(path)->fieldNames(),
              (std::vector<std::string>{"dens", "pres", "temp", "velx", "vely", "velz"}));
    const Model model = loadData(path, {"dens", "velx"});
    EXPECT_EQ(model.cellCount, 720896u);
    EXPECT_EQ(cellsPerLevel(model.bricks), (std::vector<std::uint64_t>{128 * 4096, 48 * 4096}));
    EXPECT_EQ(worldBounds(model).lower, vec3d(0));
    EXPECT_EQ(worldBounds(model).upper, vec3d(1));
    EXPECT_EQ(model.fields[0].range.lo, 0.07169145f); // as numpy finds them in the leaf blocks
    EXPECT_EQ(model.fields[0].range.hi, 3.5975504f);
    EXPECT_EQ(model.fields[1].range.lo, -5.410651f);
    EXPECT_EQ(model.fields[1].range.hi, 5.379403f);
    EXPECT_NEAR(std::accumulate(model.fields[0].values.begin(), model.fields[0].values.end(), 0.0), 720895.9999742806,
                1e-6);
    EXPECT_NEAR(std::accumulate(model.fields[1].values.begin(), model.fields[1].values.end(), 0.0), 11.16977276921169,
                1e-6);
    // ExaBrick's converter read the same file.
    EXPECT_EQ(cellValues(model), cellValues(loadData(BRICKWALL_SOURCE_DIR "/../shared/data/exabrick/flash_sedov.exa")));
}

} // namespace
} // namespace brickwall
