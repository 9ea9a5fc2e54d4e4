// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/WholeFile.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/tests/common/ScratchFolder.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <iterator>
#include <thread>

#include <sys/stat.h>

namespace brickwall {
namespace {

TEST(WholeFile, IsReadAsItWasWritten)
{
    const std::string path = test::scratchFile("file");
    for (const std::string& bytes : {std::string("old and longer"), std::string("a\0\r\n\xff", 5), std::string()}) {
        writeWholeFile(path, bytes);
        EXPECT_EQ(readWholeFile(path), bytes);
    }
}

TEST(WholeFile, FailureLeavesTheOldFileAndNothingElse)
{
    EXPECT_THROW(writeWholeFile("/no/such/folder/file", "x"), Error);
    EXPECT_THROW(readWholeFile("/no/such/folder/file"), Error);
    const std::string folder = test::scratchFile("folder");
    std::filesystem::create_directories(folder + "/taken/inside");
    EXPECT_THROW(writeWholeFile(folder + "/taken", "x"), Error); // a folder cannot be replaced
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder), {}), 1);
}

TEST(WholeFile, DevicesAndLinksAreWrittenToAndNotReplaced)
{
    const std::string pipe = test::scratchFile("pipe");
    std::filesystem::remove(pipe);
    ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
    std::thread reader([&] { EXPECT_EQ(readWholeFile(pipe), "into the pipe"); });
    writeWholeFile(pipe, "into the pipe");
    reader.join();
    EXPECT_TRUE(std::filesystem::is_fifo(pipe));

    const std::string file = test::scratchFile("target"), link = test::scratchFile("link");
    std::filesystem::remove(link);
    std::filesystem::create_symlink(file, link);
    writeWholeFile(link, "through the link");
    EXPECT_TRUE(std::filesystem::is_symlink(link));
    EXPECT_EQ(readWholeFile(file), "through the link");
}

} // namespace
} // namespace brickwall
