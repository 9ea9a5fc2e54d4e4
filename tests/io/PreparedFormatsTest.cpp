// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "PreparedTesting.h"

namespace brickwall {
namespace {

using namespace prepared_test;

/// What each format is read from: its files, of which `part` is one.
class PreparedFormats : public Prepared
{
protected:
    void expectKept(const std::string& name, const std::string& part)
    {
        SCOPED_TRACE(name);
        data = name;
        request = {data, {}, {openDataSet(data)->defaultField()}};
        const PreparedVolume first = prepare(), second = prepare();
        EXPECT_FALSE(first.fromCache);
        EXPECT_TRUE(second.fromCache);
        expectSameVolume(first, second);
        std::filesystem::last_write_time(part, std::filesystem::last_write_time(part) + std::chrono::seconds(1));
        EXPECT_FALSE(prepare().fromCache) << part << " has changed";
    }

    std::string converted(const std::string& name)
    {
        Progress silent;
        const std::string destination = testFolder() + "/" + name;
        convert(*openDataSet(data), destination, {}, Executor(2), silent);
        return destination;
    }

    std::string written(const std::string& name, const std::string& bytes)
    {
        oracles::writeText(testFolder() + "/" + name, bytes);
        return testFolder() + "/" + name;
    }
};

TEST_F(PreparedFormats, OpenVdb)
{
    const std::string path = converted("t.vdb");
    expectKept(path, path);
}

TEST_F(PreparedFormats, VtkAmrAndEveryPieceOfIt)
{
    const std::string path = converted("t.vthb");
    std::string piece;
    for (const auto& entry : std::filesystem::recursive_directory_iterator(testFolder()))
        if (entry.path().extension() == ".vti")
            piece = std::max(piece, entry.path().string());
    ASSERT_NE(piece, "");
    expectKept(path, piece);
}

TEST_F(PreparedFormats, OurOwn)
{
    const std::string path = converted("t.brickwall");
    expectKept(path, path);
}

TEST_F(PreparedFormats, RawNumbersWhateverTheirNameSays)
{
    std::string bytes(512, '\1');
    bytes[77] = '\7';
    const std::string path = written("n.raw", bytes);
    expectKept(path + ":8x8x8:uint8", path);
    expectKept(path + ":8x16x4:uint8", path);
}

TEST_F(PreparedFormats, NrrdAndTheFileWithItsNumbers)
{
    const std::string numbers = written("n.bin", std::string(511, '\1') + '\7');
    const std::string head = "NRRD0004\ntype: uint8\ndimension: 3\nsizes: 8 8 8\nencoding: raw\n";
    expectKept(written("n.nhdr", head + "data file: n.bin\n"), numbers);
    const std::string attached = written("a.nrrd", head + "\n" + std::string(511, '\1') + '\7');
    expectKept(attached, attached);
}

} // namespace
} // namespace brickwall
