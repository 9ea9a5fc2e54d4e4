// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/common/EditFile.h"
#include "brickwall/tests/io/LevelCells.h"
#include "brickwall/tests/oracles/WriteExa.h"
#include "brickwall/tests/oracles/WriteVtk.h"

#include <cmath>
#include <fstream>
#include <iterator>
#include <numeric>

namespace brickwall {
namespace {

using namespace oracles;

/// Small enough for any type of numbers.
double small(int level, int component, const vec3i& c)
{
    return level * 40 + component * 10 + c.x % 3 + 3 * (c.y % 3);
}

/// Three levels of ratios 2 and 4; those of level 1 are together whole cells of level 0, but not each.
VtkAmr3 threeLevels()
{
    VtkAmr3 amr;
    amr.arrays = {{"density", "Float64", 1}, {"velocity", "Float32", 3}};
    amr.ratios = {2, 4};
    amr.boxes = {{{{0, 0, 0}, {8, 8, 4}}, {{0, 0, 4}, {8, 8, 8}}},
                 {{{2, 2, 2}, {5, 8, 8}}, {{5, 2, 2}, {12, 8, 8}}},
                 {{{8, 12, 8}, {16, 24, 16}}}};
    amr.origin = {1, 2, 3};
    amr.spacing = {0.5, 0.25, 1};
    amr.value = numbered;
    return amr;
}

/// What a model has to hold, in float; component 3 is the magnitude.
CellValues expected(const VtkAmr3& amr, int component)
{
    return leafCells(amr.boxes, amr.ratios, [&](int level, const vec3i& cell) {
        const auto v = [&](int k) { return amr.value(level, k, cell); };
        return component < 3 ? v(component) : std::sqrt(v(0) * v(0) + v(1) * v(1) + v(2) * v(2));
    });
}

class Vtk : public testing::Test
{
protected:
    void SetUp() override { folder_ = testFolder(); }

    void write(const VtkAmr3& amr) { path_ = writeVtkAmr(folder_, "amr", amr); }

    void edit(const std::string& file, const std::string& from, const std::string& to)
    {
        editFile(folder_ + "/" + file, from, to);
    }
    std::string errorAfter(const std::string& file, const std::string& from, const std::string& to)
    {
        write(threeLevels());
        edit(file, from, to);
        return loadError(path_);
    }

