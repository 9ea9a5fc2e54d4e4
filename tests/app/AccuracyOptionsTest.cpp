// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "RunCommand.h"

#include "brickwall/core/render/ImageFiles.h"

#include <nlohmann/json.hpp>

#include <algorithm>

using namespace brickwall;
using namespace brickwall::testing;
using nlohmann::json;

namespace {

const std::string sample = "sample:wake:50k";

std::string toRender(const std::string& options, const std::filesystem::path& folder)
{
    return "render " + sample + " --size 24x24 --out " + folder.string() + " " + options;
}

json statisticsOf(const std::string& options)
{
    const auto folder = scratchFolder();
    const auto stats = folder / "stats.json";
    const Outcome outcome = run(toRender(options, folder) + " --stats " + stats.string());
    EXPECT_EQ(outcome.exitCode, 0) << options << "\n" << outcome.err;
    return json::parse(contentOf(stats));
}

} // namespace

TEST(AccuracyOptions, StatisticsNameTheMethodAndItsParameter)
{
    const json byDefault = statisticsOf("")["method"];
    EXPECT_EQ(byDefault["name"], "bounded");
    EXPECT_NEAR(byDefault["tolerance"], 1.0 / 255.0, 1e-9);
    EXPECT_FALSE(byDefault.contains("dt"));
    EXPECT_NEAR(statisticsOf("--tolerance 1/64")["method"]["tolerance"], 1.0 / 64.0, 1e-9);
    EXPECT_NEAR(statisticsOf("--tolerance 1e-2")["method"]["tolerance"], 0.01, 1e-9);
    for (const char* name : {"fixed", "midpoint", "bracket", "preintegrated"}) {
        const json method = statisticsOf(std::string("--dt 0.25 --method ") + name)["method"];
        EXPECT_EQ(method, json({{"name", name}, {"dt", 0.25}, {"lod", 0.0}}));
    }
    const json reference = json::object({{"name", "reference"}});
    EXPECT_EQ(statisticsOf("--method reference")["method"], reference);
    const json light = statisticsOf("--light 0,1,2 --ambient 0.5 --light-tolerance 1/16")["method"]["light"];
    EXPECT_EQ(light, json({{"towards", {0.0, 1.0, 2.0}}, {"ambient", 0.5}, {"tolerance", 0.0625}}));
    const json look = statisticsOf("--specular 0.5 --ambient-occlusion 2")["method"];
    EXPECT_EQ(look["specular"], json({{"strength", 0.5}, {"shininess", 32.0}}));
    EXPECT_EQ(look["ambient_occlusion"], json({{"distance", 2.0}, {"rays", 16}}));
}

TEST(AccuracyOptions, StatisticsHoldCountsAndTheBound)
{
    const json view = statisticsOf("--tolerance 1e-3")["views"][0];
    for (const char* key : {"samples", "fetches", "regions_visited", "pieces_skipped", "pieces_merged", "pieces_split",
                            "surface_hits", "largest_bound", "pixels_beyond"})
        EXPECT_GE(view.at(key), 0) << key;
    EXPECT_EQ(view["beyond_because"].get<std::string>().empty(), view["pixels_beyond"] == 0);
    EXPECT_FALSE(statisticsOf("--method midpoint")["views"][0].contains("largest_bound"));
}

TEST(AccuracyOptions, ThePrintedSummarySaysHowItWasRendered)
{
    const auto folder = scratchFolder();
    EXPECT_NE(run(toRender("", folder)).out.find("bounded, tolerance 0.003922; error at most "), std::string::npos);
    EXPECT_NE(run(toRender("--method bracket --dt 0.25", folder)).out.find("bracket, dt 0.25"), std::string::npos);
    EXPECT_NE(run(toRender("--iso 0.5", folder)).out.find(" surface hits"), std::string::npos);
}

TEST(AccuracyOptions, WithoutVolumeAndSurfacesNothingIsSeenAndTheCommandSaysSo)
{
    for (const char* options : {"--volume off", "--opacity-scale 0"}) {
        const auto folder = scratchFolder();
        const Outcome outcome = run(toRender(std::string("--format exr ") + options, folder));
        ASSERT_EQ(outcome.exitCode, 0) << outcome.err;
        EXPECT_NE(outcome.err.find("nothing can be seen"), std::string::npos) << outcome.err;
        for (const vec4f& color : readExr((folder / "view.exr").string()).color)
            EXPECT_EQ(color, vec4f(0.0f));
    }
}

