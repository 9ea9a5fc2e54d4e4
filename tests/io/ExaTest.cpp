// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/io/IoTest.h"
#include "brickwall/tests/oracles/WriteExa.h"

#include <cmath>

namespace brickwall {
namespace {

using namespace oracles;

/// Two bricks of level 1 and 0 with cell IDs 0..3 and 4..7, and the scalars a = ID, b = 10 ID, c = -ID.
class Exa : public testing::Test
{
protected:
    void SetUp() override
    {
        folder_ = testFolder();
        writeBricks(folder_ + "/t.bricks", std::vector<BrickRecord>{{{2, 2, 1}, {-4, 0, 0}, 1, {0, 1, 2, 3}},
                                                                    {{1, 1, 4}, {0, 0, 0}, 0, {7, 6, 5, 4}}});
        std::vector<float> a, b, c;
        for (int i = 0; i < 8; ++i) {
            a.push_back(static_cast<float>(i));
            b.push_back(static_cast<float>(10 * i));
            c.push_back(static_cast<float>(-i));
        }
        writeScalars(folder_ + "/a.scalars", a);
        writeScalars(folder_ + "/b.scalars", b);
        writeScalars(folder_ + "/c.scalars", c);
    }

    std::string exa(const std::string& text)
    {
        writeText(folder_ + "/t.exa", text);
        return folder_ + "/t.exa";
    }

