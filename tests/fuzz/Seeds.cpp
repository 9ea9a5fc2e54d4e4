// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/fuzz/Seeds.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/base/WholeFile.h"
#include "brickwall/core/io/Convert.h"
#include "brickwall/tests/oracles/WriteAmrex.h"
#include "brickwall/tests/oracles/WriteExa.h"
#include "brickwall/tests/oracles/WriteVtk.h"

#include <fmt/format.h>

#include <cstdio>
#include <filesystem>
#include <set>
#include <vector>

namespace brickwall::fuzz {
namespace {

namespace fs = std::filesystem;

double numbered(int, int component, const vec3i& cell)
{
    return 1.0 + component + cell.x + 4 * cell.y + 16 * cell.z;
}

/// The folder's files as the sections of one, `first` before the others (Container.h).
void pack(const std::string& seed, const fs::path& folder, const std::string& first, const std::string& options = {})
{
    std::string bytes = fmt::format("=== {}{}{}\n", first, options.empty() ? "" : " ", options);
    bytes += readWholeFile((folder / first).string());
    std::set<fs::path> others;
    for (const auto& entry : fs::recursive_directory_iterator(folder))
        if (entry.is_regular_file() && entry.path() != folder / first)
            others.insert(entry.path());
    for (const fs::path& file : others)
        bytes += fmt::format("\n=== {}\n{}", fs::relative(file, folder).string(), readWholeFile(file.string()));
    fs::create_directories(fs::path(seed).parent_path());
    writeWholeFile(seed, bytes);
    fs::remove_all(folder);
    fs::create_directories(folder);
}

void writeAmrexSeeds(const std::string& seeds, const std::string& scratch)
{
    oracles::Plotfile3 p;
    p.value = numbered;
    p.domain = {{0, 0, 0}, {4, 2, 2}};
    p.boxes = {{{{0, 0, 0}, {2, 2, 2}}, {{2, 0, 0}, {4, 2, 2}}}};
    p.ratios = {};
    p.oneRatioForAll = false;
    p.components = {"density"};
    oracles::writePlotfile(scratch, p);
    pack(seeds + "/amrex/level", scratch, "Header");
    p.boxes.push_back({{{2, 0, 0}, {4, 4, 2}}});
    p.ratios = {2};
    p.components = {"density", "x velocity"};
    p.ghosts = 1;
    p.floats = p.bigEndian = true;
    oracles::writePlotfile(scratch, p);
    pack(seeds + "/amrex/ghosts", scratch, "Header");
}

void writeExaSeeds(const std::string& seeds, const std::string& scratch)
{
    const auto scalars = [&](const std::string& name) {
        oracles::writeScalars(scratch + name, std::vector<float>{1, 2, 3, 4, 5, 6, 7, 8, 9});
    };
    const auto bricks = [&](int id) {
        oracles::writeBricks(scratch + "/t.bricks",
                             std::vector<oracles::BrickRecord>{{{2, 2, 2}, {0, 0, 0}, 0, {8, 7, 6, 5, 4, 3, 2, 1}},
                                                               {{1, 1, 1}, {2, 0, 0}, 1, {id}}});
    };
    bricks(0);
    scalars("/a.scalars");
    oracles::writeTriangles(scratch + "/t.tris",
                            std::vector<TriangleMesh>{{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}}});
    oracles::writeText(scratch + "/t.exa",
                       "# all keywords\nbricks t.bricks\nscalar a a.scalars\nvalue_range 1 8\n"
                       "vector v a.scalars a.scalars a.scalars\nscalar e expr \"%0 2 * %1 magnitude +\"\n"
                       "triangles t.tris\nremap_from 0 0 0 1 1 1\nremap_to 0 0 0 2 2 2\n");
    pack(seeds + "/exabrick/exa", scratch, "t.exa");
    bricks(-1);
    scalars("/t.scalars");
    pack(seeds + "/exabrick/bricks", scratch, "t.bricks");
    oracles::writeCells(scratch + "/t.cells",
                        std::vector<Cell>{{{0, 0, 0}, 1}, {{2, 0, 0}, 0}, {{3, 0, 0}, 0}, {{2, 0, 0}, 0}});
    scalars("/t.scalars");
    pack(seeds + "/exabrick/cells", scratch, "t.cells");
}

void writeVtkSeeds(const std::string& seeds, const std::string& scratch)
{
    oracles::VtkAmr3 amr;
    amr.value = numbered;
    amr.boxes = {{{{0, 0, 0}, {2, 2, 2}}}, {{{0, 0, 0}, {2, 2, 2}}}};
    amr.ratios = {2};
    using oracles::VtkFormat;
    const auto write = [&](const std::string& name, VtkFormat format, bool compressed) {
        amr.format = format;
        amr.compressed = compressed;
        oracles::writeVtkAmr(scratch, "a", amr);
        pack(seeds + "/vtk/" + name, scratch, "a.vthb");
    };
    write("ascii", VtkFormat::ascii, false);
    write("binary", VtkFormat::binary, false);
    write("raw_zlib", VtkFormat::appendedRaw, true);
    amr.header64 = amr.bigEndian = true;
    amr.arrays = {{"velocity", "Float32", 3}, {"id", "UInt8", 1}};
    write("base64_zlib", VtkFormat::appendedBase64, true);
    amr.version = "1.0";
    write("raw_old", VtkFormat::appendedRaw, false);
}

void writeVolumeSeeds(const std::string& seeds, const std::string& scratch)
{
    const std::string numbers("\1\2\3\4\5\6\7\10\1\1\1\1\1\1\1\1\1\1", 18);
    const std::string head =
        "NRRD0004\n# a comment\ntype: uint8\ndimension: 3\nspace: left-posterior-superior\nsizes: 3 3 2\n"
        "space directions: (1,0,0) (0,1,0) (0,0,2)\nspace origin: (0,0,1)\n";
    oracles::writeText(scratch + "/a.nrrd", head + "encoding: raw\n\n" + numbers);
    pack(seeds + "/volume/attached", scratch, "a.nrrd");
    oracles::writeText(scratch + "/a.nhdr", head + "encoding: raw\nline skip: 1\nbyte skip: 2\ndata file: a.raw\n");
    oracles::writeText(scratch + "/a.raw", "line\n12" + numbers);
    pack(seeds + "/volume/detached", scratch, "a.nhdr", "threshold=0.2");
    const unsigned char packed[] = {0x1f, 0x8b, 8,    0,    0,    0, 0, 0,    2,    3,    0x63, 0x64, 0x62, 0x66, 0x61,
                                    0x65, 0x63, 0xe7, 0x60, 0x84, 3, 0, 0x9c, 0x2d, 0x5a, 0x8b, 18,   0,    0,    0};
    oracles::writeText(scratch + "/a.nrrd",
                       head + "encoding: gzip\n\n" + std::string(reinterpret_cast<const char*>(packed), sizeof packed));
    pack(seeds + "/volume/gzip", scratch, "a.nrrd");
    oracles::writeText(scratch + "/a_3x3x1_uint16.raw", numbers);
    pack(seeds + "/volume/raw", scratch, "a_3x3x1_uint16.raw");
    oracles::writeText(scratch + "/a.raw", numbers);
    pack(seeds + "/volume/options", scratch, "a.raw", "3x3x2:uint8:big:spacing=1x1x2:threshold=0.5");
}

/// Two levels, two fields, a mesh, from ExaBrick data.
void writeCacheSeeds(const std::string& seeds, const std::string& scratch)
{
    Model model;
    model.name = "m";
    model.bricks = {{{0, 0, 0}, {2, 2, 2}, 0, 0}, {{2, 0, 0}, {1, 1, 1}, 1, 8}};
    model.cellCount = 9;
    model.fields = {{"f", "K", std::vector<float>(9, 1.0f), {1, 1}, {}},
                    {"g", "", std::vector<float>(9, 2.0f), {2, 2}, {}}};
    const std::string exa = oracles::writeExa(scratch, "m", model), cache = scratch + "/m.brickwall";
    Progress silent;
    convert(*openDataSet(exa), cache, {}, Executor(1), silent);
    fs::create_directories(seeds + "/cache");
    fs::rename(cache, seeds + "/cache/two_fields");
}

void writeHdf5Seeds(const std::string& seeds)
{
    for (const auto& [format, files] : {std::pair("flash", 2), std::pair("chombo", 3), std::pair("vtkhdf", 4)})
        for (int i = 0; i < files; ++i) {
            fs::create_directories(fmt::format("{}/{}", seeds, format));
            oracles::writeText(fmt::format("{}/{}/valid_{}", seeds, format, i), std::string(1, static_cast<char>(i)));
        }
}

void writeAll(const std::string& seeds)
{
    const std::string scratch = (fs::temp_directory_path() / "brickwall_seeds").string();
    fs::remove_all(scratch);
    fs::create_directories(scratch);
    writeAmrexSeeds(seeds, scratch);
    writeExaSeeds(seeds, scratch);
    writeVtkSeeds(seeds, scratch);
    writeVolumeSeeds(seeds, scratch);
    writeCacheSeeds(seeds, scratch);
    writeHdf5Seeds(seeds);
    fs::create_directories(seeds + "/openvdb");
    writeOpenvdbSeeds(seeds + "/openvdb");
    fs::remove_all(scratch);
}

} // namespace
} // namespace brickwall::fuzz

int main(int count, char** arguments)
{
    if (count != 2) {
        std::fputs("usage: fuzz_seeds FOLDER\n", stderr);
        return 2;
    }
    try {
        brickwall::fuzz::writeAll(arguments[1]);
    } catch (const brickwall::Error& error) {
        std::fprintf(stderr, "%s\n", error.what());
        return 2;
    }
    return 0;
}
