// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// `render --show` and `--lod`.
#include "RunCommand.h"

#include "brickwall/core/render/ImageFiles.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <string>

using namespace brickwall;
using namespace brickwall::testing;
using nlohmann::json;

namespace {

const std::string sample = "sample:wake:60k";

struct Shown
{
    Frame numbers;
    json view; ///< of the statistics
};

Shown shown(const std::string& what, const std::string& more)
{
    const auto folder = scratchFolder();
    const Outcome outcome = run("render " + sample + " --size 24x20 --format exr --show " + what + " " + more +
                                " --out " + folder.string() + " --stats " + (folder / "s.json").string());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_FALSE(exists(folder / "view.exr"));
    return {readExr((folder / ("view-" + what + ".exr")).string()),
            json::parse(contentOf(folder / "s.json"))["views"][0]};
}

double sumOf(const Frame& frame)
{
    double sum = 0.0;
    for (const vec4f& pixel : frame.color)
        sum += double(pixel.r);
    return sum;
}

float largestOf(const Frame& frame)
{
    float largest = -INFINITY;
    for (const vec4f& pixel : frame.color)
        largest = std::max(largest, pixel.r);
    return largest;
}

} // namespace

TEST(Show, CostAndRegionsPerPixelAddUpToThoseOfTheView)
{
    for (const char* settings : {"--method midpoint", "--tolerance 0.01", "--lod 2"}) {
        const Shown cost = shown("cost", settings), regions = shown("regions", settings);
        EXPECT_EQ(sumOf(cost.numbers), cost.view["samples"].get<double>()) << settings;
        EXPECT_EQ(sumOf(regions.numbers), regions.view["regions_visited"].get<double>()) << settings;
    }
}

TEST(Show, TheLargestErrorOfAPixelIsThatOfTheView)
{
    const Shown error = shown("error", "--tolerance 0.01");
    EXPECT_FLOAT_EQ(largestOf(error.numbers), error.view["largest_bound"].get<float>());
}

TEST(Show, LevelsAreThoseOfTheDataAndNothingIsBesideThem)
{
    const Frame levels = shown("levels", "").numbers;
    EXPECT_EQ(levels.color.front().r, -1.0f); // a corner of the picture
    EXPECT_EQ(std::min_element(levels.color.begin(), levels.color.end(),
                               [](const vec4f& a, const vec4f& b) { return a.r < b.r; })
                  ->r,
              -1.0f);
    EXPECT_LE(largestOf(levels), 3.0f); // the wake has four levels
    EXPECT_TRUE(std::any_of(levels.color.begin(), levels.color.end(), [](const vec4f& p) { return p.r == 0.0f; }));
}

TEST(Show, IsRefusedForMethodsWithoutABoundAndForWordsItDoesNotKnow)
{
    const std::string render = "render " + sample + " --size 24x20 --out " + scratchFolder().string();
    EXPECT_EQ(run(render + " --show error --method midpoint").exitCode, 2);
    EXPECT_EQ(run(render + " --show everything").exitCode, 2);
}

TEST(Lod, IsInTheStatisticsAndInWhatTheCommandSays)
{
    const auto folder = scratchFolder();
    const std::string stats = (folder / "s.json").string();
    const Outcome outcome =
        run("render " + sample + " --size 16x16 --lod 2 --out " + folder.string() + " --stats " + stats);
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const json s = json::parse(contentOf(stats));
    EXPECT_EQ(s["method"]["lod"], 2.0);
    ASSERT_FALSE(s["pyramid"].empty());
    EXPECT_GE(s["pyramid"][0]["level"], 1);
    std::uint64_t samples = 0;
    for (const json& n : s["views"][0]["member_samples"])
        samples += n.get<std::uint64_t>();
    EXPECT_EQ(samples, s["views"][0]["samples"].get<std::uint64_t>());
    EXPECT_GT(s["views"][0]["member_samples"].size(), 1u);
    EXPECT_NE(outcome.out.find("averaged data"), std::string::npos) << outcome.out;
}

TEST(Lod, IsRefusedWhereItWouldHaveNoEffectOrNoMeaning)
{
    const std::string render = "render " + sample + " --size 16x16 --out " + scratchFolder().string();
    EXPECT_EQ(run(render + " --lod 1 --method reference").exitCode, 2);
    EXPECT_EQ(run(render + " --lod -1").exitCode, 2);
}