    std::string folder_;
};

TEST_F(Exa, BringsBricksAndFieldsInTheirOrder)
{
    const std::string path = exa("scalar b b.scalars\nscalar a a.scalars\nbricks t.bricks\n");
    const auto set = openDataSet(path);
    EXPECT_EQ(set->format(), "ExaBrick");
    EXPECT_EQ(set->fieldNames(), (std::vector<std::string>{"b", "a"}));
    EXPECT_EQ(set->defaultField(), "b");
    const Model model = loadData(path, {"a", "b"});
    EXPECT_EQ(model.name, "t");
    ASSERT_EQ(model.bricks.size(), 2u);
    EXPECT_EQ(model.fields[0].values, (std::vector<float>{0, 1, 2, 3, 7, 6, 5, 4}));
    EXPECT_EQ(model.fields[1].values, (std::vector<float>{0, 10, 20, 30, 70, 60, 50, 40}));
    EXPECT_EQ(model.worldFromVoxel, mat4d(1.0));
    const CellValues cells = cellValues(model);
    EXPECT_EQ(cells.at({-2, 2, 0, 1}), 3);
    EXPECT_EQ(cells.at({0, 0, 3, 0}), 4);
    EXPECT_TRUE(model.notes.empty());
}

// Values are read from where the IDs of a brick lie in the file; these lie all over it.
TEST_F(Exa, ReadsValuesWhosePlacesInTheFileAreFarApart)
{
    constexpr int cells = 20000, spread = 7919; // a prime: every ID once
    BrickRecord scattered{{cells, 1, 1}, {0, 0, 0}, 0, {}}, swapped{{cells, 1, 1}, {0, 1, 0}, 0, {}};
    std::vector<float> values;
    for (int i = 0; i < cells; ++i) {
        scattered.ids.push_back(int(std::int64_t(i) * spread % cells));
        swapped.ids.push_back(cells + (i ^ 1));
    }
    for (int i = 0; i < 2 * cells; ++i)
        values.push_back(static_cast<float>(i));
    BrickRecord few{{3, 1, 1}, {0, 2, 0}, 0, {0, 2 * cells - 1, cells}};
    writeBricks(folder_ + "/t.bricks", std::vector<BrickRecord>{scattered, swapped, few});
    writeScalars(folder_ + "/a.scalars", values);
    const Model model = loadData(exa("scalar a a.scalars\nbricks t.bricks\n"));
    ASSERT_EQ(model.cellCount, std::uint64_t(2 * cells + 3));
    for (int i = 0; i < cells; ++i) {
        ASSERT_EQ(model.fields[0].values[std::size_t(i)], float(scattered.ids[std::size_t(i)]));
        ASSERT_EQ(model.fields[0].values[std::size_t(cells + i)], float(swapped.ids[std::size_t(i)]));
    }
    EXPECT_EQ(model.fields[0].values[2 * cells + 1], float(2 * cells - 1));
    EXPECT_EQ(model.fields[0].range, (Range{0.0f, float(2 * cells - 1)}));
}

// The original reader loses a last line that has no end, wants "./" before a bare name, and cannot open absolute paths.
TEST_F(Exa, ReadsWhatTheOriginalCannot)
{
    exa("scalar a " + folder_ + "/a.scalars\nbricks t.bricks");
    const auto before = std::filesystem::current_path();
    std::filesystem::current_path(folder_);
    const Model model = loadData("t.exa");
    std::filesystem::current_path(before);
    EXPECT_EQ(model.cellCount, 8u);
}

TEST_F(Exa, IgnoresCommentsAndLineBreaks)
{
    const Model model =
        loadData(exa("# a comment: bricks nowhere\r\nscalar\n  a #name\r\n a.scalars bricks t.bricks # end"));
    EXPECT_EQ(model.fields.at(0).name, "a");
}

TEST_F(Exa, EvaluatesExpressionsOfFieldsAndVectors)
{
    const Model model = loadData(exa("bricks t.bricks\nscalar a a.scalars\nvector m a.scalars b.scalars c.scalars\n"
                                     "scalar e expr \"%1 %0 2 * +\"\nscalar f expr \" %2 %2 * \"\n"),
                                 {"f", "m"});
    const CellValues f = cellValues(model, 0), m = cellValues(model, 1);
    const float magnitude = std::sqrt(9.f + 900.f + 9.f), e = magnitude + 6;
    EXPECT_FLOAT_EQ(m.at({-2, 2, 0, 1}), magnitude);
    EXPECT_FLOAT_EQ(f.at({-2, 2, 0, 1}), e * e);
}

// The original extends every range to 0, because it reads a file four times as long as it is.
TEST_F(Exa, FieldsMayBeMadeOfEachOtherInALongChain)
{
    // One call within the other for each of these was more than a stack has room for.
    constexpr int length = 50000;
    std::string text = "bricks t.bricks scalar f0 a.scalars\n";
    for (int i = 1; i < length; ++i)
        text += "scalar f" + std::to_string(i) + " expr \"%" + std::to_string(i - 1) + " 1 +\"\n";
    const std::string path = exa(text), last = "f" + std::to_string(length - 1);
    EXPECT_EQ(loadData(path, {last}).fields[0].values,
              (std::vector<float>{49999, 50000, 50001, 50002, 50006, 50005, 50004, 50003}));
}

TEST_F(Exa, RangesAreOfTheValuesInUse)
{
    writeScalars(folder_ + "/a.scalars", std::vector<float>{5, 6, 7, 8, 9, 10, 11, 12, 1e9f, std::nanf("")});
    const Model model = loadData(exa("bricks t.bricks scalar a a.scalars value_range 6.5 7"));
    EXPECT_EQ(model.fields[0].range, (Range{5, 12}));
    EXPECT_EQ(model.fields[0].preferredRange, (Range{6.5f, 7}));
}

TEST_F(Exa, RemapsVoxelsToTheWorld)
{
    const Model model = loadData(exa("bricks t.bricks remap_from 0 0 0 4 4 8 remap_to 1 1 1 2 3 2"));
    EXPECT_EQ(transformPoint(model.worldFromVoxel, vec3d(0)), vec3d(1));
    EXPECT_EQ(transformPoint(model.worldFromVoxel, vec3d(4, 4, 8)), vec3d(2, 3, 2));
    EXPECT_EQ(transformPoint(model.worldFromVoxel, vec3d(8, 2, 0)), vec3d(3, 2, 1));
    EXPECT_TRUE(model.fields.empty());
}

TEST_F(Exa, BringsTriangles)
{
    writeTriangles(folder_ + "/t.tris",
                   std::vector<TriangleMesh>{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}},
                                             {{{0, 0, 1}, {1, 0, 1}, {0, 1, 1}}, {{2, 1, 0}, {0, 0, 1}}}});
    const Model model = loadData(exa("bricks t.bricks triangles t.tris"));
    ASSERT_EQ(model.meshes.size(), 2u);
    EXPECT_EQ(model.meshes[1].vertices[2], vec3f(0, 1, 1));
    EXPECT_EQ(model.meshes[1].triangles[0], vec3i(2, 1, 0));
}

