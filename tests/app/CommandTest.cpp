// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "RunCommand.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cstdint>
#include <set>

using namespace brickwall;
using namespace brickwall::testing;
using nlohmann::json;

namespace {

void expectRefused(const std::string& arguments, const std::string& said)
{
    const Outcome outcome = run(arguments);
    EXPECT_EQ(outcome.exitCode, 2) << arguments << "\n" << outcome.err;
    const std::string message = messageOf(outcome);
    EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << outcome.err;
    EXPECT_NE(message.find(said), std::string::npos) << "said: " << message;
}

} // namespace

TEST(InfoCommand, CountsAddUp)
{
    const Outcome outcome = run("info sample:impact:60k --json");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const json info = json::parse(outcome.out);
    std::uint64_t cells = 0;
    for (const json& level : info["levels"])
        cells += level["cells"].get<std::uint64_t>();
    EXPECT_EQ(info["cells"], cells);
    EXPECT_GT(info["bricks"], 0);
    EXPECT_GE(info["regions"], info["multi_brick_regions"]);
    EXPECT_GT(info["memory"]["bytes_per_field"], 4 * cells);
    for (const json& field : info["fields"])
        EXPECT_LE(field["range"][0], field["range"][1]);
    EXPECT_FALSE(info["default_field"].get<std::string>().empty());
}

TEST(InfoCommand, SaysTheSameToPeople)
{
    const Outcome outcome = run("info sample:wake:60k");
    ASSERT_EQ(outcome.exitCode, 0);
    for (const char* word : {"cells", "level 0", "bricks", "regions", "voxels", "world", "speed", "memory"})
        EXPECT_NE(outcome.out.find(word), std::string::npos) << word;
}

TEST(SampleCommand, AnswersEveryPointInOrder)
{
    const auto folder = scratchFolder();
    write(folder / "points.csv", "x,y,z\n0.5,0.25,0.125\n# a comment\n1e9,0,0\n0.5 , 0.25, 0.125, 17\n");
    const Outcome outcome = run("sample sample:wake:60k --points " + (folder / "points.csv").string());
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    std::istringstream lines(outcome.out);
    std::string heading, first, outside, third;
    std::getline(lines, heading);
    std::getline(lines, first);
    std::getline(lines, outside);
    std::getline(lines, third);
    EXPECT_EQ(heading, "x,y,z,value,gx,gy,gz,valid");
    EXPECT_EQ(first, third);
    EXPECT_EQ(first.back(), '1');
    EXPECT_EQ(outside, "1e+09,0,0,0,0,0,0,0");
}

TEST(RigCommand, KnowsTheRigsOfTheProject)
{
    for (const char* rig : {"desktop", "stereo-wall", "cave5", "tiled-wall"}) {
        const Outcome outcome = run(std::string("rig ") + rig);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_NE(outcome.out.find("screen "), std::string::npos);
    }
}

TEST(RigCommand, ConvertedRigsDescribeTheSameScreens)
{
    const auto folder = scratchFolder();
    // A set, because in a .pvx every channel is a machine with a screen of its own.
    const auto screens = [](const std::string& text) {
        std::istringstream lines(text);
        std::set<std::string> found;
        for (std::string line; std::getline(lines, line);)
            if (line.rfind("screen ", 0) == 0)
                found.insert(line.substr(line.find("lower left")));
        return found;
    };
    ASSERT_EQ(screens(run("rig cave5").out).size(), 5u);
    const std::set<std::string> original = screens(run("rig cave5").out);
    for (const char* format : {"toml", "json", "covise", "pvx"}) {
        const auto file = folder / (std::string("cave.") + format);
        ASSERT_EQ(run(std::string("rig cave5 --to ") + format).exitCode, 0);
        write(file, run(std::string("rig cave5 --to ") + format).out);
        const Outcome outcome = run("rig " + file.string());
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_EQ(screens(outcome.out), original) << format;
    }
}

/// Exit code of `brickwall view sample:wake:60k --rig cave5 OPTIONS` on an X server of its own, in this folder, with
/// its last words in the file "message"; nothing where there is no such server, or no viewer.
std::optional<int> viewOnItsOwnServer(const std::filesystem::path& folder, const std::string& options)
{
    if (std::system("command -v Xvfb >/dev/null") != 0)
        return std::nullopt;
    const std::string script = "cd '" + folder.string() + R"('
Xvfb -displayfd 1 -screen 0 640x480x24 +extension GLX -nolisten tcp >display 2>/dev/null &
server=$!
while [ ! -s display ] && kill -0 $server; do sleep 0.1; done
DISPLAY=:$(cat display) LIBGL_ALWAYS_SOFTWARE=1 ")" BRICKWALL_COMMAND R"(" view sample:wake:60k --rig cave5 )" +
                               options + R"( 2>message
code=$?
kill $server
exit $code
)";
    const int status = std::system(script.c_str());
    if (contentOf(folder / "message").find("this build has no windows") != std::string::npos)
        return std::nullopt;
    return WEXITSTATUS(status);
}

