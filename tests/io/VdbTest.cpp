// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/common/EditFile.h"
#include "brickwall/tests/io/IoTest.h"

#include <openvdb/io/File.h>
#include <openvdb/openvdb.h>

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <numeric>

namespace brickwall {
namespace {

using openvdb::Coord;
using openvdb::CoordBBox;

/// Exact in float, different for every cell.
float numbered(const Coord& c)
{
    return static_cast<float>(c.x() + 64 * c.y() + 4096 * c.z());
}

/// Active in these boxes (corners inclusive), with numbered values; voxel (i,j,k) has its centre at `origin` + ((i,j,k)
/// + 1/2) dx.
openvdb::FloatGrid::Ptr grid(const std::string& name, double dx, const std::vector<CoordBBox>& boxes,
                             const openvdb::Vec3d& origin = openvdb::Vec3d(0.0))
{
    openvdb::initialize();
    auto g = openvdb::FloatGrid::create(-1.0f);
    g->setName(name);
    g->setTransform(openvdb::math::Transform::createLinearTransform(dx));
    g->transform().postTranslate(origin + openvdb::Vec3d(dx / 2.0));
    for (const CoordBBox& box : boxes)
        for (auto c = box.begin(); c; ++c)
            g->tree().setValueOn(*c, numbered(*c));
    return g;
}

class Vdb : public testing::Test
{
protected:
    void SetUp() override { path_ = testFolder() + "/data.vdb"; }

    std::string write(const openvdb::GridCPtrVec& grids)
    {
        openvdb::io::File(path_).write(grids);
        return path_;
    }
    std::string bytes() const
    {
        std::ifstream in(path_, std::ios::binary);
        return {std::istreambuf_iterator<char>(in), {}};
    }
    void put(const std::string& bytes) const { std::ofstream(path_, std::ios::binary) << bytes; }

