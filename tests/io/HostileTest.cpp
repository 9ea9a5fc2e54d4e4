// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/common/EditFile.h"
#include "brickwall/tests/io/HostileTesting.h"
#include "brickwall/tests/oracles/WriteAmrex.h"
#include "brickwall/tests/oracles/WriteChombo.h"
#include "brickwall/tests/oracles/WriteExa.h"
#include "brickwall/tests/oracles/WriteFlash.h"
#include "brickwall/tests/oracles/WriteHdf5.h"
#include "brickwall/tests/oracles/WriteVtkHdf.h"

#include <filesystem>

namespace brickwall {
namespace {

using namespace oracles;

/// Hostile tables of blocks, format by format: each is answered in one line, within a second and 100 MB.
class Hostile : public testing::Test
{
protected:
    using Boxes = std::vector<std::vector<Box3i>>;

    static std::string file(const std::string& name) { return testFolder() + "/" + name; }

    static std::string amrex(const Boxes& boxes)
    {
        Plotfile3 p;
        p.boxes = boxes;
        p.ratios.assign(boxes.size() - 1, 2);
        writePlotfile(file("plt"), p);
        return file("plt");
    }
    static std::string chombo(const Boxes& boxes)
    {
        Chombo3 c;
        c.boxes = boxes;
        c.ratios.assign(boxes.size() - 1, 2);
        writeChombo(file("c.hdf5"), c);
        return file("c.hdf5");
    }
    static VtkAmr3 vtkData(const Boxes& boxes)
    {
        VtkAmr3 amr;
        amr.boxes = boxes;
        amr.ratios.assign(boxes.size() - 1, 2);
        return amr;
    }
    static std::string vtk(const Boxes& boxes) { return writeVtkAmr(testFolder(), "amr", vtkData(boxes)); }
    static std::string vtkHdf(const Boxes& boxes)
    {
        writeVtkHdf(file("v.vtkhdf"), {vtkData(boxes)});
        return file("v.vtkhdf");
    }
    static std::string flash()
    {
        Flash3 f;
        f.refined = [](int level, const vec3i&) { return level == 1; };
        writeFlash(file("f_hdf5_plt_cnt_0000"), f);
        return file("f_hdf5_plt_cnt_0000");
    }
    static std::string bricks(const std::vector<BrickRecord>& records)
    {
        writeBricks(file("t.bricks"), records);
        return file("t.bricks");
    }
    static std::string text(const std::string& name, const std::string& content)
    {
        writeText(file(name), content);
        return file(name);
    }
    static std::string nrrd(const std::string& sizes, const std::string& more = {})
    {
        return text("n.nrrd",
                    "NRRD0004\ntype: uint8\ndimension: 3\nencoding: raw\nsizes: " + sizes + "\n" + more + "\nxx");
    }

    /// What is said after an edit of a file that was good.
    template <class Edit>
    static std::string after(const std::string& path, const Edit& edit)
    {
        {
            Hdf5Writer writer(path, Hdf5Writer::Mode::edit);
            edit(writer);
        }
        return hostileError(path);
    }
    static std::string after(const std::string& data, const std::string& edited, const std::string& from,
                             const std::string& to)
    {
        editFile(edited, from, to);
        return hostileError(data);
    }