// An X server without other clients starts anew when it loses its last one, and refused half of the windows then.
TEST(ViewCommand, OpensAllWindowsOfACaveOnAServerWithoutOtherClients)
{
    const auto folder = scratchFolder();
    const auto code = viewOnItsOwnServer(folder, "--size 16x16 --frames 1 --screenshots pictures");
    if (!code)
        GTEST_SKIP() << "needs Xvfb (Debian: apt-get install xvfb) and a build with windows";
    ASSERT_EQ(*code, 0) << contentOf(folder / "message");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "pictures"), {}), 10);
}

TEST(ViewCommand, PreviewIsOneWindowWhateverTheRigHas)
{
    const auto folder = scratchFolder();
    const auto code = viewOnItsOwnServer(folder, "--size 16x16 --preview --frames 1 --screenshots pictures");
    if (!code)
        GTEST_SKIP() << "needs Xvfb (Debian: apt-get install xvfb) and a build with windows";
    ASSERT_EQ(*code, 0) << contentOf(folder / "message");
    EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder / "pictures"), {}), 1);
    EXPECT_GT(std::filesystem::file_size(folder / "pictures" / "preview.png"), 2000u);
}

TEST(BadInput, IsOneLineAndExitCode2)
{
    const auto folder = scratchFolder();
    const std::string out = " --out " + (folder / "out").string();
    write(folder / "empty.exa", "");
    write(folder / "noise.bin", std::string(1000, '\x7f'));
    write(folder / "bad.csv", "1,2,3\n1,two,3\n");
    expectRefused("info " + (folder / "missing").string(), "missing");
    expectRefused("info " + (folder / "empty.exa").string(), "empty.exa");
    expectRefused("info " + (folder / "noise.bin").string(), "noise.bin");
    expectRefused("info " + folder.string(), folder.string());
    expectRefused("info sample:nothing", "wake");
    expectRefused("render sample:wake:60k --field nosuch" + out, "speed");
    expectRefused("render sample:wake:60k --range 2,1" + out, "range");
    expectRefused("render sample:wake:60k --size 0x5" + out, "--size");
    expectRefused("render sample:wake:60k --size 64" + out, "--size");
    expectRefused("render sample:wake:60k --rig nosuch" + out, "cave5");
    expectRefused("render sample:wake:60k --tf " + (folder / "noise.bin").string() + out, "noise.bin");
    expectRefused("render sample:wake:60k --views " + (folder / "noise.bin").string() + out, "noise.bin");
    expectRefused("sample sample:wake:60k --points " + (folder / "bad.csv").string(), "bad.csv:2");
    expectRefused("rig nosuch", "cave5");
    expectRefused("sample sample:wake:60k --points " + folder.string(), folder.string());
    expectRefused("verify " + folder.string(), folder.string());
}

TEST(BadInput, ResultsThatCannotBeWrittenAreNoSuccess)
{
    for (const char* arguments : {"info sample:wake:60k", "rig cave5"}) {
        const std::string command = std::string(BRICKWALL_COMMAND) + " " + arguments + " >/dev/full 2>/dev/null";
        EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 2) << arguments;
    }
}

TEST(InfoCommand, DescribesDataInAFolderWithoutAUtf8Name)
{
    const auto folder = scratchFolder() / "caf\xe9";
    std::filesystem::create_directories(folder);
    const std::string file = (folder / "one.bricks").string();
    // One brick: size, lower corner, level, and the numbers of its eight cells, all int32.
    std::int32_t brick[15] = {2, 2, 2, 0, 0, 0, 0};
    for (int i = 0; i < 8; ++i)
        brick[7 + i] = i;
    const float values[8] = {1, 2, 3, 4, 5, 6, 7, 8};
    write(file, std::string(reinterpret_cast<const char*>(brick), sizeof brick));
    write(folder / "one.scalars", std::string(reinterpret_cast<const char*>(values), sizeof values));
    const Outcome outcome = run("info --json " + file);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(json::parse(outcome.out)["cells"], 8);
}

TEST(BadInput, OfTheCommandLineIsRefusedBeforeAnyWork)
{
    const std::string out = " --out " + (scratchFolder() / "out").string();
    for (const char* arguments : {"",
                                  "render sample:wake:60k",
                                  "render sample:wake --dt abc",
                                  "render sample:wake --opacity-scale inf",
                                  "render sample:wake --threads 1000000",
                                  "render sample:wake --background nan,0,0",
                                  "render sample:wake --fov 30",
                                  "render sample:wake --format exr --legend",
                                  "render sample:wake --range 0,inf",
                                  "render sample:wake --rig nosuch",
                                  "view sample:wake --screenshots x",
                                  "render sample:wake --dt 0",
                                  "render sample:wake --dt -1",
                                  "render sample:wake --method magic",
                                  "render sample:wake --shading loud",
                                  "render sample:wake --colormap nosuch",
                                  "render sample:wake --threads -1",
                                  "nosuch",
                                  "render sample:wake --format gif",
                                  "rig cave5 --to gif"}) {
        const Outcome outcome =
            run(std::string(arguments) + (std::string(arguments).find("render sample:wake ") == 0 ? out : ""));
        EXPECT_EQ(outcome.exitCode, 2) << arguments;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << arguments << "\n" << outcome.err;
        EXPECT_EQ(outcome.err.find("brickwall: "), 0u) << arguments << "\n" << outcome.err;
    }
}
