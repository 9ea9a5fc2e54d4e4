// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "RunCommand.h"

#include "brickwall/core/render/ImageFiles.h"
#include "brickwall/core/render/View.h"

#include <nlohmann/json.hpp>

#include <utility>

using namespace brickwall;
using namespace brickwall::testing;
using nlohmann::json;

namespace {

json numbers(const mat4d& m)
{
    json list = json::array();
    for (int i = 0; i < 16; ++i)
        list.push_back(m[i / 4][i % 4]);
    return list;
}

/// Two eyes in front of one screen, looking at the sample; the data are about 10 x 5 x 5 with the origin inside.
json script()
{
    json views = json::array();
    for (const auto& [name, x] : {std::pair{"left", -0.4}, std::pair{"right", 0.4}}) {
        const vec3d eye(x, 0.0, 12.0), ll(-3, -3, 4), lr(3, -3, 4), ur(3, 3, 4);
        views.push_back({{"name", name},
                         {"width", 48},
                         {"height", 40},
                         {"modelview", numbers(modelviewOfScreen(eye, ll, lr, ur))},
                         {"projection", numbers(projectionOfScreen(eye, ll, lr, ur, 0.1, 100.0))}});
    }
    return {{"data", "sample:wake:60k"}, {"shading", "off"}, {"views", views}};
}

/// Renders the script once and writes expectations from it: what a user does with a renderer that is trusted.
json scriptWithExpectations(const std::filesystem::path& folder)
{
    json s = script();
    write(folder / "views.json", s.dump());
    const Outcome outcome = run("render sample:wake:60k --shading off --views " + (folder / "views.json").string() +
                                " --format exr --out " + folder.string());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.err;
    for (json& view : s["views"]) {
        const std::string image = view["name"].get<std::string>() + ".exr";
        const Frame frame = readExr((folder / image).string());
        double alpha = 0.0;
        for (const vec4f& color : frame.color)
            alpha += color.a;
        view["expect"] = {
            {"image", image},     {"max", 1e-6},
            {"mean", 1e-7},       {"psnr", 90},
            {"alpha_sum", alpha}, {"hit", {{"pixel", {24, 20}}, {"depth", frame.depth[frame.index(24, 20)]}}}};
    }
    return s;
}

} // namespace

TEST(VerifyCommand, PassesWhatIsAsExpected)
{
    const auto folder = scratchFolder();
    write(folder / "views.json", scriptWithExpectations(folder).dump(2));
    const Outcome outcome = run("verify " + (folder / "views.json").string());
    EXPECT_EQ(outcome.exitCode, 0) << outcome.out << outcome.err;
    EXPECT_NE(outcome.out.find("2 views, 2 as expected, 0 not"), std::string::npos) << outcome.out;
}

TEST(VerifyCommand, FindsSwappedEyesWrongDepthAndWrongAlpha)
{
    const auto folder = scratchFolder();
    const json good = scriptWithExpectations(folder);

    json swapped = good;
    std::swap(swapped["views"][0]["expect"], swapped["views"][1]["expect"]);
    write(folder / "swapped.json", swapped.dump());
    EXPECT_EQ(run("verify " + (folder / "swapped.json").string()).exitCode, 1);

    json depth = good;
    depth["views"][0]["expect"]["hit"]["depth"] = 0.25;
    write(folder / "depth.json", depth.dump());
    const Outcome outcome = run("verify " + (folder / "depth.json").string());
    EXPECT_EQ(outcome.exitCode, 1);
    EXPECT_NE(outcome.out.find("depth at pixel 24, 20"), std::string::npos) << outcome.out;

    json alpha = good;
    alpha["views"][1]["expect"]["alpha_sum"] = alpha["views"][1]["expect"]["alpha_sum"].get<double>() * 1.01 + 1;
    write(folder / "alpha.json", alpha.dump());
    EXPECT_EQ(run("verify " + (folder / "alpha.json").string()).exitCode, 1);
}

TEST(VerifyCommand, RefusesABrokenScript)
{
    const auto folder = scratchFolder();
    const auto refused = [&](const std::string& name, const json& s, const std::string& said) {
        write(folder / name, s.dump());
        const Outcome outcome = run("verify " + (folder / name).string());
        EXPECT_EQ(outcome.exitCode, 2) << name;
        EXPECT_NE(messageOf(outcome).find(said), std::string::npos) << outcome.err;
    };
    json s = script();
    s["views"][0]["modelview"].erase(0);
    refused("short.json", s, "16 numbers");
    s = script();
    s["views"][1]["projection"] = std::vector<double>(16, 0.0);
    refused("singular.json", s, "right");
    for (const auto& [key, value] : std::initializer_list<std::pair<const char*, json>>{
             {"range", {1, 2, 3}}, {"range", {2, 1}}, {"method", "magic"}, {"shading", "loud"}, {"dt", -1}}) {
        s = script();
        s[key] = value;
        refused("options.json", s, std::string("options.json: \"") + key);
    }
    s = script();
    s["views"][0]["expects"] = json::object();
    refused("typo.json", s, "expects");
    s = script();
    s["views"][0]["expect"] = {{"psnr", 30}};
    refused("noimage.json", s, "image");
    s = script();
    s["views"][1]["name"] = "left";
    refused("twice.json", s, "twice");
    s = script();
    s.erase("data");
    refused("nodata.json", s, "data");
}