TEST_F(Exa, IsKnownByItsContentWhateverItsName)
{
    exa("# comment first\nscalar a a.scalars bricks t.bricks");
    std::filesystem::rename(folder_ + "/t.exa", folder_ + "/config.txt");
    EXPECT_EQ(openDataSet(folder_ + "/config.txt")->fieldNames().size(), 1u);
    writeText(folder_ + "/other.txt", "# not ours\nvtk DataFile\n");
    EXPECT_TRUE(says(loadError(folder_ + "/other.txt"), {"other.txt", "no format"}));
}

TEST_F(Exa, ErrorsNameFileAndLine)
{
    const auto error = [&](const std::string& text) { return loadError(exa(text)); };
    EXPECT_TRUE(says(error("bricks t.bricks\nbrick t.bricks\n"), {"t.exa:2", "unknown keyword 'brick'", "remap_from"}));
    EXPECT_TRUE(says(error("scalar a a.scalars\n"), {"t.exa", "bricks FILE"}));
    EXPECT_TRUE(says(error("bricks t.bricks\n\nscalar z z.scalars"), {"t.exa:3", "'z'", "z.scalars"}));
    EXPECT_TRUE(says(error("bricks\n"), {"t.exa:1", "end of the file"}));
    EXPECT_TRUE(says(error("value_range 0 1\nbricks t.bricks"), {"t.exa:1", "value_range", "no field before it"}));
    EXPECT_TRUE(says(error("bricks t.bricks\nscalar a a.scalars\nvalue_range 0 high"), {"t.exa:3", "'high'"}));
    EXPECT_TRUE(says(error("bricks t.bricks\nscalar a a.scalars\nvalue_range 2 1"), {"t.exa:3", "found 2 to 1"}));
    EXPECT_TRUE(says(error("bricks t.bricks\nremap_to 0 0 0 1 0 1"), {"t.exa:2", "remap_to", "volume", "along y"}));
    EXPECT_TRUE(
        says(error("bricks t.bricks\nscalar a a.scalars\nscalar a b.scalars"), {"t.exa:3", "'a'", "twice", "t.exa:2"}));
    EXPECT_TRUE(says(error("bricks t.bricks\nscalar a a.scalars\nscalar e expr \"%0 %1 +\""), {"t.exa:3", "'%1'"}));
    EXPECT_TRUE(
        says(error("bricks t.bricks\nscalar a a.scalars\nscalar e expr \"%0 1 +"), {"t.exa:3", "closing quote"}));
    EXPECT_TRUE(
        says(error("bricks t.bricks\nscalar a a.scalars\nscalar e expr %0"), {"t.exa:3", "double quotes", "'%0'"}));
    EXPECT_TRUE(says(error("bricks t.bricks\ntriangles t.tris\n"), {"t.exa:2", "t.tris"}));
    EXPECT_TRUE(says(error("bricks missing.bricks\n"), {"t.exa:1", "missing.bricks"}));
    EXPECT_TRUE(says(error("#nothing\n"), {"t.exa", "bricks FILE"}));
}

