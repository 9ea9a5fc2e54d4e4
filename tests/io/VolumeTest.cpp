// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/io/IoTest.h"
#include "brickwall/tests/oracles/WriteExa.h"

#include <fmt/format.h>
#include <zlib.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <functional>

namespace brickwall {
namespace {

using oracles::writeText;

using VoxelValue = std::function<double(const vec3i& voxel)>;

/// Exact in all types of two bytes, different for every voxel of a small volume.
double numbered(const vec3i& v)
{
    return v.x + 16 * v.y + 256 * v.z;
}

template <class T>
std::string packed(const vec3i& size, const VoxelValue& value, bool bigEndian = false)
{
    std::string bytes;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x) {
                auto raw = std::bit_cast<std::array<char, sizeof(T)>>(static_cast<T>(value({x, y, z})));
                if (bigEndian != (std::endian::native == std::endian::big))
                    std::reverse(raw.begin(), raw.end());
                bytes.append(raw.data(), raw.size());
            }
    return bytes;
}

std::string gzipped(const std::string& bytes)
{
    constexpr int gzipWrapper = 16;
    z_stream stream = {};
    deflateInit2(&stream, 9, Z_DEFLATED, gzipWrapper + MAX_WBITS, 8, Z_DEFAULT_STRATEGY);
    std::string out(deflateBound(&stream, bytes.size()) + 64, '\0');
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(bytes.data()));
    stream.avail_in = static_cast<uInt>(bytes.size());
    stream.next_out = reinterpret_cast<Bytef*>(out.data());
    stream.avail_out = static_cast<uInt>(out.size());
    deflate(&stream, Z_FINISH);
    out.resize(stream.total_out);
    deflateEnd(&stream);
    return out;
}

/// Each voxel a cell of its own.
CellValues voxels(const vec3i& size, const VoxelValue& value)
{
    CellValues cells;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                cells[{x, y, z, 0}] = static_cast<float>(value({x, y, z}));
    return cells;
}

class Volume : public testing::Test
{
protected:
    std::string write(const std::string& name, const std::string& bytes)
    {
        const std::string path = testFolder() + "/" + name;
        writeText(path, bytes);
        return path;
    }

    const vec3i size_{5, 6, 7};
};

using Raw = Volume;
using Nrrd = Volume;

TEST_F(Raw, TheNameSaysSizeAndType)
{
    const std::string path = write("my_cloud_5x6x7_uint16.raw", packed<std::uint16_t>(size_, numbered));
    const auto set = openDataSet(path);
    EXPECT_EQ(set->format(), "raw volume");
    EXPECT_EQ(set->fieldNames(), std::vector<std::string>{"my_cloud"});
    const Model model = loadData(path);
    EXPECT_EQ(cellValues(model), voxels(size_, numbered));
    EXPECT_EQ(worldBounds(model).upper, vec3d(5, 6, 7));
    EXPECT_TRUE(model.notes.empty());
}

TEST_F(Raw, WhatFollowsTheNameSaysItToo)
{
    const std::string path = write("cloud.raw", packed<std::int16_t>(size_, numbered, true));
    EXPECT_EQ(cellValues(loadData(path + ":5x6x7:int16:big")), voxels(size_, numbered));
    EXPECT_EQ(worldBounds(loadData(path + ":spacing=1x2x0.5:int16:5x6x7:big")).upper, vec3d(5, 12, 3.5));
    // before what the name says, and whatever the extension
    const std::string other = write("a_1x2x3_uint8.dat", packed<float>(size_, numbered));
    EXPECT_EQ(cellValues(loadData(other + ":5x6x7:float32")), voxels(size_, numbered));
}