    std::string folder_, path_;
};

TEST_F(Vtk, EveryUncoveredCellHasItsValue)
{
    const VtkAmr3 amr = threeLevels();
    write(amr);
    const auto set = openDataSet(path_);
    EXPECT_EQ(set->format(), "VTK overlapping AMR");
    EXPECT_EQ(set->fieldNames(),
              (std::vector<std::string>{"density", "velocity_x", "velocity_y", "velocity_z", "velocity_magnitude"}));
    EXPECT_EQ(set->defaultField(), "density");
    const Model model = loadData(path_);
    EXPECT_EQ(cellValues(model, 0), expected(amr, 0));
    EXPECT_EQ(cellValues(model, 2), expected(amr, 1));
    EXPECT_EQ(cellValues(model, 4), expected(amr, 3));
    ASSERT_EQ(model.notes.size(), 1u);
    EXPECT_TRUE(says(model.notes[0], {"finer levels cover"}));
}

TEST_F(Vtk, AllEncodingsHoldTheSame)
{
    VtkAmr3 amr = threeLevels();
    const CellValues density = expected(amr, 0), y = expected(amr, 1);
    for (const auto format : {VtkFormat::ascii, VtkFormat::binary, VtkFormat::appendedRaw, VtkFormat::appendedBase64})
        for (const int flags : {0, 1, 2, 3, 4, 5, 6, 7}) {
            amr.format = format;
            amr.compressed = flags & 1;
            amr.header64 = flags & 2;
            amr.bigEndian = flags & 4;
            write(amr);
            const Model model = loadData(path_, {"density", "velocity_y"});
            EXPECT_EQ(cellValues(model, 0), density) << int(format) << ' ' << flags;
            EXPECT_EQ(cellValues(model, 1), y) << int(format) << ' ' << flags;
        }
}

TEST_F(Vtk, AllTypesOfNumbersAreRead)
{
    VtkAmr3 amr = threeLevels();
    amr.value = small;
    for (const char* type :
         {"Int8", "UInt8", "Int16", "UInt16", "Int32", "UInt32", "Int64", "UInt64", "Float32", "Float64"}) {
        amr.arrays = {{"n", type, 1}};
        for (const bool compressed : {false, true}) {
            amr.compressed = compressed;
            amr.bigEndian = !compressed;
            write(amr);
            EXPECT_EQ(cellValues(loadData(path_)), expected(amr, 0)) << type;
        }
    }
}

TEST_F(Vtk, WholeBlocksHaveNoPartialOne)
{
    VtkAmr3 amr;
    amr.value = numbered;
    amr.compressed = true;
    amr.blockBytes = 8 * 8 * 8; // an eighth of the piece
    write(amr);
    EXPECT_EQ(cellValues(loadData(path_)), expected(amr, 0));
}

TEST_F(Vtk, TheOlderListSaysRatiosAndPiecesSayWhere)
{
    VtkAmr3 amr = threeLevels();
    amr.version = "1.0";
    write(amr);
    const Model model = loadData(path_);
    EXPECT_EQ(cellValues(model, 0), expected(amr, 0));
    EXPECT_EQ(worldBounds(model).lower, vec3d(1, 2, 3));
    EXPECT_EQ(worldBounds(model).upper, vec3d(5, 4, 11));
}

TEST_F(Vtk, VoxelsAreTheFinestIndices)
{
    VtkAmr3 amr = threeLevels();
    for (auto& level : amr.boxes)
        for (Box3i& b : level) {
            const int shift = &level == &amr.boxes[0] ? -4 : &level == &amr.boxes[1] ? -8 : -32;
            b = {b.lower + shift, b.upper + shift};
        }
    write(amr);
    const Model model = loadData(path_, {"density"});
    EXPECT_EQ(voxelBounds(model.bricks).lower, vec3i(-32));
    const vec3d corner = transformPoint(model.worldFromVoxel, vec3d(0.0));
    const vec3d next = transformPoint(model.worldFromVoxel, vec3d(1.0));
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(corner[axis], vec3d(1, 2, 3)[axis], 1e-12);
        EXPECT_NEAR(next[axis] - corner[axis], vec3d(0.0625, 0.03125, 0.125)[axis], 1e-12);
    }
}

TEST_F(Vtk, ThreadsDoNotMatter)
{
    write(threeLevels());
    const Model one = loadData(path_, {}, 1), four = loadData(path_, {}, 4);
    EXPECT_EQ(one.fields[4].values, four.fields[4].values);
}

TEST_F(Vtk, ABoxWithoutAFileIsAHole)
{
    const VtkAmr3 amr = threeLevels();
    write(amr);
    edit("amr.vthb", "file=\"amr/amr_1.vti\"", "");
    EXPECT_EQ(cellValues(loadData(path_, {"density"})).size(), expected(amr, 0).size() - 8 * 8 * 4);
}

TEST_F(Vtk, NonFiniteValuesNameFileFieldAndCell)
{
    VtkAmr3 amr = threeLevels();
    amr.value = [](int level, int, const vec3i& c) { return level == 0 && c == vec3i(7, 7, 7) ? INFINITY : 1.0; };
    for (const auto format : {VtkFormat::ascii, VtkFormat::appendedRaw}) {
        amr.format = format;
        write(amr);
        EXPECT_TRUE(says(loadError(path_), {"amr/amr_1.vti", "'density'", "inf", "cell (7,7,7)"}));
        Progress silent;
        const Model model =
            openDataSet(path_)->load(std::vector<std::string>{"density"}, Executor(2), silent, NonFinite::empty);
        EXPECT_EQ(model.cellCount, expected(amr, 0).size() - 1);
    }
}

TEST_F(Vtk, BoxesThatCoverCoarseCellsInPartAreNamed)
{
    VtkAmr3 amr = threeLevels();
    amr.boxes[1].pop_back();
    amr.boxes.pop_back();
    amr.ratios.pop_back();
    write(amr);
    EXPECT_TRUE(says(loadError(path_), {"amr.vthb: level 1", "box 0", "misaligned"}));
}

TEST_F(Vtk, OverlapsAreNamed)
{
    VtkAmr3 amr = threeLevels();
    amr.boxes[0][1].lower.z = 3;
    write(amr);
    EXPECT_TRUE(says(loadError(path_), {"amr.vthb: level 0", "boxes 0 and 1", "overlap"}));
}

TEST_F(Vtk, TheListHasToMakeSense)
{
    EXPECT_TRUE(
        says(errorAfter("amr.vthb", "amr_box=\"0 7", "amr_box=\"7 0"), {"amr.vthb", "level 0, box 0", "7 to 0"}));
    EXPECT_TRUE(
        says(errorAfter("amr.vthb", "amr_box=\"0 7 0 7 0 3\"", "amr_box=\"0 7 0 7\""), {"amr.vthb", "amr_box", "six"}));
    EXPECT_TRUE(says(errorAfter("amr.vthb", "amr_box=\"0 7", "amr_box=\"0 1073741823"), {"amr.vthb", "1073741823"}));
    EXPECT_TRUE(says(errorAfter("amr.vthb", "amr_box=\"0 7", "amr_box=\"0 99999999999"), {"amr.vthb", "99999999999"}));
    EXPECT_TRUE(says(errorAfter("amr.vthb", "level=\"1\"", "level=\"2\""), {"amr.vthb", "level 1", "'2'"}));
    EXPECT_TRUE(
        says(errorAfter("amr.vthb", "spacing=\"0.25 ", "spacing=\"0.2 "), {"amr.vthb", "ratio", "levels 0 and 1"}));
    EXPECT_TRUE(says(errorAfter("amr.vthb", "\"XYZ\"", "\"XY\""), {"amr.vthb", "three dimensions", "'XY'"}));
    EXPECT_TRUE(says(errorAfter("amr.vthb", "</vtkOverlappingAMR>", ""), {"amr.vthb", "byte", "broken XML"}));
}

TEST_F(Vtk, RatiosHaveToBePowersOfTwo)
{
    VtkAmr3 amr = threeLevels();
    amr.ratios = {3, 4};
    amr.boxes[1] = {{{3, 3, 3}, {9, 9, 9}}};
    amr.boxes[2] = {{{16, 16, 16}, {20, 20, 20}}};
    write(amr);
    EXPECT_TRUE(says(loadError(path_), {"amr.vthb", "power of two", "found 3"}));
}

TEST_F(Vtk, PiecesStayInTheFolder)
{
    for (const std::string outside : {"/etc/passwd", "../amr_0.vti", "amr/../../amr_0.vti"})
        EXPECT_TRUE(says(errorAfter("amr.vthb", "amr/amr_0.vti", outside), {"amr.vthb", "within the folder", outside}));
    // What a link leads to is its owner's business.
    write(threeLevels());
    std::filesystem::rename(folder_ + "/amr", folder_ + "/elsewhere");
    std::filesystem::create_directory_symlink(folder_ + "/elsewhere", folder_ + "/amr");
    EXPECT_NO_THROW(loadData(path_));
}

TEST_F(Vtk, APieceHasToBeThereAndImageData)
{
    EXPECT_TRUE(says(errorAfter("amr.vthb", "amr/amr_3.vti", "amr/amr_33.vti"), {"amr_33.vti", "cannot be opened"}));
    // a list that names itself
    EXPECT_TRUE(
        says(errorAfter("amr.vthb", "amr/amr_0.vti", "amr.vthb"), {"amr.vthb", "ImageData", "vtkOverlappingAMR"}));
    EXPECT_TRUE(says(errorAfter("amr/amr_2.vti", "<Piece Extent=\"0 3", "<Piece Extent=\"0 4"),
                     {"amr_2.vti", "expected 3 x 6 x 6", "4 x 6 x 6"}));
    EXPECT_TRUE(
        says(errorAfter("amr/amr_2.vti", "<Piece Extent=\"0 ", "<Piece Extent=\"-1073741824 "),
             {"amr_2.vti", "six indices", "-1073741824"})); // an extent that no int can hold, with the same above
    EXPECT_TRUE(says(errorAfter("amr/amr_0.vti", "Origin=\"1 ", "Origin=\"1.5 "), {"amr_0.vti", "begin at 1", "1.5"}));
}

TEST_F(Vtk, EveryPieceHasEveryArray)
{
    EXPECT_TRUE(says(errorAfter("amr/amr_3.vti", "Name=\"density\"", "Name=\"rho\""),
                     {"amr_3.vti", "'density'", "rho, velocity"}));
    EXPECT_TRUE(says(errorAfter("amr/amr_3.vti", "Components=\"3\"", "Components=\"2\""),
                     {"amr_3.vti", "'velocity'", "3 components", "found 2"}));
    EXPECT_TRUE(says(errorAfter("amr/amr_3.vti", "Float64", "String"), {"amr_3.vti", "'density'", "'String'"}));
    EXPECT_TRUE(says(errorAfter("amr/amr_3.vti", "Float64", "Float32"), {"amr_3.vti", "bytes"}));
}

TEST_F(Vtk, UnknownFieldsAreErrors)
{
    write(threeLevels());
    EXPECT_TRUE(
        says(errorOf([&] { loadData(path_, {"vorticity"}); }), {"amr.vthb", "'vorticity'", "velocity_magnitude"}));
}

TEST_F(Vtk, BrokenAppendedDataAreNoticed)
{
    EXPECT_TRUE(says(errorAfter("amr/amr_3.vti", "offset=\"0\"", "offset=\"8\""), {"amr_3.vti", "'density'", "bytes"}));
    EXPECT_TRUE(says(errorAfter("amr/amr_3.vti", "offset=\"0\"", "offset=\"99999999\""), {"amr_3.vti", "truncated"}));
    EXPECT_TRUE(says(errorAfter("amr/amr_3.vti", "offset=\"0\"", "offset=\"-1\""), {"amr_3.vti", "offset", "'-1'"}));
    EXPECT_TRUE(says(errorAfter("amr/amr_3.vti", "encoding=\"raw\"", "encoding=\"hex\""), {"amr_3.vti", "'hex'"}));
    EXPECT_TRUE(says(errorAfter("amr/amr_3.vti", "LittleEndian", "PDP"), {"amr_3.vti", "byte_order", "'PDP'"}));
    EXPECT_TRUE(says(errorAfter("amr/amr_3.vti", " byte_order", " compressor=\"vtkLZ4DataCompressor\" byte_order"),
                     {"amr_3.vti", "vtkZLibDataCompressor", "vtkLZ4"}));
    EXPECT_TRUE(says(errorAfter("amr/amr_3.vti", " byte_order", " header_type=\"UInt16\" byte_order"),
                     {"amr_3.vti", "UInt64", "'UInt16'"}));
}

TEST_F(Vtk, TruncationIsNoticed)
{
    VtkAmr3 amr = threeLevels();
    for (const auto format : {VtkFormat::ascii, VtkFormat::binary, VtkFormat::appendedRaw, VtkFormat::appendedBase64})
        for (const bool compressed : {false, true}) {
            amr.format = format;
            amr.compressed = compressed;
            write(amr);
            const std::string piece = folder_ + "/amr/amr_3.vti";
            const auto size = std::filesystem::file_size(piece);
            std::string message;
            for (const double part : {0.1, 0.5, 0.8}) {
                std::filesystem::resize_file(piece, static_cast<std::uintmax_t>(part * double(size)));
                EXPECT_TRUE(says(loadError(path_), {"amr_3.vti"})) << int(format) << compressed << part;
                write(amr);
            }
        }
}

TEST_F(Vtk, CompressedBlocksHaveToUnpackToTheirSizes)
{
    VtkAmr3 amr;
    amr.value = numbered;
    amr.compressed = true;
    amr.format = VtkFormat::appendedRaw;
    write(amr);
    std::fstream file(folder_ + "/amr/amr_0.vti", std::ios::in | std::ios::out | std::ios::binary);
    std::string text((std::istreambuf_iterator<char>(file)), {});
    const auto data = static_cast<std::streamoff>(text.find("\n_") + 2);
    const auto put = [&](std::streamoff at, std::uint32_t n) {
        file.clear();
        file.seekp(data + at);
        file.write(reinterpret_cast<const char*>(&n), 4);
        file.flush();
    };
    put(60, 0xffffffffu);
    EXPECT_TRUE(says(loadError(path_), {"amr_0.vti", "'density'", "block 0 is broken"}));
    put(12, 0xfffffffu);
    EXPECT_TRUE(says(loadError(path_), {"amr_0.vti", "truncated"}));
    put(0, 0x7fffffffu);
    EXPECT_TRUE(says(loadError(path_), {"amr_0.vti", "2147483647 blocks"}));
}

TEST_F(Vtk, TextThatIsNoNumberIsNamed)
{
    VtkAmr3 amr = threeLevels();
    amr.format = VtkFormat::ascii;
    write(amr);
    edit("amr/amr_3.vti", " 1003285", " 10o3285");
    EXPECT_TRUE(says(loadError(path_), {"amr_3.vti", "'density'", "number 0", "10o3285"}));
    amr.format = VtkFormat::binary;
    write(amr);
    edit("amr/amr_3.vti", "format=\"binary\">\n  ", "format=\"binary\">\n  !");
    EXPECT_TRUE(says(loadError(path_), {"amr_3.vti", "'density'", "base64", "'!'"}));
}

TEST_F(Vtk, OtherVtkFilesAreNamed)
{
    write(threeLevels());
    EXPECT_TRUE(says(loadError(folder_ + "/amr/amr_0.vti"), {"amr_0.vti", "'ImageData'", ".vthb"}));
    writeText(folder_ + "/page.xml", "<html><VTKFile type=\"vtkOverlappingAMR\"></html>");
    EXPECT_TRUE(says(loadError(folder_ + "/page.xml"), {"no format"}));
}

/// Written by VTK itself.
class RealVtk : public testing::TestWithParam<const char*>
{
};

TEST_P(RealVtk, HasTheCellsAndSumsThatVtkReads)
{
    const std::string path = BRICKWALL_SOURCE_DIR "/../shared/data/vtk/" + std::string(GetParam());
    if (!std::filesystem::exists(path))
        GTEST_SKIP() << "no sample data: " << path;
    const Model model = loadData(path, {"TestX", "VectorXYZ_magnitude", "Depth"});
    EXPECT_EQ(cellsPerLevel(model.bricks), (std::vector<std::uint64_t>{864, 1260, 117}));
    EXPECT_EQ(model.cellCount, 2241u);
    const auto sum = [&](std::size_t field) {
        return std::accumulate(model.fields[field].values.begin(), model.fields[field].values.end(), 0.0);
    };
    EXPECT_NEAR(sum(0), -5331.750033169985, 1e-4); // of doubles, ours are floats
    EXPECT_FLOAT_EQ(model.fields[0].range.lo, -2.89583333581686f);
    EXPECT_FLOAT_EQ(model.fields[0].range.hi, -0.08333340287208557f);
    EXPECT_NEAR(sum(1), 3913.4440, 1e-3);
    EXPECT_EQ(sum(2), 5229.0);
    EXPECT_EQ(model.fields[2].range, (Range{1, 3}));
    EXPECT_EQ(voxelBounds(model.bricks), (Box3i{{0, 0, 0}, {32, 24, 24}}));
    for (int axis = 0; axis < 3; ++axis) {
        EXPECT_NEAR(worldBounds(model).lower[axis], vec3d(-1.75, -1.25, 0)[axis], 1e-12);
        EXPECT_NEAR(worldBounds(model).upper[axis], vec3d(-1.75 + 8 * 0.41666666, 1.25, 2)[axis], 1e-6);
    }
}

INSTANTIATE_TEST_SUITE_P(Versions, RealVtk,
                         testing::Values("HierarchicalBoxDataset.v1.0.vthb", "HierarchicalBoxDataset.v1.1.vthb"));

} // namespace
} // namespace brickwall