    std::string path_;
};

TEST_F(Vdb, OneGridIsItsActiveVoxels)
{
    // in two leaf nodes, ragged
    write({grid("density", 0.5, {{{0, 0, 0}, {9, 3, 2}}, {{4, 4, 2}, {4, 4, 2}}}, openvdb::Vec3d(1, 2, 3))});
    const auto set = openDataSet(path_);
    EXPECT_EQ(set->format(), "OpenVDB");
    EXPECT_EQ(set->fieldNames(), std::vector<std::string>{"density"});
    const Model model = loadData(path_);
    const CellValues cells = cellValues(model);
    EXPECT_EQ(cells.size(), 10u * 4 * 3 + 1);
    for (const auto& [cell, value] : cells)
        EXPECT_EQ(value, numbered({cell[0], cell[1], cell[2]}));
    EXPECT_EQ(worldBounds(model).lower, vec3d(1, 2, 3));
    EXPECT_EQ(worldBounds(model).upper, vec3d(6, 4.5, 4.5));
}

TEST_F(Vdb, NegativeIndicesAreRead)
{
    write({grid("d", 1.0, {{{-9, -3, -1}, {2, 1, 1}}})});
    const Model model = loadData(path_);
    EXPECT_EQ(model.cellCount, 12u * 5 * 3);
    EXPECT_EQ(worldBounds(model).lower, vec3d(-9, -3, -1));
    for (const auto& [cell, value] : cellValues(model))
        EXPECT_EQ(value, numbered({cell[0], cell[1], cell[2]}));
}

TEST_F(Vdb, CoarseVoxelsUnderFinerOnesAreLeftOut)
{
    // Level 0 is four times as coarse as level 2; between them there is less.
    const auto coarse = grid("rho_L0", 1.0, {{{0, 0, 0}, {7, 7, 7}}});
    const auto middle = grid("rho_L1", 0.5, {{{4, 4, 4}, {11, 11, 11}}});
    const auto fine = grid("rho_L2", 0.25, {{{12, 12, 12}, {27, 19, 19}}}); // sticks out of level 1
    write({coarse, fine, middle});
    EXPECT_EQ(openDataSet(path_)->fieldNames(), std::vector<std::string>{"rho"});
    const Model model = loadData(path_);
    const CellValues cells = cellValues(model);
    std::uint64_t volumeOfCells = 0;
    for (const auto& [cell, value] : cells) {
        volumeOfCells += std::uint64_t(1) << 3 * cell[3];
        EXPECT_EQ(value, numbered({cell[0] >> cell[3], cell[1] >> cell[3], cell[2] >> cell[3]}));
    }
    EXPECT_EQ(volumeOfCells, 32u * 32 * 32);
    EXPECT_EQ(cellsPerLevel(model.bricks),
              (std::vector<std::uint64_t>{16 * 8 * 8, 512 - 6 * 4 * 4, 512 - 64 - 1 * 2 * 2}));
    EXPECT_EQ(worldBounds(model).upper, vec3d(8));
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_TRUE(says(model.notes[0], {"164 cells left out"}));
}

TEST_F(Vdb, WhatIsLeftOfACoarseVoxelBecomesFiner)
{
    const auto coarse = grid("d", 1.0, {{{0, 0, 0}, {1, 0, 0}}});
    const auto fine = grid("d", 0.5, {{{0, 0, 0}, {0, 0, 0}}}); // an eighth of the first
    write({coarse, fine});
    const CellValues cells = cellValues(loadData(path_));
    EXPECT_EQ(cells.size(), 8u + 1);
    EXPECT_EQ(cells.at({2, 0, 0, 1}), 1.0f);
    for (const auto& [cell, value] : cells)
        EXPECT_EQ(value,
                  numbered({cell[0] / 2, cell[1] / 2, cell[2] / 2})); // all of the coarse grid, 0 in the fine one
}

TEST_F(Vdb, LevelsMayBeGaps)
{
    write({grid("d_level_0", 4.0, {{{0, 0, 0}, {1, 1, 1}}}), grid("d_level_2", 1.0, {{{0, 0, 0}, {2, 3, 3}}})});
    std::uint64_t volumeOfCells = 0;
    const Model model = loadData(path_);
    for (const auto& [cell, value] : cellValues(model))
        volumeOfCells += std::uint64_t(1) << 3 * cell[3];
    EXPECT_EQ(volumeOfCells, 512u);
    EXPECT_EQ(cellsPerLevel(model.bricks), (std::vector<std::uint64_t>{64, 0, 7}));
}

TEST_F(Vdb, TilesBecomeCoarserCells)
{
    auto g = grid("smoke", 1.0, {{{0, 0, 0}, {7, 7, 7}}});
    g->tree().addTile(1, Coord(8, 0, 0), 5.0f, true);   // 8 wide
    g->tree().addTile(2, Coord(128, 0, 0), 6.0f, true); // 128 wide
    g->tree().addTile(2, Coord(256, 0, 0), 7.0f, false);
    write({g});
    const Model model = loadData(path_);
    const CellValues cells = cellValues(model);
    EXPECT_EQ(cells.size(), 512u + 1 + 1);
    EXPECT_EQ(cells.at({8, 0, 0, 3}), 5.0f);
    EXPECT_EQ(cells.at({128, 0, 0, 7}), 6.0f);
}

TEST_F(Vdb, TilesThatAreCoveredInPartBecomeVoxels)
{
    auto coarse = grid("d_L0", 2.0, {});
    coarse->tree().addTile(1, Coord(0, 0, 0), 5.0f, true);
    coarse->tree().addTile(1, Coord(8, 0, 0), 6.0f, true);
    write({coarse, grid("d_L1", 1.0, {{{0, 0, 0}, {1, 1, 1}}})});
    const CellValues cells = cellValues(loadData(path_));
    EXPECT_EQ(cells.size(), 8u + 511 + 1);
    EXPECT_EQ(cells.at({2, 0, 0, 1}), 5.0f);
    EXPECT_EQ(cells.at({16, 0, 0, 4}), 6.0f);
}

TEST_F(Vdb, VectorsAreComponentsAndMagnitude)
{
    openvdb::initialize();
    auto v = openvdb::Vec3SGrid::create();
    v->setName("velocity");
    for (auto c = CoordBBox({0, 0, 0}, {3, 3, 3}).begin(); c; ++c)
        v->tree().setValueOn(*c, openvdb::Vec3s(float((*c).x()), float((*c).y()), float((*c).z())));
    write({v});
    const auto set = openDataSet(path_);
    EXPECT_EQ(set->fieldNames(),
              (std::vector<std::string>{"velocity_x", "velocity_y", "velocity_z", "velocity_magnitude"}));
    EXPECT_EQ(set->defaultField(), "velocity_magnitude");
    const Model model = loadData(path_);
    for (const auto& [cell, value] : cellValues(model, 1))
        EXPECT_EQ(value, float(cell[1]));
    for (const auto& [cell, value] : cellValues(model, 3))
        EXPECT_FLOAT_EQ(value, float(std::sqrt(cell[0] * cell[0] + cell[1] * cell[1] + cell[2] * cell[2])));
}

TEST_F(Vdb, OtherNumbersAreReadAndOthersLeftOut)
{
    openvdb::initialize();
    auto d = openvdb::DoubleGrid::create();
    auto i = openvdb::Int32Grid::create();
    auto b = openvdb::BoolGrid::create();
    auto half = grid("half", 1.0, {{{0, 0, 0}, {1, 1, 1}}});
    half->setSaveFloatAsHalf(true);
    d->setName("double");
    i->setName("int");
    b->setName("bool");
    d->tree().setValueOn({1, 1, 1}, 0.5);
    i->tree().setValueOn({1, 1, 1}, 7);
    b->tree().setValueOn({1, 1, 1}, true);
    write({d, i, b, half});
    EXPECT_EQ(openDataSet(path_)->fieldNames(), (std::vector<std::string>{"double", "int", "half"}));
    EXPECT_EQ(cellValues(loadData(path_, {"int"})).begin()->second, 7.0f);
    EXPECT_EQ(cellValues(loadData(path_, {"half"})).at({1, 1, 0, 0}), 65.0f);
    write({b});
    EXPECT_TRUE(says(loadError(path_), {"data.vdb", "grids of numbers", "bool (Tree_bool_5_4_3)"}));
}

TEST_F(Vdb, FieldsOfOneFileShareTheirCells)
{
    auto a = grid("a", 1.0, {{{0, 0, 0}, {3, 3, 3}}});
    auto b = grid("b", 1.0, {{{2, 0, 0}, {5, 3, 3}}});
    a->tree().addTile(1, Coord(8, 0, 0), 5.0f, true);
    b->tree().setValueOn({9, 1, 1}, 3.0f);
    write({a, b});
    const Model model = loadData(path_);
    const CellValues first = cellValues(model, 0), second = cellValues(model, 1);
    EXPECT_EQ(first.size(), 6u * 4 * 4 + 512);
    EXPECT_EQ(first.at({5, 0, 0, 0}), -1.0f); // the background of a
    EXPECT_EQ(second.at({5, 0, 0, 0}), 5.0f);
    EXPECT_EQ(second.at({9, 1, 1, 0}), 3.0f);
    EXPECT_EQ(first.at({9, 1, 1, 0}), 5.0f);
    EXPECT_EQ(cellValues(loadData(path_, {"a"})).size(), 64u + 1);
}

TEST_F(Vdb, FieldsMayHaveOtherLevels)
{
    write({grid("a", 1.0, {{{0, 0, 0}, {3, 3, 3}}}), grid("b", 2.0, {{{0, 0, 0}, {3, 1, 1}}})});
    const Model model = loadData(path_);
    EXPECT_EQ(cellsPerLevel(model.bricks), (std::vector<std::uint64_t>{64, 8}));
    EXPECT_EQ(cellValues(model, 1).at({3, 1, 2, 0}), numbered({1, 0, 1}));
    EXPECT_EQ(cellValues(model, 0).at({4, 0, 0, 1}), -1.0f);
}

TEST_F(Vdb, TheBackgroundIsShownIfAskedFor)
{
    write({grid("d", 1.0, {{{0, 0, 0}, {0, 0, 0}}, {{3, 4, 5}, {3, 4, 5}}})});
    EXPECT_EQ(loadData(path_).cellCount, 2u);
    const CellValues cells = cellValues(loadData(path_ + ":background"));
    EXPECT_EQ(cells.size(), 4u * 5 * 6);
    EXPECT_EQ(cells.at({1, 0, 0, 0}), -1.0f);
    EXPECT_EQ(cells.at({3, 4, 5, 0}), numbered({3, 4, 5}));
    EXPECT_TRUE(says(loadError(path_ + ":holes"), {"data.vdb", "background", "'holes'"}));
}

TEST_F(Vdb, TheOriginOfAmrCodesGoesBeforeTheTransform)
{
    auto coarse = grid("v_L0", 1.0, {{{0, 0, 0}, {3, 3, 3}}});
    auto fine = grid("v_L1", 0.5, {{{2, 2, 2}, {5, 5, 5}}});
    for (const auto& g : {coarse, fine}) { // scale alone
        const double dx = g->voxelSize()[0];
        g->setTransform(openvdb::math::Transform::createLinearTransform(dx));
        g->insertMeta("dx", openvdb::DoubleMetadata(dx));
        g->insertMeta("origin", openvdb::Vec3DMetadata(openvdb::Vec3d(10, 20, 30)));
    }
    write({coarse, fine});
    const Model model = loadData(path_);
    EXPECT_EQ(worldBounds(model).lower, vec3d(10, 20, 30));
    EXPECT_EQ(model.cellCount, 64u + 64 - 8);
}

TEST_F(Vdb, ScalesMayDifferAlongAxes)
{
    auto g = grid("d", 1.0, {{{0, 0, 0}, {1, 1, 1}}});
    openvdb::math::Transform::Ptr t = openvdb::math::Transform::createLinearTransform();
    t->preScale(openvdb::Vec3d(1, 2, 4));
    g->setTransform(t);
    write({g});
    EXPECT_EQ(worldBounds(loadData(path_)).upper, vec3d(1.5, 3, 6));
}

TEST_F(Vdb, OtherTransformsAreRefused)
{
    auto g = grid("turned", 1.0, {{{0, 0, 0}, {1, 1, 1}}});
    g->transform().preRotate(0.3);
    write({g});
    EXPECT_TRUE(says(loadError(path_), {"data.vdb: grid 'turned'", "rotation or shear"}));
    g->setTransform(openvdb::math::Transform::createFrustumTransform(
        openvdb::BBoxd(openvdb::Vec3d(0), openvdb::Vec3d(10)), 0.5, 10.0));
    write({g});
    EXPECT_TRUE(says(loadError(path_), {"data.vdb: grid 'turned'", "scale and translation", "Frustum"}));
}

TEST_F(Vdb, LevelsHaveToFitEachOther)
{
    write({grid("d_L0", 1.0, {{{0, 0, 0}, {1, 1, 1}}}), grid("d_L1", 0.4, {{{0, 0, 0}, {1, 1, 1}}})});
    EXPECT_TRUE(says(loadError(path_), {"data.vdb", "powers of two", "'d_L0'"}));
    write({grid("d_L0", 1.0, {{{0, 0, 0}, {1, 1, 1}}}),
           grid("d_L1", 0.5, {{{0, 0, 0}, {1, 1, 1}}}, openvdb::Vec3d(0.2, 0, 0))});
    EXPECT_TRUE(says(loadError(path_), {"data.vdb", "corners in common", "'d_L1'", "0.4"}));
}

TEST_F(Vdb, AbsurdExtentsAreRefused)
{
    auto g = grid("d", 1.0, {});
    g->tree().setValueOn(Coord(1 << 30, 0, 0), 1.0f);
    write({g});
    EXPECT_TRUE(says(loadError(path_), {"data.vdb", "1073741824"}));
    write({grid("d", 1.0, {})});
    EXPECT_TRUE(says(loadError(path_), {"data.vdb", "active voxels, found none"}));
    auto far = grid("d", 1.0, {{{0, 0, 0}, {0, 0, 0}}});
    far->tree().setValueOn(Coord(100000, 100000, 100000), 1.0f);
    write({far});
    EXPECT_EQ(loadData(path_).cellCount, 2u);
    EXPECT_TRUE(says(loadError(path_ + ":background"), {"data.vdb", "2^32"}));
}

TEST_F(Vdb, AFewVoxelsDoNotBecomeGigabytes)
{
    auto two = grid("d", 1.0, {{{0, 0, 0}, {0, 0, 0}}});
    two->tree().setValueOn(Coord(999, 999, 999), 1.0f);
    write({two});
    EXPECT_TRUE(says(loadError(path_ + ":background"), {"data.vdb", "1000000000", "2 active voxels"}));

    auto tiles = grid("a", 1.0, {}), coarse = grid("b", 2.0, {{{0, 0, 0}, {0, 0, 0}}});
    for (int i = 0; i < 10; ++i)
        tiles->tree().addTile(2, Coord(128 * i, 0, 0), 5.0f, true);
    write({tiles, coarse});
    EXPECT_TRUE(says(loadError(path_), {"data.vdb", "11 active voxels and tiles"}));
    EXPECT_EQ(loadData(path_, {"a"}).cellCount, 10u);
}

TEST_F(Vdb, NonFiniteValuesAreNamedOrLeftOut)
{
    auto g = grid("d", 1.0, {{{0, 0, 0}, {3, 3, 3}}});
    g->tree().setValueOn({1, 2, 3}, std::nanf(""));
    write({g});
    EXPECT_TRUE(says(loadError(path_), {"data.vdb", "nan", "'d'", "(1,2,3)"}));
    Progress silent;
    EXPECT_EQ(openDataSet(path_)->load(std::vector<std::string>{"d"}, Executor(2), silent, NonFinite::empty).cellCount,
              63u);
}

TEST_F(Vdb, TruncationIsNoticedWhereverItIs)
{
    write({grid("a_L0", 1.0, {{{0, 0, 0}, {20, 20, 20}}}), grid("a_L1", 0.5, {{{0, 0, 0}, {20, 20, 20}}})});
    const std::string whole = bytes();
    for (std::size_t size = 9; size < whole.size(); size += 1 + whole.size() / 97) {
        put(whole.substr(0, size));
        EXPECT_TRUE(says(loadError(path_), {"data.vdb"})) << size;
    }
}

TEST_F(Vdb, AbsurdLengthsAreRefusedBeforeMemoryIsAsked)
{
    write({grid("density", 1.0, {{{0, 0, 0}, {1, 1, 1}}})});
    const std::string whole = bytes();
    const auto errorWith = [&](const std::string& before, std::uint32_t number) {
        std::string broken = whole;
        const auto at = broken.find(before);
        EXPECT_NE(at, std::string::npos) << before;
        std::memcpy(broken.data() + at - 4, &number, 4);
        put(broken);
        return loadError(path_);
    };
    EXPECT_TRUE(says(errorWith("density", 0xfffffff0u), {"data.vdb: byte", "the name of a grid", "4294967280"}));
    EXPECT_TRUE(says(errorWith("Tree_float", 0x7fffffffu), {"the type of a grid", "2147483647"}));
    EXPECT_TRUE(says(errorWith("file_bbox_max", 0x7fffffffu), {"the name of metadata", "2147483647"}));
    EXPECT_TRUE(says(errorWith("UniformScale", 0x7fffffffu), {"the type of a grid's transform", "2147483647"}));
}

TEST_F(Vdb, FloatsHaveTheWidthThatTheLibraryReads)
{
    // The type's name says 16 bits and the metadata do not, or the other way round: OpenVDB goes by the metadata, and
    // unpacked twice of what it had room for.
    const auto half = grid("h", 1.0, {{{0, 0, 0}, {7, 7, 7}}});
    half->setSaveFloatAsHalf(true);
    for (const std::uint32_t packing : {0, 1, 3, 6}) {
        openvdb::io::File file(path_);
        file.setCompression(packing);
        file.write({half});
        EXPECT_EQ(loadData(path_).cellCount, 512u);
        editFile(path_, "is_saved_as_half_float", "is_saved_as_half_floaT");
        EXPECT_TRUE(says(loadError(path_), {"data.vdb"})) << packing;
    }
}

TEST_F(Vdb, EmptyNodesMayLieAnywhere)
{
    const auto g = grid("d", 1.0, {{{0, 0, 0}, {1, 0, 0}}});
    g->tree().touchLeaf(Coord(2147483640, 2147483640, -2147483640));
    EXPECT_EQ(loadData(write({g})).cellCount, 2u);
}

TEST_F(Vdb, NodesThatTheLibraryWouldReadInAnotherOrderAreRefused)
{
    // OpenVDB keeps them sorted and then reads their values in that order: what belongs to one goes to the other.
    write({grid("d", 1.0, {{{1, 1, 1}, {2, 1, 1}}, {{4100, -4095, 4097}, {4100, -4095, 4097}}})});
    const std::string whole = bytes();
    const std::string second("\0\x10\0\0\0\xf0\xff\xff\0\x10\0\0", 12); // its place, (4096,-4096,4096)
    const std::size_t at = whole.find(second);
    ASSERT_NE(at, std::string::npos);
    for (const std::int32_t x : {0, -4096}) {
        std::string broken = whole;
        std::memcpy(broken.data() + at, &x, sizeof x);
        put(broken);
        EXPECT_TRUE(says(loadError(path_), {"data.vdb", "in the order of their places"})) << x;
    }
}

TEST_F(Vdb, AllPackingsHoldTheSame)
{
    const auto ragged = grid("d", 1.0, {{{0, 0, 0}, {20, 3, 2}}, {{-5, 40, 7}, {-5, 40, 7}}});
    const CellValues expected = cellValues(loadData(write({ragged})));
    for (const std::uint32_t packing : {0, 1, 2, 3, 4, 6}) {
        openvdb::io::File file(path_);
        file.setCompression(packing);
        file.write({ragged});
        EXPECT_EQ(cellValues(loadData(path_)), expected) << packing;
    }
}

TEST_F(Vdb, ManyDamagedFilesAreAnswered)
{
    // Without the checks of core/io/VdbTreeCheck.h OpenVDB writes beyond its nodes for some of these.
    const openvdb::GridCPtrVec grids{grid("d_L0", 1.0, {{{0, 0, 0}, {9, 9, 9}}}),
                                     grid("d_L1", 0.5, {{{0, 0, 0}, {9, 9, 9}}})};
    for (const std::uint32_t packing : {openvdb::io::COMPRESS_ZIP, openvdb::io::COMPRESS_BLOSC}) {
        openvdb::io::File file(path_);
        file.setCompression(packing | openvdb::io::COMPRESS_ACTIVE_MASK);
        file.write(grids);
        const std::string whole = bytes();
        for (std::size_t at = 8; at < whole.size(); at += 1 + whole.size() / 1009) {
            std::string broken = whole;
            broken[at] = static_cast<char>(~broken[at]);
            put(broken);
            try {
                loadData(path_);
            } catch (const Error& error) {
                EXPECT_TRUE(says(error.what(), {"data.vdb"})) << at;
            }
        }
    }
}

/// Of ../shared/data.
class RealVdb : public testing::Test
{
protected:
    std::string file(const std::string& name) const { return BRICKWALL_SOURCE_DIR "/../shared/data/" + name; }
    bool missing(const std::string& name) const { return !std::filesystem::exists(file(name)); }
};

double sumOf(const Field& field)
{
    return std::accumulate(field.values.begin(), field.values.end(), 0.0);
}

TEST_F(RealVdb, SphereHasTheLeafCellsOfItsPlotfile)
{
    if (missing("vdb/sphere_laminar_full_3lev.vdb"))
        GTEST_SKIP() << "no sample data";
    const Model model = loadData(file("vdb/sphere_laminar_full_3lev.vdb"), {"velocity_x", "velocity_magnitude"});
    EXPECT_EQ(cellsPerLevel(model.bricks),
              (std::vector<std::uint64_t>{130560, 114688 - 130560 / 8, 65536 - 114688 / 8}));
    EXPECT_EQ(voxelBounds(model.bricks), (Box3i{{0, 0, 0}, {256, 128, 128}}));
    EXPECT_EQ(worldBounds(model).upper, vec3d(16, 8, 8));
    EXPECT_NEAR(model.fields[0].range.hi, 29739.688, 0.001);
    EXPECT_EQ(model.fields[1].range.lo, 0.0f);
    EXPECT_NEAR(sumOf(model.fields[0]), 5697667228.31, 1.0);
}

TEST_F(RealVdb, DisturbedSphereHasItsLeafCells)
{
    if (missing("vdb/sphere_small_full_3lev.vdb"))
        GTEST_SKIP() << "no sample data";
    const Model model = loadData(file("vdb/sphere_small_full_3lev.vdb"), {"velocity_y"});
    EXPECT_EQ(cellsPerLevel(model.bricks), (std::vector<std::uint64_t>{366592, 82176, 49536}));
    std::int64_t covered = 0;
    for (const Brick& b : model.bricks)
        covered += volume(b.box());
    EXPECT_EQ(covered, 256 * 128 * 128);
}

TEST_F(RealVdb, SmokeHasItsActiveVoxels)
{
    if (missing("vdb/smoke.vdb"))
        GTEST_SKIP() << "no sample data";
    const Model model = loadData(file("vdb/smoke.vdb"));
    EXPECT_EQ(model.cellCount, 1049275u);
    EXPECT_EQ(voxelBounds(model.bricks), (Box3i{{1, 2, 1}, {112, 224, 113}}));
    EXPECT_NEAR(sumOf(model.fields[0]), 171499.6955, 0.01);
    EXPECT_EQ(loadData(file("vdb/smoke.vdb") + ":background").cellCount, 111u * 222 * 112);
}

} // namespace
} // namespace brickwall