TEST_F(Raw, AllTypesOfNumbersAreRead)
{
    const VoxelValue small = [](const vec3i& v) { return v.x + 5 * v.y + v.z; };
    const auto expectRead = [&](const char* type, const std::string& bytes, bool big) {
        const std::string path = write("volume.raw", bytes) + ":5x6x7:" + type + (big ? ":big" : ":little");
        EXPECT_EQ(cellValues(loadData(path)), voxels(size_, small)) << type;
    };
    for (const bool big : {false, true}) {
        expectRead("int8", packed<std::int8_t>(size_, small), big);
        expectRead("uint8", packed<std::uint8_t>(size_, small), big);
        expectRead("int16", packed<std::int16_t>(size_, small, big), big);
        expectRead("uint16", packed<std::uint16_t>(size_, small, big), big);
        expectRead("int32", packed<std::int32_t>(size_, small, big), big);
        expectRead("uint32", packed<std::uint32_t>(size_, small, big), big);
        expectRead("int64", packed<std::int64_t>(size_, small, big), big);
        expectRead("uint64", packed<std::uint64_t>(size_, small, big), big);
        expectRead("float32", packed<float>(size_, small, big), big);
        expectRead("float64", packed<double>(size_, small, big), big);
    }
}

TEST_F(Raw, WithoutSizeOrTypeItSaysHowToGiveThem)
{
    const std::string path = write("cloud.raw", "12345678");
    EXPECT_TRUE(says(loadError(path), {"cloud.raw", "size and type", "NAME_WxHxD_TYPE.raw", ":256x256x128:uint8"}));
    EXPECT_TRUE(says(loadError(path + ":2x2x2"), {"expected its type"}));
    EXPECT_TRUE(says(loadError(path + ":2x2x2:uint9"), {"'uint9'", "float32"}));
    EXPECT_TRUE(says(loadError(path + ":2x2x2:uint8:threshold=2"), {"threshold", "'2'"}));
    EXPECT_TRUE(says(loadError(path + ":2x2x2:uint8:spacing=1x0x1"), {"spacing", "1x0x1"}));
}

TEST_F(Raw, TheLengthHasToBeThatOfTheNumbers)
{
    const std::string path = write("cloud.raw", "12345678");
    EXPECT_TRUE(says(loadError(path + ":2x2x3:uint8"), {"cloud.raw", "truncated", "12 bytes", "byte 8"}));
    EXPECT_TRUE(says(loadError(path + ":2x2x1:uint8"), {"cloud.raw", "expected 4 bytes", "found 8"}));
    EXPECT_TRUE(says(loadError(path + ":0x2x2:uint8"), {"cloud.raw"}));
    EXPECT_TRUE(says(loadError(path + ":65536x65536x65536:uint8"), {"2^32 cells", "65536 x 65536 x 65536"}));
    EXPECT_TRUE(says(loadError(path + ":99999999999999x2x2:uint8"), {"2^32 cells"}));
}

TEST_F(Raw, OptionsOfOtherFormatsAreErrors)
{
    EXPECT_TRUE(says(loadError(write("a.exa", "x") + ":threshold=1"), {"a.exa", "takes options"}));
    EXPECT_TRUE(
        says(loadError(testFolder() + "/none.raw:1x1x1:uint8"), {"none.raw:1x1x1:uint8", "there is no such file"}));
    // A name with a colon is a name.
    EXPECT_EQ(loadData(write("b:2x2x2:uint8.raw", "12345678") + ":2x2x2:uint8").cellCount, 8u);
}

TEST_F(Raw, ThresholdZeroMergesEqualVoxelsOnly)
{
    // One voxel differs; what is next to it stays fine, what is far becomes coarse, in steps of one level.
    const vec3i size(32, 32, 32), odd(5, 6, 7);
    const VoxelValue value = [&](const vec3i& v) { return v == odd ? 9.0 : 4.0; };
    const Model model = loadData(write("v_32x32x32_uint8.raw", packed<std::uint8_t>(size, value)));
    EXPECT_LT(model.cellCount, 1500u);
    std::uint64_t volumeOfCells = 0;
    for (const auto& [cell, v] : cellValues(model)) {
        const vec3i lower(cell[0], cell[1], cell[2]);
        const int width = 1 << cell[3];
        volumeOfCells += std::uint64_t(width) * width * width;
        EXPECT_EQ(v, lower == odd ? 9.0f : 4.0f);
        // Its tent reaches half its width beyond it, where all has to be as it is.
        const Box3i reach{lower - width / 2, lower + width + width / 2};
        EXPECT_FALSE(cell[3] > 0 && reach.contains(odd)) << lower.x << ' ' << lower.y << ' ' << lower.z << ' ' << width;
    }
    EXPECT_EQ(volumeOfCells, 32u * 32 * 32);
    EXPECT_EQ(cellsPerLevel(model.bricks).size(), 4u);
    EXPECT_TRUE(says(model.notes.at(0), {"32768 voxels", "threshold"}));
}

