// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "RunCommand.h"

#include <nlohmann/json.hpp>
#include <pugixml.hpp>

#include <algorithm>
#include <map>

using namespace brickwall;
using namespace brickwall::testing;
using nlohmann::json;

namespace {

const std::string sample = "sample:wake:50k";
const std::string small = " --size 32x32 --dt 2,0.5,0.1 --tolerance 1e-1,1/255";

using Row = std::map<std::string, std::string>;

std::vector<std::string> cellsOf(const std::string& line)
{
    std::vector<std::string> cells{""};
    for (const char c : line)
        if (c == ',')
            cells.emplace_back();
        else
            cells.back() += c;
    return cells;
}

/// The rows of a chart.csv without quoted cells, by the names of the columns.
std::vector<Row> rowsOf(const std::filesystem::path& path)
{
    std::istringstream lines(contentOf(path));
    std::string line;
    std::getline(lines, line);
    const std::vector<std::string> names = cellsOf(line);
    std::vector<Row> rows;
    while (std::getline(lines, line)) {
        const std::vector<std::string> cells = cellsOf(line);
        EXPECT_EQ(cells.size(), names.size()) << line;
        for (Row& row = rows.emplace_back(); const std::string& name : names)
            row[name] = cells.at(row.size());
    }
    return rows;
}

/// A chart that several tests read, made once per run.
struct MadeChart
{
    std::filesystem::path folder = scratchFolder() / "chart";
    Outcome outcome = run("chart " + sample + small + " --repeat 2 --slow 1000 --out " + folder.string());
};

const MadeChart& made()
{
    static const MadeChart chart;
    return chart;
}

} // namespace

TEST(ChartCommand, WritesARowPerMethodParameterAndView)
{
    ASSERT_EQ(made().outcome.exitCode, 0) << made().outcome.err;
    std::map<std::string, int> count;
    for (const Row& row : rowsOf(made().folder / "chart.csv")) {
        ++count[row.at("method") + " " + row.at("view")];
        EXPECT_LE(std::stod(row.at("min_ms")), std::stod(row.at("median_ms")));
        EXPECT_LE(std::stod(row.at("median_ms")), std::stod(row.at("max_ms")));
        EXPECT_EQ(row.at("repetitions"), row.at("method") == "reference" ? "1" : "2");
    }
    for (const char* view : {"outside", "inside"}) {
        for (const char* method : {"fixed", "midpoint", "bracket", "preintegrated"})
            EXPECT_EQ(count[std::string(method) + " " + view], 3) << method;
        EXPECT_EQ(count[std::string("bounded ") + view], 2);
        EXPECT_EQ(count[std::string("reference ") + view], 1);
    }
    EXPECT_EQ(count.size(), 12u);
}

TEST(ChartCommand, ErrorsAreThoseAgainstTheReference)
{
    ASSERT_EQ(made().outcome.exitCode, 0) << made().outcome.err;
    std::map<std::string, double> lastOfMidpoint; // per view; rows go from large to small steps
    for (const Row& row : rowsOf(made().folder / "chart.csv")) {
        const double rms = std::stod(row.at("rms_error"));
        EXPECT_LE(rms, std::stod(row.at("max_error")));
        if (row.at("method") == "reference") {
            EXPECT_EQ(std::stod(row.at("max_error")), 0.0);
            EXPECT_EQ(std::stod(row.at("ssim")), 1.0);
        } else if (row.at("method") == "midpoint") {
            if (lastOfMidpoint.contains(row.at("view"))) {
                EXPECT_LT(rms, 0.5 * lastOfMidpoint.at(row.at("view"))) << row.at("parameter");
            }
            lastOfMidpoint[row.at("view")] = rms;
        }
    }
    EXPECT_EQ(lastOfMidpoint.size(), 2u);
}

TEST(ChartCommand, DrawsEveryMethodAndTheStepsOfMidpoint)
{
    ASSERT_EQ(made().outcome.exitCode, 0) << made().outcome.err;
    pugi::xml_document svg;
    const auto parsed = svg.load_file((made().folder / "chart.svg").c_str());
    ASSERT_TRUE(parsed) << parsed.description();
    std::string text;
    for (const auto& found : svg.select_nodes("//text"))
        text += std::string(found.node().child_value()) + "\n";
    for (const char* said : {"bounded (tolerance)", "fixed (dt)", "midpoint (dt)", "bracket (dt)", "preintegrated (dt)",
                             "the reference took", "maximum error", "RMS error", "1 - SSIM", "milliseconds per frame",
                             "dt of midpoint", "outside: 32 x 32", "inside: 32 x 32", "1/255"})
        EXPECT_NE(text.find(said), std::string::npos) << said;
    const double width = svg.child("svg").attribute("width").as_double();
    const double height = svg.child("svg").attribute("height").as_double();
    for (const auto& found : svg.select_nodes("//text")) {
        EXPECT_GT(found.node().attribute("x").as_double(), 0.0);
        EXPECT_LT(found.node().attribute("x").as_double(), width);
        EXPECT_GT(found.node().attribute("y").as_double(), 0.0);
        EXPECT_LT(found.node().attribute("y").as_double(), height);
    }
}