TEST(AccuracyOptions, AValueThatTheDataDoNotHaveIsANote)
{
    const Outcome outcome = run(toRender("--iso 0.5,-7", scratchFolder()));
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    EXPECT_NE(outcome.err.find("--iso -7: no surface"), std::string::npos) << outcome.err;
    EXPECT_EQ(outcome.err.find("--iso 0.5:"), std::string::npos) << outcome.err;
}

TEST(AccuracyOptions, SurfacesTakeOneColourForAllOrOneEach)
{
    for (const char* options : {"--iso 0.5", "--iso -0.5", "--iso 0.5,0.7 --iso-color 1,0,0 --iso-opacity 0.5",
                                "--iso 0.5,0.7 --iso-color 1,0,0 --iso-color 0,1,0 --iso-opacity 0.5,1",
                                "--iso 0.5 --iso 0.7 --iso-color 1,0,0,0,1,0 --volume off"}) {
        const Outcome outcome = run(toRender(options, scratchFolder()));
        EXPECT_EQ(outcome.exitCode, 0) << options << "\n" << outcome.err;
    }
    const json surfaces = statisticsOf("--iso 0.5,0.7 --iso-opacity 0.25,1")["surfaces"];
    ASSERT_EQ(surfaces.size(), 2u);
    EXPECT_EQ(surfaces[0]["opacity"], 0.25);
    EXPECT_NEAR(surfaces[1]["value"], 0.7, 1e-6);
}

TEST(AccuracyOptions, OutsideTheirLimitsAreRefusedInOneLine)
{
    const auto refused = [](const std::string& options, const std::string& said) {
        const Outcome outcome = run(toRender(options, scratchFolder()));
        EXPECT_EQ(outcome.exitCode, 2) << options;
        EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << options << "\n" << outcome.err;
        EXPECT_NE(messageOf(outcome).find(said), std::string::npos) << options << "\n" << outcome.err;
    };
    for (const char* tolerance : {"0", "-1", "1.5", "nan", "1e-60", "1/0", "2/1"})
        refused(std::string("--tolerance ") + tolerance, "--tolerance: expected a number above 0 and at most 1");
    for (const char* tolerance : {"abc", "1/", "/255", "1/255/3", "1e999"})
        refused(std::string("--tolerance ") + tolerance, "--tolerance: expected a number or a fraction");
    refused("--method magic", "bounded, fixed, midpoint, bracket, preintegrated, reference");
    refused("--dt 0.5", "--dt: has no effect on the method bounded");
    refused("--method reference --dt 0.5", "--dt: has no effect on the method reference");
    refused("--method midpoint --tolerance 0.1", "--tolerance: has no effect on the method midpoint");
    refused("--method midpoint --dt 1e-60", "--dt: expected");
    refused("--iso nan", "--iso: expected finite values");
    refused("--iso 1e99", "--iso: expected finite values");
    refused("--iso 0.5,0.5", "--iso: expected values that differ");
    refused("--iso-color 1,0,0", "--iso-color: expected --iso with it");
    refused("--iso 0.5 --iso-color 1,0", "--iso-color: expected 3 numbers");
    refused("--iso 0.5,0.6,0.7 --iso-color 1,0,0,0,1,0", "--iso-color: expected 3 numbers");
    refused("--iso 0.5 --iso-color 1,0,2", "--iso-color: expected numbers from 0 to 1");
    refused("--iso-opacity 0.5", "--iso-opacity: expected --iso with it");
    refused("--iso 0.5 --iso-opacity 0", "--iso-opacity: expected numbers above 0");
    refused("--iso 0.5,0.6,0.7 --iso-opacity 0.5,1", "--iso-opacity: expected 1 number");
    refused("--volume maybe", "--volume: expected on, off");
    refused("--mesh-color 1,0,0", "--mesh-color: expected --mesh with it");
    refused("--mesh ball.obj --mesh-scale 0", "--mesh-scale: expected a finite number above 0");
    refused("--mesh /no/such/ball.obj", "/no/such/ball.obj: there is no such file");
    refused("--light 0,0,0", "--light: expected X,Y,Z, finite");
    refused("--ambient 0.5", "--ambient: expected --light with it");
    refused("--specular 0.5 --shading off", "--specular: expected --light or --shading headlight with it");
    refused("--ambient-occlusion-rays 8", "--ambient-occlusion-rays: expected --ambient-occlusion with it");
    refused("--light 0,1,0 --ambient 2", "--ambient: expected a number from 0 to 1");
    refused("--plane-opacity 0.5", "--plane-opacity: expected --plane with it");
    refused("--plane 1,0,0", "--plane: expected X,Y,Z,OFFSET");
    refused("--clip-box 0,0,0,1,0,1", "--clip-box: expected X0,Y0,Z0,X1,Y1,Z1");
    refused("--clip-sphere 0,0,0,0", "--clip-sphere: expected X,Y,Z,RADIUS");
    refused("--opacity-scale -1", "--opacity-scale: expected");
    refused("--background 1,0", "--background: expected");
    refused("--range 1", "--range: expected");
    refused("--color-field pressure --color-range 1,1", "--color-range: expected LO < HI");
    refused("--color-range 0,1", "--color-range: expected --color-field with it");
}

