// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "TestDisplay.h"

#include "brickwall/core/render/ImageFiles.h"
#include "brickwall/tests/common/ScratchFolder.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cstdlib>
#include <set>

namespace brickwall::test {
namespace {

/// Runs an example on a small sample; it has to succeed.
void runExample(const std::string& name, const std::string& arguments)
{
    const std::string command =
        fmt::format("{}/example_{} sample:wake:60k {}", BRICKWALL_PROGRAM_FOLDER, name, arguments);
    EXPECT_EQ(std::system(command.c_str()), 0) << command;
}

/// A picture that shows something has many colours.
int coloursOf(const std::string& path)
{
    const Image image = readPng(path);
    std::set<std::array<std::uint8_t, 3>> colours;
    for (std::size_t i = 0; i < image.rgba.size(); i += 4)
        colours.insert({image.rgba[i], image.rgba[i + 1], image.rgba[i + 2]});
    return int(colours.size());
}

TEST(Examples, PicturesWithTheCoreAlone)
{
    const std::string out = scratchFile("picture");
    runExample("1_picture", "--out " + out + ".png");
    EXPECT_GT(coloursOf(out + ".png"), 100);
    runExample("6_matrices", "--frames 2 --out " + out);
    for (const char* number : {"-0.png", "-1.png"})
        EXPECT_GT(coloursOf(out + number), 100);
}

TEST(Examples, PicturesOfRigs)
{
    const std::string out = scratchFile("picture");
    runExample("2_wall", "--out " + out + ".png");
    EXPECT_GT(coloursOf(out + ".png"), 100);
    runExample("3_stereo", "--out " + out);
    for (const char* eye : {"-wall-left.png", "-wall-right.png"})
        EXPECT_GT(coloursOf(out + eye), 100);
    EXPECT_NE(readPng(out + "-wall-left.png").rgba, readPng(out + "-wall-right.png").rgba);
}

TEST(Examples, NodesInAnOsgViewer)
{
    BRICKWALL_NEEDS_DISPLAY();
    const std::string node = scratchFile("node.png"), model = scratchFile("model.png");
    runExample("4_node", "--frames 3 --out " + node);
    runExample("5_model", "--frames 3 --out " + model);
    EXPECT_GT(coloursOf(node), 100);
    EXPECT_GT(coloursOf(model), 100);
    EXPECT_NE(readPng(node).rgba, readPng(model).rgba);
    const std::string lines = scratchFile("lines.png");
    runExample("8_streamlines", "--frames 3 --out " + lines);
    EXPECT_NE(readPng(node).rgba, readPng(lines).rgba);
}

TEST(Examples, TheVirtualCave)
{
    BRICKWALL_NEEDS_DISPLAY();
    const std::string folder = scratchFile("cave");
    runExample("7_cave", "--frames 1 --out " + folder);
    EXPECT_GT(coloursOf(folder + "/front-left.png"), 100);
}

} // namespace
} // namespace brickwall::test
