// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/io/IoTest.h"

namespace brickwall {
namespace {

/// Data written by simulation codes; counts and ranges are those of their README and of the .json files beside them.
class RealData : public testing::Test
{
protected:
    void SetUp() override
    {
        if (!std::filesystem::exists(folder_))
            GTEST_SKIP() << "no sample data in " << folder_;
    }
    const std::string folder_ = BRICKWALL_SOURCE_DIR "/../shared/data/";
};

void expectRange(const Field& field, float lo, float hi)
{
    EXPECT_EQ(field.range.lo, lo) << field.name;
    EXPECT_EQ(field.range.hi, hi) << field.name;
}

TEST_F(RealData, BlastPlotfileHasItsLeafCells)
{
    const Model model = loadData(folder_ + "amrex/blast_small_plt00050", {"density", "pressure"});
    EXPECT_EQ(cellsPerLevel(model.bricks), (std::vector<std::uint64_t>{490496, 131200, 8704}));
    EXPECT_EQ(model.cellCount, 630400u);
    EXPECT_EQ(voxelBounds(model.bricks), (Box3i{{0, 0, 0}, {128, 128, 128}}));
    EXPECT_EQ(worldBounds(model).upper, vec3d(1));
    EXPECT_NEAR(model.fields[0].range.lo, 0.03697, 5e-6);
    EXPECT_NEAR(model.fields[0].range.hi, 652.1, 0.05);
    EXPECT_NEAR(model.fields[1].range.lo, 0.00999, 1e-5);
    // The whole domain is covered once.
    std::uint64_t voxels = 0;
    for (const Brick& b : model.bricks)
        voxels += static_cast<std::uint64_t>(volume(b.box()));
    EXPECT_EQ(voxels, 128u * 128 * 128);
    EXPECT_LT(model.bricks.size(), 600u); // the ExaBrick builder makes 496 of these cells
}

TEST_F(RealData, SpherePlotfileHasItsLeafCells)
{
    const std::string path = folder_ + "amrex/sphere_laminar_3lev_plt00360";
    EXPECT_EQ(openDataSet(path)->fieldNames(), (std::vector<std::string>{"density", "Temp", "pressure", "x_velocity",
                                                                         "y_velocity", "z_velocity", "vfrac"}));
    EXPECT_EQ(openDataSet(path)->defaultField(), "density");
    const Model model = loadData(path, {"vfrac"});
    const auto cells = cellsPerLevel(model.bricks);
    // Level 2 has all its cells; what it covers of level 1, and that of level 0, is an eighth each.
    EXPECT_EQ(cells, (std::vector<std::uint64_t>{130560, 114688 - 130560 / 8, 65536 - 114688 / 8}));
    EXPECT_EQ(voxelBounds(model.bricks), (Box3i{{0, 0, 0}, {256, 128, 128}}));
    expectRange(model.fields[0], 0, 1);
    EXPECT_EQ(worldBounds(model).upper, vec3d(16, 8, 8));
}

TEST_F(RealData, SphereOfExaBrickHasItsCellsAndRanges)
{
    const Model model = loadData(folder_ + "exabrick/sphere_laminar.exa");
    EXPECT_EQ(model.bricks.size(), 141u);
    EXPECT_EQ(model.cellCount, 874176u);
    EXPECT_EQ(cellsPerLevel(model.bricks), (std::vector<std::uint64_t>{569856, 139712, 116992, 47616}));
    EXPECT_EQ(voxelBounds(model.bricks), (Box3i{{0, 0, 0}, {512, 256, 256}}));
    ASSERT_EQ(model.fields.size(), 5u);
    EXPECT_EQ(model.fields[0].name, "speed");
    expectRange(model.fields[0], 0.0f, 30002.47265625f);
    expectRange(model.fields[1], -11562.44921875f, 30002.251953125f);
    expectRange(model.fields[2], -15378.1943359375f, 15380.216796875f);
    expectRange(model.fields[3], -15382.564453125f, 15378.8427734375f);
    expectRange(model.fields[4], 630690.6875f, 1296817.25f); // not extended to 0
}

TEST_F(RealData, SedovOfExaBrickHasItsCellsAndRange)
{
    const Model model = loadData(folder_ + "exabrick/flash_sedov.exa");
    EXPECT_EQ(model.bricks.size(), 7u);
    EXPECT_EQ(model.cellCount, 720896u);
    EXPECT_EQ(voxelBounds(model.bricks), (Box3i{{0, 0, 0}, {128, 128, 128}}));
    expectRange(model.fields[0], 0.07169145345687866f, 3.597550392150879f);
}

TEST_F(RealData, BricksFindTheirScalarsWithoutAConfiguration)
{
    const std::string path = folder_ + "exabrick/sphere_laminar.bricks";
    EXPECT_EQ(openDataSet(path)->fieldNames(),
              (std::vector<std::string>{"pressure", "velmag", "x_velocity", "y_velocity", "z_velocity"}));
    EXPECT_EQ(cellValues(loadData(path, {"velmag"})),
              cellValues(loadData(folder_ + "exabrick/sphere_laminar.exa", {"speed"})));
}

} // namespace
} // namespace brickwall
