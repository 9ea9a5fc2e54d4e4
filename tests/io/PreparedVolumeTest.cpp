// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "PreparedTesting.h"

#include "brickwall/tests/oracles/Fields.h"
#include "brickwall/tests/oracles/RandomLayout.h"

#include <algorithm>
#include <atomic>
#include <chrono>
#include <cstdlib>
#include <functional>
#include <thread>

#include <signal.h>
#include <sys/resource.h>

namespace brickwall {
namespace {

using namespace prepared_test;
using namespace oracles;

TEST_F(Prepared, TheSecondTimeIsTheSameFromTheCache)
{
    for (const bool pyramid : {false, true}) {
        request.pyramid = pyramid;
        const PreparedVolume first = prepare(), second = prepare();
        EXPECT_FALSE(first.fromCache);
        EXPECT_TRUE(second.fromCache);
        expectSameVolume(first, second);
        EXPECT_TRUE(first.model.fields[0].values.empty());
    }
}

TEST_F(Prepared, KeepsThePyramidIfItIsWanted)
{
    data = writeExa(testFolder(), "u", modelOf(uniformBlocks({4, 4, 4}, 8, 0), [](const vec3d& p) { return p.x; }));
    request = {data, {}, openDataSet(data)->fieldNames(), NonFinite::error, true};
    const PreparedVolume first = prepare(), second = prepare();
    EXPECT_TRUE(second.fromCache);
    EXPECT_FALSE(first.pyramid.empty());
    expectSameVolume(first, second);
}

TEST_F(Prepared, IsWhatThePartsMake)
{
    Progress silent;
    const Executor serial(1);
    const Model model = loadData(data, {"speed"});
    const RegionTree tree = buildRegions(model.bricks, serial, silent);
    const PreparedVolume volume = prepare();
    EXPECT_TRUE(sameRegions(*volume.regions, tree));
    EXPECT_TRUE(sameFields(*volume.fields[0], padField(model.fields[0], model.bricks, tree, serial, silent)));
}

TEST_F(Prepared, OtherRequestsHaveTheirOwnFiles)
{
    prepare();
    request.fields = {"u"};
    EXPECT_FALSE(prepare().fromCache);
    request.nonFinite = NonFinite::empty;
    EXPECT_FALSE(prepare().fromCache);
    EXPECT_EQ(filesInCache(), 3u);
    EXPECT_TRUE(prepare().fromCache);
}

TEST_F(Prepared, WhateverWayTheFileIsNamed)
{
    prepare();
    request.data = testFolder() + "/cache/../t.exa";
    EXPECT_TRUE(prepare().fromCache);
}

TEST_F(Prepared, FilesThatHaveChangedAreReadAgain)
{
    const std::string scalars = testFolder() + "/t.speed.scalars";
    ASSERT_TRUE(std::filesystem::exists(scalars)) << "the writer calls it otherwise";
    prepare();
    const auto time = std::filesystem::last_write_time(scalars);
    std::filesystem::last_write_time(scalars, time + std::chrono::seconds(1));
    EXPECT_FALSE(prepare().fromCache) << "another time";
    EXPECT_TRUE(prepare().fromCache);
    std::filesystem::last_write_time(scalars, time);
    prepare();
    std::string bytes = bytesOfFile(scalars);
    bytes[1] = char(bytes[1] ^ 1);
    writeText(scalars, bytes);
    std::filesystem::last_write_time(scalars, time);
    EXPECT_FALSE(prepare().fromCache) << "another beginning with the same size and time";
    EXPECT_EQ(filesInCache(), 1u) << "the new one takes the place of the old one";
}

TEST_F(Prepared, DamagedFilesAreMadeAnew)
{
    const PreparedVolume first = prepare();
    const std::string whole = bytesOfFile(cached());
    const auto expectNew = [&](const std::string& bytes, std::size_t at) {
        writeText(cached(), bytes);
        Notes notes;
        const PreparedVolume again = prepare(notes);
        EXPECT_FALSE(again.fromCache) << "byte " << at;
        EXPECT_NE(notes.all.find("not taken from the cache"), std::string::npos) << notes.all;
        EXPECT_EQ(bytesOfFile(cached()), whole) << "byte " << at;
        EXPECT_TRUE(prepare().fromCache);
    };
    // Header, first array, table: every part is hashed. What lies between arrays is nothing.
    for (const std::size_t at : {std::size_t(0), std::size_t(8), std::size_t(17), std::size_t(25), std::size_t(33),
                                 std::size_t(4096), whole.size() / 2, whole.size() - 1}) {
        std::string bytes = whole;
        bytes[at] = char(bytes[at] ^ 0x10);
        expectNew(bytes, at);
    }
    for (const std::size_t size : {std::size_t(0), std::size_t(20), std::size_t(5000), whole.size() - 1})
        expectNew(whole.substr(0, size), size);
}

TEST_F(Prepared, SmallDataAndCachesThatAreOffKeepNothing)
{
    cache.leastCells = 1 << 20;
    EXPECT_FALSE(prepare().fromCache);
    EXPECT_FALSE(prepare().fromCache);
    EXPECT_EQ(filesInCache(), 0u);
    cache.leastCells = 0;
    cache.folder.clear();
    EXPECT_FALSE(prepare().fromCache);
}

TEST_F(Prepared, AFolderThatCannotBeMadeIsANote)
{
    writeText(testFolder() + "/file", "x");
    cache.folder = testFolder() + "/file/cache";
    Notes notes;
    EXPECT_EQ(prepare(notes).model.fields[0].name, "speed");
    EXPECT_NE(notes.all.find("not kept in the cache"), std::string::npos) << notes.all;
}

/// No file may become larger, as if the disk were full.
class FileLimit
{
public:
    explicit FileLimit(rlim_t bytes)
    {
        handler_ = ::signal(SIGXFSZ, SIG_IGN);
        ::getrlimit(RLIMIT_FSIZE, &before_);
        const rlimit limit{bytes, before_.rlim_max};
        ::setrlimit(RLIMIT_FSIZE, &limit);
    }
    ~FileLimit()
    {
        ::setrlimit(RLIMIT_FSIZE, &before_);
        ::signal(SIGXFSZ, handler_);
    }
    FileLimit(const FileLimit&) = delete;
    FileLimit& operator=(const FileLimit&) = delete;

private:
    rlimit before_{};
    void (*handler_)(int) = nullptr;
};

TEST_F(Prepared, AFullDiskIsANoteAndLeavesNothing)
{
    Notes notes;
    {
        const FileLimit limit(50000);
        EXPECT_FALSE(prepare(notes).fromCache);
    }
    EXPECT_NE(notes.all.find("not kept in the cache"), std::string::npos) << notes.all;
    EXPECT_EQ(filesInCache(), 0u);
    cache.leastFreeBytes = ~std::uint64_t(0);
    EXPECT_FALSE(prepare(notes).fromCache);
    EXPECT_NE(notes.all.find("no room"), std::string::npos) << notes.all;
    EXPECT_EQ(filesInCache(), 0u);
}

TEST_F(Prepared, WhatWasNotUsedForLongestMakesRoom)
{
    prepare();
    const std::string oldest = cached();
    const std::uint64_t one = std::filesystem::file_size(oldest);
    std::filesystem::last_write_time(oldest, std::filesystem::file_time_type::clock::now() - std::chrono::hours(1));
    request.fields = {"u"};
    prepare();
    EXPECT_EQ(filesInCache(), 2u);
    cache.mostBytes = 5 * one / 2;
    request.nonFinite = NonFinite::empty;
    prepare();
    EXPECT_EQ(filesInCache(), 2u);
    EXPECT_FALSE(std::filesystem::exists(oldest));
    cache.mostBytes = one / 2; // less than one
    request.pyramid = true;
    EXPECT_FALSE(prepare().fromCache);
    EXPECT_FALSE(prepare().fromCache);
}

/// Stops at a given number of calls.
class Stops : public Progress
{
public:
    explicit Stops(int calls) : left_(calls) {}
    void begin(std::string_view, std::uint64_t) override { step(); }
    void advance(std::uint64_t) override { step(); }

private:
    void step()
    {
        if (--left_ < 0)
            cancel();
    }
    std::atomic<int> left_;
};

TEST_F(Prepared, LeavesNothingWhenItIsStopped)
{
    for (int calls = 0;; calls += 3) {
        Stops progress(calls);
        try {
            prepare(progress, 1);
        } catch (const Cancelled&) {
            ASSERT_EQ(filesInCache(), 0u) << "after " << calls;
            continue;
        }
        EXPECT_GT(calls, 10);
        break;
    }
    for (int calls = 0;; ++calls) { // and while it is read
        Stops progress(calls);
        try {
            EXPECT_TRUE(prepare(progress, 1).fromCache);
        } catch (const Cancelled&) {
            ASSERT_EQ(filesInCache(), 1u) << "after " << calls;
            continue;
        }
        EXPECT_GT(calls, 3);
        break;
    }
}

TEST_F(Prepared, ManyAtTheSameTimeSeeWholeVolumesOrNone)
{
    const PreparedVolume expected = prepare();
    std::atomic<int> wrong{0};
    const auto work = [&](bool forgets) {
        for (int i = 0; i < 8; ++i) {
            std::error_code none;
            if (forgets && i % 2 == 0)
                for (const auto& entry : std::filesystem::directory_iterator(cache.folder, none))
                    if (entry.path().extension() == ".prepared")
                        std::filesystem::remove(entry.path(), none);
            Progress silent;
            const PreparedVolume volume = prepare(silent, 1);
            wrong +=
                !sameRegions(*volume.regions, *expected.regions) || !sameFields(*volume.fields[0], *expected.fields[0]);
        }
    };
    std::vector<std::thread> others;
    for (const bool forgets : {true, true, false})
        others.emplace_back(work, forgets);
    for (std::thread& other : others)
        other.join();
    EXPECT_EQ(wrong, 0);
    EXPECT_EQ(filesInCache(), 1u);
}

TEST(UserCache, IsWhereTheEnvironmentSays)
{
    const auto folderWith = [](const char* own, const char* user, const char* home) {
        ::setenv("BRICKWALL_CACHE", own, 1);
        ::setenv("XDG_CACHE_HOME", user, 1);
        ::setenv("HOME", home, 1);
        return userCache().folder;
    };
    const std::string home = std::getenv("HOME") ? std::getenv("HOME") : "";
    EXPECT_EQ(folderWith("off", "/x", "/h"), "");
    EXPECT_EQ(folderWith("/own", "/x", "/h"), "/own");
    EXPECT_EQ(folderWith("", "/x", "/h"), "/x/brickwall");
    EXPECT_EQ(folderWith("", "relative", "/h"), "/h/.cache/brickwall");
    EXPECT_EQ(folderWith("", "", ""), "");
    ::setenv("HOME", home.c_str(), 1);
    ::unsetenv("BRICKWALL_CACHE");
    ::unsetenv("XDG_CACHE_HOME");
}

} // namespace
} // namespace brickwall