    const Boxes good_{{{{0, 0, 0}, {8, 8, 8}}}, {{{0, 0, 0}, {4, 4, 4}}}};
    const std::vector<std::string> corners_{"lo_i", "lo_j", "lo_k", "hi_i", "hi_j", "hi_k"};
};

TEST_F(Hostile, BlocksThatOverlapAreNamed)
{
    const Boxes boxes{{{{0, 0, 0}, {4, 8, 8}}, {{3, 0, 0}, {8, 8, 8}}}};
    for (const std::string& data : {amrex(boxes), chombo(boxes), vtk(boxes), vtkHdf(boxes)})
        EXPECT_TRUE(says(hostileError(data), {"boxes 0 and 1", "overlap"}));
    EXPECT_TRUE(says(after(flash(),
                           [](Hdf5Writer& file) {
                               file.remove("node type"); // the parent becomes a leaf, too
                               file.numbers("node type", {9}, std::vector<double>(9, 1), Hdf5Number::int32);
                           }),
                     {"leaves that do not overlap"}));
    EXPECT_TRUE(says(hostileError(bricks({{{2, 1, 1}, {0, 0, 0}, 0, {0, 1}}, {{1, 1, 1}, {1, 0, 0}, 0, {2}}})),
                     {"t.bricks", "overlap"}));
    writeCells(file("t.cells"), std::vector<Cell>{{{0, 0, 0}, 1}, {{1, 1, 1}, 0}});
    EXPECT_TRUE(says(hostileError(file("t.cells")), {"t.cells"}));
}

TEST_F(Hostile, NegativeExtentsAreNamed)
{
    EXPECT_TRUE(says(after(amrex(good_), file("plt/Level_1/Cell_H"), "((0,0,0) (3,3,3)", "((0,0,0) (3,-9,3)"),
                     {"Cell_H", "0 to -9 along y"}));
    EXPECT_TRUE(says(after(chombo(good_),
                           [this](Hdf5Writer& file) {
                               file.remove("level_1/boxes");
                               file.records("level_1/boxes", corners_, {0, 0, 0, 3, -9, 3});
                           }),
                     {"/level_1/boxes", "box 0", "(0,0,0) to (3,-9,3)"}));
    const std::string list = vtk(good_);
    EXPECT_TRUE(says(after(list, list, "0 3 0 3 0 3", "0 3 0 -9 0 3"), {"amr.vthb", "0 to -9 along y"}));
    EXPECT_TRUE(says(after(vtkHdf(good_),
                           [](Hdf5Writer& file) {
                               file.remove("VTKHDF/Level1/AMRBox");
                               file.numbers("VTKHDF/Level1/AMRBox", {1, 6}, {0, 3, 0, -9, 0, 3}, Hdf5Number::int32);
                           }),
                     {"/VTKHDF/Level1/AMRBox", "0 to -9 along y"}));
    EXPECT_TRUE(says(after(flash(),
                           [](Hdf5Writer& file) {
                               std::vector<double> faces(9 * 6, 1.0);
                               faces[0] = 2.0;
                               file.remove("bounding box");
                               file.numbers("bounding box", {9, 3, 2}, faces);
                           }),
                     {"/bounding box", "block 0", "2 and 1"}));
    EXPECT_TRUE(says(hostileError(bricks({{{2, -1, 2}, {0, 0, 0}, 0, {0, 1, 2, 3}}})), {"t.bricks", "(2,-1,2)"}));
    EXPECT_TRUE(says(hostileError(nrrd("2 -1 2")), {"n.nrrd:5", "'-1'"}));
}

TEST_F(Hostile, GapsBetweenLevelsAreNamed)
{
    amrex(good_);
    EXPECT_TRUE(
        says(after(file("plt"), file("plt/Header"), "\n1 1 0.25\n", "\n7 1 0.25\n"), {"Header", "level", "'7'"}));
    EXPECT_TRUE(says(after(chombo(good_), [](Hdf5Writer& file) { file.remove("level_1"); }), {"level_1"}));
    const std::string list = vtk(good_);
    EXPECT_TRUE(says(after(list, list, "level=\"1\"", "level=\"7\""), {"amr.vthb", "level 1", "'7'"}));
    EXPECT_TRUE(says(after(vtkHdf(good_), [](Hdf5Writer& file) { file.remove("VTKHDF/Level0"); }), {"VTKHDF/Level0"}));
    EXPECT_TRUE(says(after(flash(),
                           [](Hdf5Writer& file) {
                               file.remove("refine level");
                               file.numbers("refine level", {9}, {1, 2, 2, 2, 2, 2, 2, 2, 60}, Hdf5Number::int32);
                           }),
                     {"/refine level", "2 to 60"}));
    EXPECT_TRUE(says(hostileError(bricks({{{1, 1, 1}, {0, 0, 0}, 0, {0}}, {{1, 1, 1}, {8, 0, 0}, 60, {1}}})),
                     {"t.bricks", "level from 0 to 24", "60"}));
    writeCells(file("t.cells"), std::vector<Cell>{{{0, 0, 0}, 60}});
    EXPECT_TRUE(says(hostileError(file("t.cells")), {"t.cells", "level from 0 to 24", "60"}));
}

TEST_F(Hostile, BillionsOfCellsAreRefusedForWhatIsStored)
{
    EXPECT_TRUE(
        says(after(amrex({{{{0, 0, 0}, {8, 8, 8}}}}), file("plt/Level_0/Cell_H"), "(7,7,7)", "(2047,1023,1023)"),
             {"Cell_H", "truncated", "2147483648"}));
    EXPECT_TRUE(says(after(chombo(good_),
                           [this](Hdf5Writer& file) {
                               file.remove("level_0/boxes");
                               file.records("level_0/boxes", corners_, {0, 0, 0, 2047, 1023, 1023});
                           }),
                     {"c.hdf5: /level_0"}));
    const std::string list = vtk({{{{0, 0, 0}, {8, 8, 8}}}});
    EXPECT_TRUE(
        says(after(list, list, "0 7 0 7 0 7", "0 2047 0 1023 0 1023"), {"amr_0.vti", "truncated", "2147483648 cells"}));
    EXPECT_TRUE(
        says(after(vtkHdf(good_),
                   [](Hdf5Writer& file) {
                       file.remove("VTKHDF/Level0/AMRBox");
                       file.numbers("VTKHDF/Level0/AMRBox", {1, 6}, {0, 2047, 0, 1023, 0, 1023}, Hdf5Number::int32);
                   }),
             {"v.vtkhdf: /VTKHDF/Level0/CellData", "truncated"}));
    EXPECT_TRUE(says(after(flash(),
                           [](Hdf5Writer& file) {
                               file.remove("dens");
                               file.unwritten("dens", {9, 1024, 1024, 2048});
                           }),
                     {"/dens", "truncated"}));
    EXPECT_TRUE(
        says(hostileError(bricks({{{2048, 1024, 1024}, {0, 0, 0}, 0, {0}}})), {"t.bricks", "2048 x 1024 x 1024"}));
    text("t.cells", "x");
    std::filesystem::resize_file(file("t.cells"),
                                 ((std::uintmax_t(1) << 31) + 1) * sizeof(Cell)); // without blocks on disk
    EXPECT_TRUE(says(hostileError(file("t.cells")), {"t.cells", "2^31", "2147483649"}));
    EXPECT_TRUE(says(hostileError(nrrd("2048 1024 1024")), {"n.nrrd", "2147483648 bytes"}));
    EXPECT_TRUE(says(hostileError(text("r_2048x1024x1024_uint8.raw", "xx")), {"2147483648 bytes"}));
}

TEST_F(Hostile, CirclesEnd)
{
    const auto circle = [](const std::string& path) {
        return [path](Hdf5Writer& file) {
            file.remove(path);
            file.softLink(path, "/" + path);
        };
    };
    EXPECT_TRUE(says(after(flash(), circle("bounding box")), {"/bounding box", "soft link"}));
    EXPECT_TRUE(says(after(chombo(good_), circle("level_0/boxes")), {"/level_0/boxes", "soft link"}));
    EXPECT_TRUE(says(after(vtkHdf(good_), circle("VTKHDF/Level0/AMRBox")), {"/VTKHDF/Level0/AMRBox", "soft link"}));
    EXPECT_TRUE(says(after(vtkHdf(good_),
                           [](Hdf5Writer& file) { // a group that holds itself
                               file.remove("VTKHDF/Level0/CellData");
                               file.hardLink("VTKHDF/Level0/CellData", "VTKHDF/Level0");
                           }),
                     {"/VTKHDF/Level0/CellData"}));
    const std::string list = vtk(good_);
    EXPECT_TRUE(says(after(list, list, "amr/amr_0.vti", "amr.vthb"), {"amr.vthb", "ImageData"}));
    bricks({{{1, 1, 1}, {0, 0, 0}, 0, {0}}});
    EXPECT_TRUE(says(hostileError(text("t.exa", "bricks t.bricks scalar a expr \"%0 1 +\"")), {"t.exa:1", "'%0'"}));
    EXPECT_TRUE(says(hostileError(text("t.exa", "bricks t.exa")), {"t.exa: brick record 0"}));
    std::filesystem::create_symlink("a.scalars", file("a.scalars"));
    EXPECT_TRUE(says(hostileError(text("t.exa", "bricks t.bricks scalar a a.scalars")), {"t.exa:1", "a.scalars"}));
}

TEST_F(Hostile, PiecesOutsideTheFolderAreRefused)
{
    for (const std::string outside : {"/etc/passwd", "../plt/Level_0/Cell", "Level_0/../../Cell"}) {
        EXPECT_TRUE(
            says(after(amrex(good_), file("plt/Header"), "Level_0/Cell", outside), {"Header:", "within", outside}));
        EXPECT_TRUE(
            says(after(amrex(good_), file("plt/Level_1/Cell_H"), "FabOnDisk: Cell_D_00000", "FabOnDisk: " + outside),
                 {"Level_1/Cell_H:", "within", outside}));
        const std::string list = vtk(good_);
        EXPECT_TRUE(says(after(list, list, "amr/amr_0.vti", outside), {"amr.vthb", "within", outside}));
    }
}

TEST_F(Hostile, ExternalLinksOfHdf5AreNotFollowed)
{
    const auto outside = [](const std::string& path) {
        return [path](Hdf5Writer& file) {
            file.remove(path);
            file.externalLink(path, "other.h5", "/" + path);
        };
    };
    for (const char* path : {"refine level", "dens"})
        EXPECT_TRUE(says(after(flash(), outside(path)), {path, "external link"}));
    for (const char* path : {"level_0", "level_1/boxes", "level_0/data:datatype=0"})
        EXPECT_TRUE(says(after(chombo(good_), outside(path)), {path, "external link"}));
    for (const char* path : {"VTKHDF/Level0", "VTKHDF/Level1/AMRBox", "VTKHDF/Level0/CellData/density"})
        EXPECT_TRUE(says(after(vtkHdf(good_), outside(path)), {path, "external link"}));
}

} // namespace
} // namespace brickwall
