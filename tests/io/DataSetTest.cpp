// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/io/IoTest.h"
#include "brickwall/tests/oracles/WriteExa.h"

#include <atomic>
#include <list>

#include <sys/stat.h>

namespace brickwall {
namespace {

using namespace oracles;

TEST(DataSets, ThatDoNotExistAreErrors)
{
    EXPECT_TRUE(says(loadError("/nowhere/at/all.exa"), {"/nowhere/at/all.exa", "no such file or folder"}));
    EXPECT_TRUE(says(loadError(""), {"no such file or folder"}));
}

TEST(DataSets, ThatAreEmptyAreErrors)
{
    const std::string folder = testFolder();
    EXPECT_TRUE(says(loadError(folder), {folder, "folder is empty"}));
    writeText(folder + "/a.exa", "");
    EXPECT_TRUE(says(loadError(folder + "/a.exa"), {"a.exa", "file is empty"}));
}

TEST(DataSets, OfNoFormatListWhatCanBeRead)
{
    const std::string path = testFolder() + "/picture.png";
    writeText(path, std::string("\x89PNG\0\0", 6));
    const std::string message = loadError(path);
    for (const Format& format : formats())
        EXPECT_TRUE(says(message, {path, format.name, format.looksLike}));
}

// Opening a named pipe without a writer would wait for ever.
TEST(DataSets, ThatAreNoFilesAreErrors)
{
    const std::string path = testFolder() + "/t.bricks";
    ASSERT_EQ(::mkfifo(path.c_str(), 0600), 0);
    EXPECT_TRUE(says(loadError(path), {"t.bricks", "expected a file or a folder"}));
}

TEST(DataSets, PartsSayWhatToOpenInstead)
{
    const std::string folder = testFolder();
    writeScalars(folder + "/t.dens.scalars", std::vector<float>{1});
    EXPECT_TRUE(says(loadError(folder + "/t.dens.scalars"), {"t.dens.scalars", "no cells", ".exa"}));
    writeText(folder + "/t.bricks", "");
    EXPECT_TRUE(says(loadError(folder + "/t.dens.scalars"), {"open t.bricks"}));
    writeText(folder + "/t.tris", "x");
    EXPECT_TRUE(says(loadError(folder + "/t.tris"), {"t.tris", "keyword triangles"}));
}

/// Stages as they begin, each with its steps and how many were made.
class Stages : public Progress
{
public:
    struct Stage
    {
        std::string name;
        std::uint64_t steps = 0;
        std::atomic<std::uint64_t> made{0};
    };
    void begin(std::string_view stage, std::uint64_t steps) override
    {
        stages.emplace_back();
        stages.back().name = stage;
        stages.back().steps = steps;
    }
    void advance(std::uint64_t steps) override { stages.back().made += steps; }

    std::list<Stage> stages;
};

TEST(DataSets, TellHowFarTheyAre)
{
    const std::string folder = testFolder();
    writeBricks(folder + "/t.bricks", std::vector<BrickRecord>{{{2, 2, 2}, {0, 0, 0}, 0, {0, 1, 2, 3, 4, 5, 6, 7}}});
    writeScalars(folder + "/t.dens.scalars", std::vector<float>(8, 1.f));
    Stages stages;
    openDataSet(folder + "/t.bricks")->load(std::vector<std::string>{"dens"}, Executor(2), stages);
    bool reading = false;
    for (const auto& stage : stages.stages) {
        reading = reading || stage.name == "reading dens";
        EXPECT_EQ(stage.made, stage.steps) << stage.name;
    }
    EXPECT_TRUE(reading);
}

} // namespace
} // namespace brickwall
