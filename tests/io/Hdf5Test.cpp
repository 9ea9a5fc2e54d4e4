// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/Hdf5File.h"
#include "brickwall/tests/io/IoTest.h"
#include "brickwall/tests/oracles/WriteHdf5.h"

#include <atomic>
#include <fstream>
#include <iterator>
#include <thread>

namespace brickwall {
namespace {

using namespace oracles;

class Hdf5 : public testing::Test
{
protected:
    void SetUp() override { path_ = testFolder() + "/some.h5"; }

    std::string path_;
};

std::vector<double> counted(std::size_t count)
{
    std::vector<double> values(count);
    for (std::size_t i = 0; i < count; ++i)
        values[i] = double(i);
    return values;
}

TEST_F(Hdf5, PartsOfADatasetAreReadInAnyTypeOfNumbers)
{
    for (const Hdf5Number type : {Hdf5Number::float32, Hdf5Number::float64, Hdf5Number::int32, Hdf5Number::int64,
                                  Hdf5Number::float32BigEndian}) {
        Hdf5Writer(path_).numbers("a", {4, 3, 5}, counted(60), type, {2, 2, 2});
        const Hdf5Data data = Hdf5File(path_).data("a"); // outlives the file
        EXPECT_EQ(data.shape(), (std::vector<std::uint64_t>{4, 3, 5}));
        EXPECT_EQ(data.numbers(), counted(60));
        const std::uint64_t start[]{1, 2, 0}, count[]{2, 1, 2}, beyond[]{4, 1, 2};
        std::vector<double> values;
        data.read(start, count, values);
        EXPECT_EQ(values, (std::vector<double>{25, 26, 40, 41}));
        EXPECT_TRUE(says(errorOf([&] { data.read(start, beyond, values); }),
                         {"some.h5: /a", "truncated", "(4, 1, 2)", "(1, 2, 0)", "(4, 3, 5)"}));
    }
}

TEST_F(Hdf5, SeveralThreadsMayRead)
{
    Hdf5Writer(path_).numbers("a", {1000}, counted(1000), Hdf5Number::float64, {10});
    const Hdf5File file(path_);
    const Hdf5Data data = file.data("a");
    std::vector<std::thread> threads;
    std::atomic<int> wrong = 0;
    for (std::uint64_t t = 0; t < 8; ++t)
        threads.emplace_back([&, t] {
            for (int round = 0; round < 50; ++round) {
                const std::uint64_t start[]{t * 100}, count[]{100};
                std::vector<double> values;
                data.read(start, count, values);
                wrong += values[7] != double(t * 100 + 7) || file.data("a").size() != 1000;
            }
        });
    for (std::thread& thread : threads)
        thread.join();
    EXPECT_EQ(wrong, 0);
}

TEST_F(Hdf5, LinksAreNotFollowed)
{
    {
        Hdf5Writer file(path_);
        file.softLink("circle", "/circle");
        file.softLink("up", "/");
        file.externalLink("outside", "other.h5", "/a");
    }
    const Hdf5File file(path_);
    EXPECT_TRUE(says(errorOf([&] { file.data("circle"); }), {"some.h5: /circle", "soft link"}));
    EXPECT_TRUE(says(errorOf([&] { file.has("up/up/up/a"); }), {"some.h5: /up/up/up/a", "soft link"}));
    EXPECT_TRUE(says(errorOf([&] { file.data("outside"); }), {"some.h5: /outside", "external link"}));
}

TEST_F(Hdf5, ValuesInOtherFilesAreRefused)
{
    Hdf5Writer(path_).elsewhere("a", {10}, "/etc/hostname");
    EXPECT_TRUE(says(errorOf([&] { Hdf5File(path_).data("a"); }), {"some.h5: /a", "other files"}));
}

TEST_F(Hdf5, MoreValuesThanAreStoredAreRefused)
{
    Hdf5Writer(path_).unwritten("a", {1 << 20, 1 << 20, 1 << 20});
    EXPECT_TRUE(says(errorOf([&] { Hdf5File(path_).data("a"); }), {"some.h5: /a", "only 0 are stored"}));
}

TEST_F(Hdf5, ChunksHoldWhatTheyClaim)
{
    Hdf5Writer(path_).numbers("a", {100}, counted(100), Hdf5Number::float64, {100});
    std::ifstream in(path_, std::ios::binary);
    std::string bytes((std::istreambuf_iterator<char>(in)), {});
    in.close();
    // The layout message: chunked, two axes, the address of the index, the chunk's extent and the size of an element.
    const std::string extents("\x64\0\0\0\x08\0\0\0", 8);
    const std::size_t at = bytes.find(extents);
    ASSERT_NE(at, std::string::npos);
    bytes[at + 3] = 0x10; // 2^28 more
    std::ofstream(path_, std::ios::binary) << bytes;
    EXPECT_TRUE(says(errorOf([&] { Hdf5File(path_).data("a"); }), {"some.h5: /a", "truncated", "chunks"}));
}

TEST_F(Hdf5, TypesAreChecked)
{
    {
        Hdf5Writer file(path_);
        file.texts("t", {2}, {"ab", "c"}, 4);
        file.records("r", {"x", "y"}, {1, 2, 3, 4});
        file.attribute("t", "n", {1.5});
        file.textAttribute("t", "word", "blue");
        file.group("g");
    }
    const Hdf5File file(path_);
    EXPECT_EQ(file.data("t").texts(), (std::vector<std::string>{"ab", "c"}));
    const std::vector<std::string> yx{"y", "x"}, z{"z"};
    EXPECT_EQ(file.data("r").records(yx, 0, 2), (std::vector<std::int32_t>{2, 1, 4, 3}));
    EXPECT_TRUE(says(errorOf([&] { file.data("r").records(z, 0, 2); }), {"/r", "integers z"}));
    EXPECT_TRUE(says(errorOf([&] { file.data("t").records(z, 0, 1); }), {"/t", "integers z"}));
    EXPECT_TRUE(says(errorOf([&] { file.data("t").numbers(); }), {"/t", "expected numbers"}));
    EXPECT_TRUE(says(errorOf([&] { file.data("r").texts(); }), {"/r", "texts of fixed length"}));
    EXPECT_TRUE(says(errorOf([&] { file.data("r").texts("name"); }), {"/r", "'name'"}));
    EXPECT_TRUE(says(errorOf([&] { file.data("g"); }), {"/g", "expected a dataset"}));
    EXPECT_TRUE(says(errorOf([&] { file.integer("t", "n", 0, 9); }), {"'n' of /t", "whole number", "1.5"}));
    EXPECT_TRUE(says(errorOf([&] { file.numbers("t", "word"); }), {"'word' of /t", "expected numbers"}));
    EXPECT_TRUE(says(errorOf([&] { file.text("t", "n"); }), {"'n' of /t", "expected a text"}));
    EXPECT_TRUE(says(errorOf([&] { file.text("t", "m"); }), {"'m' of /t", "found none"}));
    EXPECT_EQ(file.members(""), (std::vector<std::string>{"g", "r", "t"}));
    EXPECT_TRUE(file.members("none").empty());
}

TEST_F(Hdf5, BrokenFilesAreNamedWithTheReason)
{
    std::ofstream(path_) << "\x89HDF\r\n\x1a\n and then nothing of the kind";
    EXPECT_TRUE(looksLikeHdf5(path_));
    EXPECT_TRUE(says(loadError(path_), {"some.h5", "cannot be opened as HDF5: "}));
    Hdf5Writer(path_).numbers("a", {3}, {1, 2, 3});
    EXPECT_TRUE(says(loadError(path_), {"some.h5", "no format", "FLASH", "Chombo", "VTKHDF"}));
}

} // namespace
} // namespace brickwall