TEST(AccuracyOptions, OfAViewFileHaveTheSameLimits)
{
    const auto folder = scratchFolder();
    const json views = json::parse(R"([{"name": "view", "width": 16, "height": 16,
        "modelview": [1,0,0,0, 0,1,0,0, 0,0,1,0, 0,0,-12,1],
        "projection": [1.5,0,0,0, 0,1.5,0,0, 0,0,-1.002,-1, 0,0,-0.2,0]}])");
    const auto verified = [&](json options) {
        options["data"] = sample;
        options["views"] = views;
        write(folder / "views.json", options.dump());
        return run("verify " + (folder / "views.json").string());
    };
    const auto refused = [&](const json& options, const std::string& said) {
        const Outcome outcome = verified(options);
        EXPECT_EQ(outcome.exitCode, 2) << options;
        EXPECT_NE(messageOf(outcome).find("views.json: \"" + said), std::string::npos) << outcome.err;
    };
    for (const json& options :
         {json{{"tolerance", "1/100"}}, json{{"tolerance", 0.01}}, json{{"iso", 0.5}},
          json{{"method", "midpoint"}, {"dt", 2}},
          json{{"iso", {0.5, 0.7}}, {"iso_color", {{1, 0, 0}, {0, 1, 0}}}, {"iso_opacity", 0.5}},
          json{{"iso", {0.5}}, {"volume", "off"}}, json{{"color_field", "pressure"}, {"color_range", {0, 0.5}}},
          json{{"light", {1, 2, 3}}, {"ambient", 0.5}, {"light_tolerance", "1/16"}},
          json{{"plane", {{1, 0, 0, 0.5}, {0, 1, 0, 0}}},
               {"plane_opacity", 0.5},
               {"clip_plane", {0, 0, 1, -1}},
               {"clip_box", {-9, -9, -9, 9, 9, 9}},
               {"clip_sphere", {0, 0, 0, 9}}}})
        EXPECT_EQ(verified(options).exitCode, 0) << options << verified(options).err;
    refused({{"tolerance", 2}}, "tolerance\": expected");
    refused({{"tolerance", "one"}}, "tolerance\": expected");
    refused({{"tolerance", json::array()}}, "tolerance\" has the wrong type");
    refused({{"dt", 0.5}}, "dt\": has no effect");
    refused({{"method", "midpoint"}, {"tolerance", 0.1}}, "tolerance\": has no effect");
    refused({{"iso", "high"}}, "iso\" has the wrong type");
    refused({{"iso", {0.5, 0.7}}, {"iso_color", {1, 0}}}, "iso_color\": expected");
    refused({{"iso_opacity", 0.5}}, "iso_opacity\": expected");
    refused({{"volume", "maybe"}}, "volume\": expected");
    refused({{"light", {0, 0, 0}}}, "light\": expected");
    refused({{"clip_box", {0, 0, 0, 1}}}, "clip_box\": expected");
}