/// No two cells that touch, also at corners alone, are more than one level apart.
void expectGraded(const Model& model, const vec3i& size)
{
    std::vector<int> level(std::size_t(size.x) * size.y * size.z, -1);
    for (const Brick& b : model.bricks)
        for (int z = b.box().lower.z; z < b.box().upper.z; ++z)
            for (int y = b.box().lower.y; y < b.box().upper.y; ++y)
                for (int x = b.box().lower.x; x < b.box().upper.x; ++x)
                    level[(std::size_t(z) * size.y + y) * size.x + x] = b.level;
    for (int z = 0; z < size.z; ++z)
        for (int y = 0; y < size.y; ++y)
            for (int x = 0; x < size.x; ++x)
                for (int n = 0; n < 27; ++n) {
                    const vec3i p = glm::min(vec3i(x, y, z) + vec3i(n % 3, n / 3 % 3, n / 9), size - 1);
                    ASSERT_LE(std::abs(level[(std::size_t(z) * size.y + y) * size.x + x] -
                                       level[(std::size_t(p.z) * size.y + p.y) * size.x + p.x]),
                              1);
                }
}

TEST_F(Raw, TheThresholdBoundsHowFarAVoxelIsFromItsCell)
{
    const vec3i size(40, 33, 50); // odd ends
    const VoxelValue value = [](const vec3i& v) {
        return 100.0 * std::exp(-0.003 * (v.x * v.x + v.y * v.y + v.z * v.z));
    };
    const std::string path = write("hill_40x33x50_float64.raw", packed<double>(size, value));
    std::uint64_t before = 0;
    for (const double threshold : {0.3, 0.05, 0.001}) {
        const Model model = loadData(fmt::format("{}:threshold={}", path, threshold));
        EXPECT_GT(model.cellCount, before) << threshold;
        before = model.cellCount;
        expectGraded(model, size);
        for (const auto& [cell, v] : cellValues(model)) {
            const int width = 1 << cell[3];
            double sum = 0.0;
            for (int i = 0; i < width * width * width; ++i) {
                const vec3i p(cell[0] + i % width, cell[1] + i / width % width, cell[2] + i / width / width);
                sum += value(p);
                ASSERT_NEAR(value(p), v, threshold * 100.0 + 1e-4);
            }
            ASSERT_NEAR(v, sum / (width * width * width), 1e-4);
        }
    }
    EXPECT_LT(before, 40u * 33 * 50);
}

TEST_F(Raw, ThreadsDoNotMatter)
{
    const vec3i size(40, 33, 50);
    const std::string path =
        write("v_40x33x50_uint8.raw",
              packed<std::uint8_t>(size, [](const vec3i& v) { return (v.x / 9 + v.y / 7 + v.z / 11) % 3; }));
    const Model one = loadData(path, {}, 1), four = loadData(path, {}, 4);
    EXPECT_EQ(one.fields[0].values, four.fields[0].values);
    ASSERT_EQ(one.bricks.size(), four.bricks.size());
    for (std::size_t i = 0; i < one.bricks.size(); ++i)
        EXPECT_EQ(one.bricks[i].box(), four.bricks[i].box());
}

TEST_F(Raw, AConstantVolumeIsOneCellAndAFlatOneVoxels)
{
    EXPECT_EQ(loadData(write("c_16x16x16_uint8.raw", std::string(4096, '\7'))).cellCount, 1u);
    EXPECT_EQ(loadData(write("f_16x16x1_uint8.raw", std::string(256, '\7'))).cellCount, 256u);
    EXPECT_EQ(loadData(write("o_1x1x1_uint8.raw", "\7")).cellCount, 1u);
}

TEST_F(Raw, NonFiniteVoxelsAreNamedOrLeftOut)
{
    const VoxelValue value = [](const vec3i& v) { return v == vec3i(3, 1, 2) ? NAN : 1.0; };
    const std::string path = write("n_8x8x8_float32.raw", packed<float>(vec3i(8), value));
    EXPECT_TRUE(says(loadError(path), {"n_8x8x8_float32.raw", "nan", "'n'", "cell (3,1,2)"}));
    Progress silent;
    const Model model = openDataSet(path)->load(std::vector<std::string>{"n"}, Executor(2), silent, NonFinite::empty);
    std::uint64_t volumeOfCells = 0;
    for (const auto& [cell, v] : cellValues(model))
        volumeOfCells += std::uint64_t(1) << 3 * cell[3];
    EXPECT_EQ(volumeOfCells, 8u * 8 * 8 - 1);
}

