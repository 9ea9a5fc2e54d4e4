// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// --derive in every command that opens data, and in view files.
#include "RunCommand.h"

#include <nlohmann/json.hpp>

using namespace brickwall;
using namespace brickwall::testing;
using nlohmann::json;

TEST(DeriveOption, IsListedByInfoWithTheVectors)
{
    const Outcome outcome = run("info sample:wake:60k --json --derive 'twice = 2 * speed' --derive 'more = twice + 1'");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const json info = json::parse(outcome.out);
    const json &more = info["fields"].back(), &speed = info["fields"][0];
    EXPECT_EQ(more["name"], "more");
    EXPECT_FLOAT_EQ(more["range"][1].get<float>(), 2 * speed["range"][1].get<float>() + 1);
    EXPECT_TRUE(info["vectors"].is_array());
}

TEST(DeriveOption, PointsAtTheCharacterThatIsWrong)
{
    const std::string definition = "q = sqrt(speed^2+)";
    const Outcome outcome = run("info sample:wake:60k --derive '" + definition + "'");
    EXPECT_EQ(outcome.exitCode, 2);
    EXPECT_NE(outcome.err.find("\n" + definition + "\n" + std::string(17, ' ') + "^\n"), std::string::npos)
        << outcome.err;
    EXPECT_EQ(messageOf(outcome),
              "brickwall: --derive: unexpected parenthesis ), at character 18 of \"" + definition + "\"\n");
    const Outcome unknown = run("info sample:wake:60k --derive 'q = nosuch'");
    EXPECT_EQ(unknown.exitCode, 2);
    EXPECT_NE(unknown.err.find("sample:wake:60k: there is no field 'nosuch'"), std::string::npos) << unknown.err;
    EXPECT_NE(unknown.err.find("\nq = nosuch\n    ^\n"), std::string::npos) << unknown.err;
}

TEST(DeriveOption, IsSampled)
{
    const auto points = scratchFolder() / "points.csv";
    write(points, "0.5,0.25,0.125\n");
    const auto valueOf = [&](const std::string& options) {
        const Outcome outcome = run("sample sample:wake:60k --points " + points.string() + options);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        const std::string line = outcome.out.substr(outcome.out.find('\n') + 1);
        return std::stod(line.substr(line.find("0.125,") + 6));
    };
    EXPECT_FLOAT_EQ(valueOf(" --derive 'q = 4 * speed' --field q"), 4 * valueOf(""));
}

TEST(DeriveOption, IsRenderedLikeTheFieldItself)
{
    const auto folder = scratchFolder();
    const std::string size = " --size 32x32 --format exr --range 0,1.5 --out ";
    ASSERT_EQ(run("render sample:wake:60k --field speed" + size + (folder / "a").string()).exitCode, 0);
    const Outcome outcome =
        run("render sample:wake:60k --derive 'q = speed' --field q" + size + (folder / "b").string());
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const auto& picture : std::filesystem::directory_iterator(folder / "a"))
        EXPECT_EQ(contentOf(picture.path()), contentOf(folder / "b" / picture.path().filename()));
}

TEST(DeriveOption, IsChartedAndVerifiedInViewFiles)
{
    const auto folder = scratchFolder();
    const std::string view = R"("views": [{"name": "v", "width": 8, "height": 8,
        "modelview": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,-5,1], "projection": [1,0,0,0, 0,1,0,0, 0,0,-1,-1, 0,0,-1,0]}]})";
    write(folder / "a.json", R"({"data": "sample:wake:60k", "derive": ["q = 2 * speed"], "field": "q", )" + view);
    const Outcome fine = run("verify " + (folder / "a.json").string());
    EXPECT_EQ(fine.exitCode, 0) << fine.err;
    write(folder / "b.json", R"({"data": "sample:wake:60k", "derive": "q = 2 * ", "field": "q", )" + view);
    const Outcome bad = run("verify " + (folder / "b.json").string());
    EXPECT_EQ(bad.exitCode, 2);
    EXPECT_NE(messageOf(bad).find("b.json: \"derive\": expected a value"), std::string::npos) << bad.err;
    const Outcome chart =
        run("chart sample:wake:60k --derive 'q = 2 * speed' --field q --methods fixed --dt 2 --repeat 1 "
            "--size 16x16 --out " +
            (folder / "chart").string());
    EXPECT_EQ(chart.exitCode, 0) << chart.err;
}
