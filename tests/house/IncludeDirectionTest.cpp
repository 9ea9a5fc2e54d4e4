// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <regex>
#include <string>
#include <vector>

namespace {

namespace fs = std::filesystem;

/// The house, from the ground up: a folder includes only its own files and those of folders before it.
const std::vector<std::string> house = {"core/base",  "core/simd",  "core/model",  "core/io",
                                        "core/shade", "core/trace", "core/render", "core/scene",
                                        "channels",   "plugin",     "app"};

struct Include
{
    std::string from; ///< file
    int line;
    std::string what;
};

std::vector<Include> includesBelow(const std::string& folder)
{
    static const std::regex directive(R"(^\s*#\s*include\s*[<"]([^>"]+)[>"])");
    std::vector<Include> found;
    for (const auto& entry : fs::recursive_directory_iterator(fs::path(BRICKWALL_SOURCE_DIR) / folder)) {
        if (entry.path().extension() != ".h" && entry.path().extension() != ".cpp")
            continue;
        std::ifstream in(entry.path());
        std::string text;
        for (int line = 1; std::getline(in, text); ++line)
            if (std::smatch m; std::regex_search(text, m, directive))
                found.push_back({entry.path().string(), line, m[1]});
    }
    return found;
}

/// The index in the house of the folder that an include of ours names, or -1 for a foreign one.
int roomOf(const std::string& include)
{
    const std::string prefix = "brickwall/";
    if (include.rfind(prefix, 0) != 0)
        return -1;
    for (std::size_t i = 0; i < house.size(); ++i)
        if (include.rfind(prefix + house[i] + "/", 0) == 0)
            return static_cast<int>(i);
    return static_cast<int>(house.size()); // tests or unknown: above everything
}

bool isForeign(const Include& include, const std::vector<std::string>& prefixes)
{
    return std::any_of(prefixes.begin(), prefixes.end(),
                       [&](const std::string& p) { return include.what.rfind(p, 0) == 0; });
}

TEST(House, NoIncludePointsUpward)
{
    for (std::size_t room = 0; room < house.size(); ++room)
        for (const Include& include : includesBelow(house[room]))
            EXPECT_LE(roomOf(include.what), static_cast<int>(room))
                << include.from << ":" << include.line << " includes " << include.what;
}

TEST(House, EveryFolderHasSources)
{
    for (const std::string& folder : house)
        EXPECT_FALSE(includesBelow(folder).empty()) << folder;
}

TEST(House, OnlyThePluginSeesOpenSceneGraphAndGl)
{
    for (const std::string& folder : house)
        for (const Include& include : includesBelow(folder))
            EXPECT_TRUE(folder == "plugin" || !isForeign(include, {"osg", "GL/", "OpenThreads/"}))
                << include.from << ":" << include.line << " includes " << include.what;
}

TEST(House, OneFileSeesTbbAndOneSeesEmbree)
{
    std::vector<std::string> tbb, embree;
    for (const std::string& folder : house)
        for (const Include& include : includesBelow(folder)) {
            if (isForeign(include, {"tbb/", "oneapi/"}))
                tbb.push_back(include.from);
            if (isForeign(include, {"embree3/"}))
                embree.push_back(include.from);
        }
    for (auto* files : {&tbb, &embree}) {
        std::sort(files->begin(), files->end());
        files->erase(std::unique(files->begin(), files->end()), files->end());
        EXPECT_EQ(files->size(), 1u);
    }
}

TEST(House, HighwayStaysInSimd)
{
    for (const std::string& folder : house)
        for (const Include& include : includesBelow(folder))
            EXPECT_TRUE(folder == "core/simd" || !isForeign(include, {"hwy/"}))
                << include.from << ":" << include.line << " includes " << include.what;
}

} // namespace
