// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// `brickwall convert` as a user runs it, and what is left of it when it cannot end.
#include "RunCommand.h"

#include <algorithm>
#include <set>

#include <sys/mount.h>
#include <unistd.h>

using namespace brickwall;
using namespace brickwall::testing;

namespace {

const std::vector<std::string> extensions{"exa", "vdb", "vthb", "brickwall"};

std::set<std::string> namesIn(const std::filesystem::path& folder)
{
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder))
        names.insert(entry.path().filename().string());
    return names;
}

std::filesystem::path outputFolder()
{
    const auto folder = scratchFolder() / "out";
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder);
    return folder;
}

/// Starts a conversion in the background, waits until it writes, sends a signal, and waits for its end. Returns the
/// exit code as the shell has it; -1 if nothing was ever written.
int exitCodeAfter(const std::string& signal, const std::filesystem::path& destination)
{
    // A process in the background of a shell ignores SIGINT, unless it has a job of its own (set -m).
    const std::string script = "set -m; cd '" + destination.parent_path().string() +
                               "'; '" BRICKWALL_COMMAND "' convert sample:wake:3M " + destination.filename().string() +
                               " 2>../message & pid=$!\n" +
                               "for i in $(seq 3000); do\n"
                               "  if [ $(du -sk . | cut -f1) -gt 300 ]; then kill -" +
                               signal +
                               " $pid; wait $pid; exit $?; fi\n"
                               "  kill -0 $pid 2>/dev/null || exit 77\n"
                               "  sleep 0.02\n"
                               "done\nexit 78\n";
    write(scratchFolder() / "script.sh", script);
    const int status = std::system(("bash " + (scratchFolder() / "script.sh").string() + " 2>/dev/null").c_str());
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

} // namespace

TEST(ConvertCommand, WritesEveryFormatAndSaysHowFarItIs)
{
    const auto folder = outputFolder();
    for (const std::string& extension : extensions) {
        const Outcome outcome = run("convert sample:wake:60k " + (folder / ("a." + extension)).string());
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_NE(outcome.err.find("writing speed"), std::string::npos) << outcome.err;
        EXPECT_TRUE(std::filesystem::exists(folder / ("a." + extension)));
    }
    for (const std::string& name : namesIn(folder))
        EXPECT_EQ(name.find(".part"), std::string::npos) << name;
}

TEST(ConvertCommand, TakesFieldsDerivedOnesBoxAndLevels)
{
    const std::string out = (outputFolder() / "a.brickwall").string();
    const Outcome outcome =
        run("convert sample:wake:60k " + out +
            " --derive 'twice = 2 * speed' --field twice --field speed --box -1,-1,-1,2,1,1 --levels 0:2");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const Outcome info = run("info " + out);
    EXPECT_EQ(info.exitCode, 0) << info.err;
    EXPECT_NE(info.out.find("Brickwall cache"), std::string::npos) << info.out;
    EXPECT_LT(info.out.find("twice"), info.out.find("speed")) << info.out;
    EXPECT_EQ(info.out.find("level 3"), std::string::npos) << info.out;
}

TEST(ConvertCommand, RefusesBadOptionsInOneLine)
{
    const std::string folder = outputFolder().string(), wake = "convert sample:wake:60k " + folder;
    const std::vector<std::pair<std::string, std::string>> cases{
        {"/a.vtk", ".exa"},
        {"/no/such/a.exa", "expected a folder"},
        {"/a.exa --box 0,0,0,1,1", "--box: expected six numbers"},
        {"/a.exa --box 0,0,0,1,1,0", "--box: expected a box with a volume"},
        {"/a.exa --box 0,0,0,1,nan,1", "--box"},
        {"/a.exa --box 900,0,0,901,1,1", "no cells"},
        {"/a.exa --levels 2:1", "--levels"},
        {"/a.exa --levels x", "--levels"},
        {"/a.exa --levels 9", "no cells"},
        {"/a.exa --field nosuch", "nosuch"},
        {"/a.exa --field speed --field speed", "twice"},
        {"/a.exa --non-finite maybe", "--non-finite"},
        {"/a.exa --derive 'a = speed +'", "--derive: expected a value"},
        {"/a.exa --derive 'a = nosuch'", "no field 'nosuch'"},
    };
    for (const auto& [arguments, said] : cases) {
        const Outcome outcome = run(wake + arguments);
        EXPECT_EQ(outcome.exitCode, 2) << arguments;
        EXPECT_NE(messageOf(outcome).find(said), std::string::npos) << arguments << "\n" << outcome.err;
    }
    EXPECT_TRUE(namesIn(folder).empty());
}

TEST(ConvertCommand, DoesNotWriteOverWhatItReads)
{
    const std::string file = (outputFolder() / "a.brickwall").string();
    ASSERT_EQ(run("convert sample:wake:60k " + file).exitCode, 0);
    EXPECT_NE(messageOf(run("convert " + file + " " + file + " --overwrite")).find("another file"), std::string::npos);
}

TEST(ConvertCommand, ThatMayNotWriteThatMuchLeavesNothing)
{
    for (const std::string& extension : extensions) {
        const auto folder = outputFolder();
        const std::string message = (scratchFolder() / "message").string();
        const std::string command = "ulimit -f 20; " BRICKWALL_COMMAND " convert sample:wake:60k " +
                                    (folder / ("a." + extension)).string() + " 2>" + message;
        EXPECT_EQ(WEXITSTATUS(std::system(command.c_str())), 2) << extension;
        EXPECT_NE(contentOf(message).find("cannot be written: File too large"), std::string::npos)
            << contentOf(message);
        EXPECT_TRUE(namesIn(folder).empty()) << extension;
    }
}

TEST(ConvertCommand, ToAFullDiskLeavesNothing)
{
    const auto disk = scratchFolder() / "disk";
    std::filesystem::create_directories(disk);
    if (::mount("tmpfs", disk.c_str(), "tmpfs", 0, "size=128k") != 0)
        GTEST_SKIP() << "needs the right to mount a small tmpfs";
    for (const std::string& extension : extensions) {
        const Outcome outcome = run("convert sample:wake:60k " + (disk / ("a." + extension)).string());
        EXPECT_EQ(outcome.exitCode, 2) << extension;
        EXPECT_NE(messageOf(outcome).find("cannot be written: No space left on device"), std::string::npos)
            << outcome.err;
        EXPECT_TRUE(namesIn(disk).empty()) << extension;
    }
    ::umount(disk.c_str());
}

TEST(ConvertCommand, StoppedByCtrlCLeavesNothing)
{
    for (const std::string& extension : extensions) {
        const auto folder = outputFolder();
        const int code = exitCodeAfter("INT", folder / ("a." + extension));
        EXPECT_EQ(code, 130) << extension << "\n" << contentOf(scratchFolder() / "message");
        EXPECT_TRUE(namesIn(folder).empty()) << extension;
    }
}

TEST(ConvertCommand, KilledLeavesNothingThatLooksFinished)
{
    for (const std::string& extension : extensions) {
        const auto folder = outputFolder();
        EXPECT_EQ(exitCodeAfter("KILL", folder / ("a." + extension)), 128 + 9) << extension;
        for (const std::string& name : namesIn(folder))
            EXPECT_TRUE(name.ends_with(".part")) << name;
        // The next attempt does not mind what is left.
        const Outcome again = run("convert sample:wake:60k " + (folder / ("a." + extension)).string());
        EXPECT_EQ(again.exitCode, 0) << again.err;
    }
}
