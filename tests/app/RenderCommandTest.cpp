// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "RunCommand.h"

#include "brickwall/core/render/Compare.h"
#include "brickwall/core/render/ImageFiles.h"

#include <nlohmann/json.hpp>

#include <chrono>
#include <csignal>
#include <thread>

using namespace brickwall;
using namespace brickwall::testing;
using nlohmann::json;

namespace {

const std::string sample = "sample:wake:60k";

} // namespace

TEST(RenderCommand, WritesOneOverviewWithoutAnyOption)
{
    const auto folder = scratchFolder() / "out";
    const Outcome outcome = run("render " + sample + " --out " + folder.string() + " --size 64x48");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const Image image = readPng((folder / "view.png").string());
    EXPECT_EQ(image.width, 64);
    EXPECT_EQ(image.height, 48);
}

TEST(RenderCommand, NamesPicturesAfterChannelAndEye)
{
    const auto folder = scratchFolder() / "out";
    ASSERT_EQ(
        run("render " + sample + " --out " + folder.string() + " --rig cave5 --size 16x16 --format png,exr").exitCode,
        0);
    for (const char* wall : {"front", "left", "right", "floor", "ceiling"})
        for (const char* eye : {"left", "right"})
            for (const char* format : {"png", "exr"})
                EXPECT_TRUE(exists(folder / (std::string(wall) + "-" + eye + "." + format))) << wall << " " << eye;
}

TEST(RenderCommand, StatisticsHoldEveryRepetitionOfEveryView)
{
    const auto folder = scratchFolder();
    const std::string stats = (folder / "stats.json").string();
    ASSERT_EQ(run("render " + sample + " --out " + folder.string() +
                  " --rig stereo-wall --size 64x32 --repeat 3 --threads 1 --stats " + stats)
                  .exitCode,
              0);
    const json s = json::parse(contentOf(stats));
    EXPECT_EQ(s["milliseconds"].size(), 3u);
    EXPECT_EQ(s["threads"], 1);
    EXPECT_GE(s["lanes"], 1);
    ASSERT_EQ(s["views"].size(), 2u);
    std::uint64_t samples = 0;
    for (const json& view : s["views"]) {
        EXPECT_EQ(view["milliseconds"].size(), 3u);
        EXPECT_EQ(view["rays"], 32 * 32);
        EXPECT_GT(view["regions_visited"], 0);
        samples += view["samples"].get<std::uint64_t>();
    }
    EXPECT_EQ(s["samples"], samples);
    EXPECT_GT(samples, 0u);
}

TEST(RenderCommand, HalfTheStepIsCloserToAFineOne)
{
    const auto folder = scratchFolder();
    std::vector<Frame> frames;
    for (const char* dt : {"1", "0.25", "0.02"}) {
        const auto out = folder / dt;
        ASSERT_EQ(run("render " + sample + " --out " + out.string() +
                      " --size 48x48 --format exr --method midpoint --dt " + dt)
                      .exitCode,
                  0);
        frames.push_back(readExr((out / "view.exr").string()));
    }
    EXPECT_LT(compareFrames(frames[1], frames[2]).mean, 0.5 * compareFrames(frames[0], frames[2]).mean);
}

TEST(RenderCommand, OptionsChangeThePicture)
{
    const auto folder = scratchFolder();
    const auto picture = [&](const std::string& name, const std::string& options, const std::string& size = "40x40") {
        const Outcome outcome =
            run("render " + sample + " --size " + size + " --out " + (folder / name).string() + " " + options);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        return contentOf(folder / name / "view.png");
    };
    const std::string plain = picture("plain", "");
    EXPECT_EQ(plain, picture("again", "")) << "the same call gives the same bytes";
    EXPECT_NE(plain, picture("field", "--field u"));
    EXPECT_NE(plain, picture("colormap", "--colormap viridis"));
    EXPECT_NE(plain, picture("range", "--range 0,0.5"));
    EXPECT_NE(plain, picture("scale", "--opacity-scale 3"));
    EXPECT_NE(plain, picture("shading", "--shading off"));
    EXPECT_NE(plain, picture("background", "--background 0.2,0.3,0.4"));
    EXPECT_NE(plain, picture("camera", "--camera 0,0,9,0,0,0,0,1,0 --fov 40"));
    EXPECT_NE(picture("large", "", "300x300"), picture("legend", "--legend", "300x300"));
}

