// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "RunCommand.h"

#include <pugixml.hpp>

#include <algorithm>
#include <string>
#include <vector>

using namespace brickwall;
using namespace brickwall::testing;

namespace {

std::string flightFile(const std::string& keys)
{
    const auto path = scratchFolder() / "flight.json";
    write(path, R"({"units": "bounds", "fov": 40, "keys": [)" + keys + "]}");
    return path.string();
}

const std::string twoSeconds = R"({"time": 3, "eye": [0.5, 0.5, 3], "at": [0.5, 0.5, 0.5]},
    {"time": 4.5, "eye": [0.2, 0.6, 1.2], "at": [0.5, 0.5, 0.5]},
    {"time": 5, "eye": [0.4, 0.5, 0.8], "at": [0.6, 0.5, 0.4], "up": [0, 1, 0.1]})";

std::vector<std::string> linesOf(const std::string& text)
{
    std::istringstream stream(text);
    std::vector<std::string> lines;
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

Outcome fly(const std::string& keys, const std::string& options = "")
{
    return run("flight sample:wake:50k --flight " + flightFile(keys) + " --size 48x32 --out " +
               (scratchFolder() / "out").string() + options);
}

TEST(Flight, WritesARowPerFrameOfBothRulesAndAPictureOfThem)
{
    const Outcome outcome = fly(twoSeconds, " --fps 30 --compare --measure 3");
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    const auto lines = linesOf(contentOf(scratchFolder() / "out" / "flight.csv"));
    ASSERT_GT(lines.size(), 10u);
    const auto columns = std::count(lines[0].begin(), lines[0].end(), ',');
    int held = 0, earlier = 0;
    for (std::size_t i = 1; i < lines.size(); ++i) {
        EXPECT_EQ(std::count(lines[i].begin(), lines[i].end(), ','), columns) << lines[i];
        held += lines[i].rfind("held,", 0) == 0;
        earlier += lines[i].rfind("earlier,", 0) == 0;
    }
    EXPECT_GT(held, 2);
    EXPECT_GT(earlier, 2);
    pugi::xml_document svg;
    ASSERT_TRUE(svg.load_file((scratchFolder() / "out" / "flight.svg").c_str()));
    EXPECT_GE(svg.select_nodes("//*[local-name()='polyline']").size(), 6u) << "time, levers and error of both";
}

TEST(Flight, WhatIsWrongWithAFlightIsSaidWithItsPlace)
{
    const auto message = [](const std::string& keys) {
        const Outcome outcome = fly(keys);
        EXPECT_EQ(outcome.exitCode, 2);
        return messageOf(outcome);
    };
    const std::string key = R"({"time": 0, "eye": [0, 0, 3], "at": [0, 0, 0]})";
    EXPECT_NE(message(key).find("two or more"), std::string::npos);
    EXPECT_NE(message(key + "," + key).find("key 2: expected a later"), std::string::npos);
    EXPECT_NE(message(key + R"(, {"time": 1, "eye": [0, 0], "at": [0, 0, 0]})").find("key 2: expected three numbers"),
              std::string::npos);
    EXPECT_NE(message(key + R"(, {"time": 1, "eye": [0, 2, 0], "at": [0, 0, 0]})").find("key 2: expected an eye"),
              std::string::npos);
    EXPECT_NE(message(key + R"(, {"time": 1, "speed": 3})").find("unknown key \"speed\""), std::string::npos);
}

TEST(Flight, FramesPerSecondBeyondTheSliderAreRefused)
{
    EXPECT_EQ(fly(twoSeconds, " --fps 3").exitCode, 2);
    EXPECT_EQ(fly(twoSeconds, " --clock processor --threads 2").exitCode, 2);
    EXPECT_EQ(run("view sample:wake:50k --fps 61").exitCode, 2);
    EXPECT_EQ(run("view sample:wake:50k --fps fast").exitCode, 2);
}

} // namespace