TEST(ChartCommand, SaysWhatWasMeasuredWhere)
{
    ASSERT_EQ(made().outcome.exitCode, 0) << made().outcome.err;
    const json chart = json::parse(contentOf(made().folder / "chart.json"));
    EXPECT_EQ(chart["data"], sample);
    EXPECT_EQ(chart["field"], "speed");
    EXPECT_EQ(chart["repeat"], 2);
    EXPECT_GE(chart["machine"]["cores"], 1);
    EXPECT_FALSE(chart["machine"]["target"].get<std::string>().empty());
    ASSERT_EQ(chart["views"].size(), 2u);
    EXPECT_GT(chart["views"][1]["reference_milliseconds"], 0.0);
}

TEST(ChartCommandOptions, LightAndAmbientOcclusionAreInTimesErrorsAndTheFile)
{
    // Once the chart showed the scene without them, whatever was asked for.
    const auto folder = scratchFolder() / "lit";
    const auto errorOf = [&](const std::string& look) {
        const Outcome outcome = run("chart sample:wake:50k --size 16x16 --methods bounded --tolerance 1e-3 --repeat 1 "
                                    "--iso 0.9 --camera=-4,3,5,0,0,0,0,1,0 --out " +
                                    folder.string() + " " + look);
        EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
        for (const Row& row : rowsOf(folder / "chart.csv"))
            if (row.at("method") == "bounded")
                return std::stod(row.at("rms_error"));
        return -1.0;
    };
    const double coarse = errorOf("--light 1,2,1 --light-tolerance 1/4"),
                 fine = errorOf("--light 1,2,1 --light-tolerance 1/256");
    EXPECT_GT(coarse, 2.0 * fine) << "against a light that is known well";
    EXPECT_EQ(json::parse(contentOf(folder / "chart.json"))["light"]["tolerance"], 1.0 / 256.0);
    const double few = errorOf("--ambient-occlusion 1 --ambient-occlusion-rays 1"),
                 many = errorOf("--ambient-occlusion 1 --ambient-occlusion-rays 64");
    EXPECT_GT(few, 2.0 * many) << "against many rays";
}

TEST(ChartCommandOptions, SelectMethodsViewsAndSurfaces)
{
    const auto folder = scratchFolder();
    const Outcome outcome = run("chart " + sample + " --size 16x16 --methods midpoint --dt 1 --repeat 1 --iso 0.5" +
                                " --camera 0,0,12,0,0,0,0,1,0 --shading off --out " + folder.string());
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_EQ(rowsOf(folder / "chart.csv").size(), 2u) << "one point and the reference";
    const json chart = json::parse(contentOf(folder / "chart.json"));
    EXPECT_EQ(chart["shading"], "off");
    EXPECT_EQ(chart["surfaces"][0]["value"], 0.5);
}

TEST(ChartCommandOptions, SlowPointsAreRenderedOnceAndTheTableSaysSo)
{
    const auto folder = scratchFolder();
    const Outcome outcome = run("chart " + sample + " --size 16x16 --methods midpoint --dt 1,2 --repeat 3 --slow 0" +
                                " --camera 0,0,12,0,0,0,0,1,0 --out " + folder.string());
    ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
    for (const Row& row : rowsOf(folder / "chart.csv")) {
        EXPECT_EQ(row.at("repetitions"), "1");
        EXPECT_EQ(row.at("note").find("rendered once"), 0u) << row.at("note");
    }
}

TEST(ChartCommandOptions, OutsideTheirLimitsAreRefusedInOneLine)
{
    const auto refused = [](const std::string& options, const std::string& said) {
        const Outcome outcome = run("chart " + sample + " --out " + scratchFolder().string() + " " + options);
        EXPECT_EQ(outcome.exitCode, 2) << options;
        const std::string message = messageOf(outcome);
        EXPECT_EQ(std::count(message.begin(), message.end(), '\n'), 1) << options << "\n" << outcome.err;
        EXPECT_NE(message.find(said), std::string::npos) << options << "\n" << outcome.err;
    };
    refused("--methods magic", "--methods: expected bounded, fixed");
    refused("--methods reference", "--methods: reference is what");
    refused("--methods midpoint,midpoint", "--methods: midpoint is there twice");
    refused("--dt 0", "--dt: expected a finite number above 0");
    refused("--dt 1,1", "--dt: 1 is there twice");
    refused("--tolerance 1e-3,2", "--tolerance: expected a number above 0");
    refused("--tolerance abc", "--tolerance: expected a number or a fraction");
    refused("--repeat 0", "--repeat");
    refused("--slow -1", "--slow");
    refused("--size 8x32", "11 x 11 pixels");
    refused("--method midpoint", "--method");
    refused("--iso-opacity 0.5", "--iso-opacity");
}