TEST(RenderCommand, TakesATransferFunctionFromAFile)
{
    const auto folder = scratchFolder();
    write(folder / "tf.json", R"({"range": [0, 2], "colors": [[0, 1, 1, 1]], "opacity": [[0, 0], [1, 0]]})");
    ASSERT_EQ(run("render " + sample + " --size 16x16 --format exr --out " + folder.string() + " --tf " +
                  (folder / "tf.json").string())
                  .exitCode,
              0);
    for (const vec4f& color : readExr((folder / "view.exr").string()).color)
        EXPECT_EQ(color, vec4f(0.0f)) << "a transparent transfer function shows nothing";
}

TEST(RenderCommand, FindsWhatItCannotWriteBeforeTheWork)
{
    const auto folder = scratchFolder();
    const Outcome outcome = run("render " + sample + " --size 8x8 --out " + (folder / "out").string() + " --stats " +
                                (folder / "missing" / "stats.json").string());
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_NE(messageOf(outcome).find("missing"), std::string::npos) << outcome.err;
    EXPECT_TRUE(std::filesystem::is_empty(folder / "out"));
}

TEST(RenderCommand, ResizesARigWhoseChannelsShareAWindowOrHaveNone)
{
    const auto folder = scratchFolder();
    write(folder / "rig.toml", R"(
[[screen]]
name = "wall"
center = [0, 2, 0]
size = [2, 2]
[[window]]
size = [200, 100]
[[channel]]
name = "right-half"
viewport = [100, 0, 100, 100]
[[channel]]
name = "left-half"
viewport = [0, 0, 100, 100]
[[channel]]
name = "unseen"
window = -1
viewport = [0, 0, 100, 100]
)");
    const Outcome outcome = run("render " + sample + " --size 16x16 --rig " + (folder / "rig.toml").string() +
                                " --out " + (folder / "out").string());
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(outcome.err.find("warning: channel \"right-half\""), std::string::npos) << outcome.err;
    EXPECT_TRUE(exists(folder / "out" / "unseen.png"));
    EXPECT_NE(run("rig " + (folder / "rig.toml").string()).out.find("window none"), std::string::npos);
}

TEST(RenderCommand, AWideRangingFieldGetsALogarithmicRangeAndTheCommandSaysSo)
{
    const auto folder = scratchFolder();
    const Outcome outcome = run("render sample:cloud:60k --size 16x16 --out " + folder.string());
    ASSERT_EQ(outcome.exitCode, 0);
    EXPECT_NE(outcome.err.find("logarithmic"), std::string::npos) << outcome.err;
}

TEST(RenderCommand, CtrlCEndsItWithoutPictures)
{
    const auto folder = scratchFolder() / "out";
    const pid_t child = fork();
    if (child == 0) {
        freopen("/dev/null", "w", stderr);
        freopen("/dev/null", "w", stdout);
        const std::string out = folder.string();
        execl(BRICKWALL_COMMAND, "brickwall", "render", "sample:cloud:2M", "--out", out.c_str(), "--size", "4096x4096",
              "--method", "midpoint", "--dt", "0.01", nullptr);
        _exit(99);
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(700));
    kill(child, SIGINT);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFEXITED(status));
    EXPECT_EQ(WEXITSTATUS(status), 130);
    EXPECT_TRUE(!exists(folder) || std::filesystem::is_empty(folder));
}

TEST(RenderCommand, WritesTheTransferFunctionThatItUsedAndReadsItBack)
{
    const auto folder = scratchFolder();
    const std::string tf = (folder / "tf.json").string();
    const std::string common = "render " + sample + " --iso 0.6 --iso-opacity 0.5 --size 32x32 --format exr --stats " +
                               (folder / "stats.json").string();
    ASSERT_EQ(run(common + " --color-field pressure --colormap viridis --write-tf " + tf + " --out " +
                  (folder / "a").string())
                  .exitCode,
              0);
    const json stats = json::parse(contentOf(folder / "stats.json"));
    EXPECT_EQ(stats["colors"]["field"], "pressure");
    EXPECT_EQ(stats["field"], "speed");
    EXPECT_EQ(stats["surfaces"][0]["colored_by_field"], true);
    ASSERT_EQ(run(common + " --tf " + tf + " --out " + (folder / "b").string()).exitCode, 0);
    const Frame a = readExr((folder / "a/view.exr").string()), b = readExr((folder / "b/view.exr").string());
    EXPECT_LT(compareFrames(a, b).max, 1e-4);
    ASSERT_EQ(run(common + " --out " + (folder / "c").string()).exitCode, 0);
    EXPECT_GT(compareFrames(a, readExr((folder / "c/view.exr").string())).max, 0.05) << "that is in other colours";
}