std::string nrrdHeader(const std::string& type, const std::string& more = "encoding: raw\nendian: little\n")
{
    return "NRRD0004\n# made by a test\ntype: " + type + "\ndimension: 3\nsizes: 5 6 7\nkey:=value\n" + more;
}

TEST_F(Nrrd, AttachedDataAreRead)
{
    const std::string path = write("a.nrrd", nrrdHeader("short") + "\n" + packed<std::int16_t>(size_, numbered));
    EXPECT_EQ(openDataSet(path)->format(), "NRRD");
    EXPECT_EQ(openDataSet(path)->fieldNames(), std::vector<std::string>{"a"});
    EXPECT_EQ(cellValues(loadData(path)), voxels(size_, numbered));
    const std::string big = write("b.nrrd", nrrdHeader("unsigned short", "encoding: raw\nendian: big\n") + "\n" +
                                                packed<std::uint16_t>(size_, numbered, true));
    EXPECT_EQ(cellValues(loadData(big)), voxels(size_, numbered));
}

TEST_F(Nrrd, GzipDataAreUnpacked)
{
    const std::string data = packed<double>(size_, numbered);
    const std::string path =
        write("a.nrrd", nrrdHeader("double", "encoding: gzip\nendian: little\n") + "\n" + gzipped(data));
    EXPECT_EQ(cellValues(loadData(path)), voxels(size_, numbered));
    const std::string skipped = write("b.nrrd", nrrdHeader("double", "encoding: gz\nendian: little\nbyte skip: 3\n") +
                                                    "\n" + gzipped("abc" + data));
    EXPECT_EQ(cellValues(loadData(skipped)), voxels(size_, numbered));
}

TEST_F(Nrrd, DetachedDataAreRead)
{
    const std::string data = packed<float>(size_, numbered);
    write("data.bin", "two\nlines\nxx" + data);
    write("data.gz", gzipped(data));
    const std::string lines = write("a.nhdr", nrrdHeader("float", "endian: little\nencoding: raw\ndata file: data.bin\n"
                                                                  "line skip: 2\nbyte skip: 2\n"));
    EXPECT_EQ(cellValues(loadData(lines)), voxels(size_, numbered));
    const std::string end = write("b.nhdr", nrrdHeader("float", "endian: little\nencoding: raw\nbyteskip: -1\n"
                                                                "datafile: ./data.bin\n"));
    EXPECT_EQ(cellValues(loadData(end)), voxels(size_, numbered));
    const std::string packedFile = write(
        "c.nhdr", nrrdHeader("float", "endian: little\nencoding: gzip\ndata file: " + testFolder() + "/data.gz\n"));
    EXPECT_EQ(cellValues(loadData(packedFile)), voxels(size_, numbered));
}

TEST_F(Nrrd, SpacingsAndDirectionsPlaceTheVolume)
{
    const std::string data = "\n" + packed<std::uint8_t>(size_, [](const vec3i&) { return 1; });
    const auto bounds = [&](const std::string& more) {
        return worldBounds(loadData(write("a.nrrd", nrrdHeader("uchar", "encoding: raw\n" + more) + data)));
    };
    EXPECT_EQ(bounds("").upper, vec3d(5, 6, 7));
    EXPECT_EQ(bounds("spacings: 1 0.5 nan\n").upper, vec3d(5, 3, 7));
    EXPECT_EQ(bounds("spacings: 2 2 2\naxis mins: 1 2 nan\n").lower, vec3d(1, 2, 0));
    EXPECT_EQ(bounds("spacings: 2 2 2\naxismins: 1 2 3\ncenterings: node cell node\n").lower, vec3d(0, 2, 2));
    const Box3d turned = bounds("space: left-posterior-superior\nspace directions: (0,2,0) (1,0,0) (0,0,-1)\n"
                                "space origin: (10,20,30)\n");
    EXPECT_EQ(turned.lower, vec3d(9.5, 19, 23.5));
    EXPECT_EQ(turned.upper, vec3d(15.5, 29, 30.5));
}