TEST_F(Exa, DoesNotTakeCellsForBricks)
{
    writeCells(folder_ + "/t.cells", std::vector<Cell>{{{0, 0, 0}, 0}});
    EXPECT_TRUE(says(loadError(exa("bricks t.cells")), {"t.exa:1", "t.cells", "opening that file itself"}));
}

TEST_F(Exa, AnUnknownFieldIsAnErrorThatListsTheOthers)
{
    const std::string path = exa("bricks t.bricks scalar a a.scalars scalar b b.scalars");
    EXPECT_TRUE(says(errorOf([&] { loadData(path, {"a", "z"}); }), {"t.exa", "'z'", "a, b"}));
}

TEST_F(Exa, NonFiniteValuesAreRefusedWithFieldAndCell)
{
    writeScalars(folder_ + "/a.scalars", std::vector<float>{0, 1, 2, 3, 4, INFINITY, 6, 7});
    EXPECT_TRUE(says(loadError(exa("bricks t.bricks scalar a a.scalars")),
                     {"a.scalars", "'a'", "inf", "cell (0,0,2) of brick 1", "voxel (0,0,2)"}));
    EXPECT_TRUE(says(loadError(exa("bricks t.bricks\nscalar b b.scalars\nscalar l expr \"%0 log\"")),
                     {"t.exa:3", "'l'", "-inf", "cell (0,0,0) of brick 0"}));
}

TEST_F(Exa, ValuesThatAnExpressionReplacesMayBeNonFinite)
{
    writeScalars(folder_ + "/a.scalars", std::vector<float>{0, 1, 2, 3, 4, NAN, 6, 7});
    const Model model =
        loadData(exa("bricks t.bricks scalar a a.scalars scalar f expr \"%0 %0 == %0 -1 select\""), {"f"});
    EXPECT_EQ(model.fields[0].values, (std::vector<float>{0, 1, 2, 3, 7, 6, -1, 4}));
}

TEST_F(Exa, IDsOutsideTheScalarsNameBrickAndCell)
{
    writeScalars(folder_ + "/a.scalars", std::vector<float>{0, 1, 2, 3, 4, 5, 6});
    EXPECT_TRUE(says(loadError(exa("bricks t.bricks scalar a a.scalars")),
                     {"t.bricks", "cell ID 7", "cell (0,0,0) of brick 1", "a.scalars", "7 values"}));
}

TEST_F(Exa, ScalarsOfOddSizeAreTruncated)
{
    writeText(folder_ + "/a.scalars", "12345");
    EXPECT_TRUE(says(loadError(exa("bricks t.bricks scalar a a.scalars")), {"a.scalars", "truncated", "5 bytes"}));
    writeText(folder_ + "/a.scalars", "");
    EXPECT_TRUE(says(loadError(exa("bricks t.bricks scalar a a.scalars")), {"a.scalars", "empty"}));
}

TEST_F(Exa, RoundTripsAModel)
{
    Model model;
    for (int i = 0; i < 8; ++i) {
        const vec3i low = 8 * vec3i(i & 1, i >> 1 & 1, i >> 2);
        model.bricks.push_back({low, vec3i(i % 2 ? 8 : 4), i % 2 ? 0 : 1, model.cellCount});
        model.cellCount += model.bricks.back().cellCount();
    }
    model.fields.resize(2);
    model.fields[0].name = "p";
    model.fields[1].name = "q";
    for (std::uint64_t i = 0; i < model.cellCount; ++i) {
        model.fields[0].values.push_back(static_cast<float>(i));
        model.fields[1].values.push_back(static_cast<float>(i) / -7.f);
    }
    const Model back = loadData(writeExa(folder_, "model", model));
    EXPECT_EQ(cellValues(back, 0), cellValues(model, 0));
    EXPECT_EQ(cellValues(back, 1), cellValues(model, 1));
    EXPECT_EQ(back.worldFromVoxel, model.worldFromVoxel);
}

} // namespace
} // namespace brickwall