TEST_F(Nrrd, TheThresholdFollowsTheName)
{
    const std::string path = write("c.nrrd", nrrdHeader("uchar", "encoding: raw\n") + "\n" +
                                                 packed<std::uint8_t>(size_, [](const vec3i& v) { return v.x; }));
    EXPECT_EQ(loadData(path).cellCount, 5u * 6 * 7);
    EXPECT_LT(loadData(path + ":threshold=1").cellCount, 5u * 6 * 7);
    EXPECT_TRUE(says(loadError(path + ":5x6x7"), {"c.nrrd", "threshold=T", "'5x6x7'"}));
}

TEST_F(Nrrd, WhatIsMissingOrUnknownIsNamed)
{
    const auto error = [&](const std::string& from, const std::string& to) {
        std::string header = nrrdHeader("short");
        const auto at = header.find(from);
        EXPECT_NE(at, std::string::npos);
        return loadError(
            write("e.nrrd", header.replace(at, from.size(), to) + "\n" + packed<std::int16_t>(size_, numbered)));
    };
    EXPECT_TRUE(says(error("type: short\n", ""), {"e.nrrd", "'type'"}));
    EXPECT_TRUE(says(error("dimension: 3\n", ""), {"e.nrrd", "'dimension'"})); // was looked up to name its line
    EXPECT_TRUE(says(error("short", "block"), {"e.nrrd:3", "'block'"}));
    EXPECT_TRUE(says(error("dimension: 3", "dimension: 4"), {"e.nrrd:4", "three dimensions", "4"}));
    EXPECT_TRUE(says(error("5 6 7", "5 6"), {"e.nrrd:5", "a size"}));
    EXPECT_TRUE(says(error("5 6 7", "5 -6 7"), {"e.nrrd:5", "'-6'"}));
    EXPECT_TRUE(says(error("encoding: raw", "encoding: bzip2"), {"e.nrrd:7", "'bzip2'"}));
    EXPECT_TRUE(says(error("endian: little\n", ""), {"e.nrrd", "'endian'"}));
    EXPECT_TRUE(says(error("endian: little", "endian: middle"), {"e.nrrd:8", "'middle'"}));
    EXPECT_TRUE(says(error("key:=value", "nonsense"), {"e.nrrd:6", "no colon"}));
    EXPECT_TRUE(says(error("key:=value", "data file: LIST"), {"e.nrrd:6", "one data file", "LIST"}));
    EXPECT_TRUE(says(error("key:=value", "data file: none.raw"), {"none.raw", "cannot be opened"}));
    EXPECT_TRUE(says(error("key:=value", "space directions: none (1,0,0) (0,1,0)"), {"e.nrrd:6", "vector", "'none'"}));
    EXPECT_TRUE(says(loadError(write("h.nrrd", nrrdHeader("short"))), {"h.nrrd", "empty line", "data file"}));
}

TEST_F(Nrrd, TruncationIsNoticed)
{
    const std::string data = packed<std::int16_t>(size_, numbered);
    EXPECT_TRUE(says(loadError(write("a.nrrd", nrrdHeader("short") + "\n" + data.substr(2))), {"a.nrrd", "truncated"}));
    const std::string head = nrrdHeader("short", "encoding: gzip\nendian: little\n") + "\n", all = gzipped(data);
    EXPECT_TRUE(
        says(loadError(write("b.nrrd", head + all.substr(0, all.size() / 2))), {"b.nrrd", "truncated", "gzip"}));
    EXPECT_TRUE(says(loadError(write("c.nrrd", head + gzipped(data.substr(2)))), {"c.nrrd", "end after 418 bytes"}));
    EXPECT_TRUE(says(loadError(write("d.nrrd", head + "no gzip at all")), {"d.nrrd", "gzip data are broken"}));
    // a few bytes that claim to be 2^30 numbers
    std::string huge = head;
    huge.replace(huge.find("5 6 7"), 5, "1024 1024 1024");
    EXPECT_TRUE(says(loadError(write("e.nrrd", huge + all)), {"e.nrrd", "truncated", "1024 x 1024 x 1024"}));
}

} // namespace
} // namespace brickwall
