// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "ViewFile.h"

#include "JsonNode.h"

#include "brickwall/core/base/WholeFile.h"
#include "brickwall/core/render/Compare.h"
#include "brickwall/core/render/ImageFiles.h"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <cmath>
#include <filesystem>
#include <set>
#include <utility>

namespace brickwall {
namespace {

using nlohmann::json;
using Node = JsonNode;

constexpr int largestSize = 32768;

mat4d matrixOf(const Node& node, const char* key)
{
    const auto numbers = node.get<std::vector<double>>(key);
    if (numbers.size() != 16)
        throw Error(node.place(), fmt::format("\"{}\" needs 16 numbers (column-major), found {}", key, numbers.size()));
    mat4d m;
    for (int i = 0; i < 16; ++i)
        m[i / 4][i % 4] = numbers[static_cast<std::size_t>(i)];
    return m;
}

int sizeOf(const Node& node, const char* key)
{
    const auto n = node.get<double>(key);
    if (!(n >= 1.0 && n <= largestSize) || n != std::floor(n))
        throw Error(node.place(),
                    fmt::format("\"{}\" must be a whole number from 1 to {}, found {}", key, largestSize, n));
    return static_cast<int>(n);
}

ExpectedHit hitOf(const json& value, const std::string& place, const View& view)
{
    const Node node(value, place, {"pixel", "depth", "tolerance"});
    const auto pixel = node.get<std::vector<int>>("pixel");
    if (pixel.size() != 2 || pixel[0] < 0 || pixel[1] < 0 || pixel[0] >= view.window.width ||
        pixel[1] >= view.window.height)
        throw Error(place, fmt::format("\"pixel\" must be [x, y] inside the view, found {}", node.at("pixel").dump()));
    ExpectedHit hit{pixel[0], pixel[1], node.get<double>("depth")};
    node.maybe("tolerance", hit.tolerance);
    return hit;
}

Expectation expectationOf(const json& value, const std::string& place, const std::filesystem::path& folder,
                          const View& view)
{
    const Node node(value, place, {"image", "mean", "max", "psnr", "alpha_sum", "alpha_tolerance", "hit", "hits"});
    Expectation expect;
    if (node.has("image"))
        expect.image = (folder / node.get<std::string>("image")).string();
    node.maybe("mean", expect.meanDifference);
    node.maybe("max", expect.maxDifference);
    node.maybe("psnr", expect.psnr);
    if (expect.image.empty() && (expect.meanDifference || expect.maxDifference || expect.psnr))
        throw Error(place, "mean, max and psnr need an \"image\" to compare with");
    if (!expect.image.empty() && !expect.meanDifference && !expect.maxDifference && !expect.psnr)
        throw Error(place, "an \"image\" needs \"mean\", \"max\" or \"psnr\": how close it has to be");
    node.maybe("alpha_sum", expect.alphaSum);
    node.maybe("alpha_tolerance", expect.alphaTolerance);
    if (node.has("hit"))
        expect.hits.push_back(hitOf(node.at("hit"), place + " hit", view));
    if (node.has("hits"))
        for (const json& hit : node.at("hits"))
            expect.hits.push_back(hitOf(hit, place + " hits", view));
    return expect;
}

ScriptedView viewOf(const json& value, const std::string& place, const std::filesystem::path& folder)
{
    const Node node(value, place, {"name", "width", "height", "modelview", "projection", "expect"});
    const auto name = node.get<std::string>("name");
    const mat4d modelview = matrixOf(node, "modelview"), projection = matrixOf(node, "projection");
    const int width = sizeOf(node, "width"), height = sizeOf(node, "height");
    ScriptedView scripted;
    try {
        scripted.view = viewOfMatrices(name, modelview, projection, width, height);
    } catch (const Error& error) { // it knows the view, but not the file
        throw Error(place, error.what());
    }
    if (node.has("expect"))
        scripted.expect = expectationOf(node.at("expect"), fmt::format("{} expect", place), folder, scripted.view);
    return scripted;
}

json parse(const std::string& path)
{
    try {
        return json::parse(readWholeFile(path));
    } catch (const json::exception& error) {
        throw Error(path, error.what());
    }
}

/// A number or a list of them; lists of lists are joined.
void readNumbers(const json& value, std::vector<double>& numbers)
{
    if (value.is_array())
        for (const json& item : value)
            readNumbers(item, numbers);
    else
        numbers.push_back(value.get<double>());
}

void maybeNumbers(const Node& node, const char* key, std::vector<double>& numbers)
{
    if (!node.has(key))
        return;
    try {
        readNumbers(node.at(key), numbers);
    } catch (const json::exception&) {
        throw Error(node.place(), fmt::format("\"{}\" has the wrong type, found {}", key, node.at(key).dump()));
    }
}

/// A text or a list of them.
void maybeTexts(const Node& node, const char* key, std::vector<std::string>& texts)
{
    if (node.has(key) && node.at(key).is_string())
        texts = {node.get<std::string>(key)};
    else
        node.maybe(key, texts);
}

SceneOptions sceneOf(const Node& node, const std::filesystem::path& folder)
{
    SceneOptions scene;
    node.maybe("data", scene.data);
    if (!scene.data.empty() && scene.data.rfind("sample:", 0) != 0)
        scene.data = (folder / scene.data).string();
    maybeTexts(node, "derive", scene.derive);
    node.maybe("field", scene.field);
    node.maybe("non_finite", scene.nonFinite);
    if (node.has("tf"))
        scene.transferFunction = (folder / node.get<std::string>("tf")).string();
    node.maybe("colormap", scene.colorMap);
    node.maybe("range", scene.range);
    node.maybe("color_field", scene.colorField);
    node.maybe("color_range", scene.colorRange);
    node.maybe("opacity_scale", scene.opacityScale);
    node.maybe("shading", scene.shading);
    node.maybe("volume", scene.volume);
    maybeNumbers(node, "iso", scene.iso);
    maybeNumbers(node, "iso_color", scene.isoColors);
    maybeNumbers(node, "iso_opacity", scene.isoOpacity);
    maybeTexts(node, "mesh", scene.meshes);
    for (std::string& mesh : scene.meshes)
        mesh = (folder / mesh).string();
    node.maybe("mesh_scale", scene.meshScale);
    maybeNumbers(node, "mesh_offset", scene.meshOffset);
    maybeNumbers(node, "mesh_color", scene.meshColor);
    maybeNumbers(node, "light", scene.light);
    node.maybe("ambient", scene.ambient);
    node.maybe("specular", scene.specular);
    node.maybe("shininess", scene.shininess);
    node.maybe("ambient_occlusion", scene.ambientOcclusion);
    node.maybe("ambient_occlusion_rays", scene.ambientOcclusionRays);
    maybeNumbers(node, "plane", scene.planes);
    node.maybe("plane_opacity", scene.planeOpacity);
    maybeTexts(node, "streamlines", scene.streamlines);
    node.maybe("streamline_vector", scene.streamlineVector);
    node.maybe("streamline_length", scene.streamlineLength);
    node.maybe("streamline_radius", scene.streamlineRadius);
    maybeNumbers(node, "clip_plane", scene.clipPlanes);
    maybeNumbers(node, "clip_box", scene.clipBox);
    maybeNumbers(node, "clip_sphere", scene.clipSphere);
    node.maybe("method", scene.method);
    node.maybe("dt", scene.dt);
    node.maybe("lod", scene.lod);
    const auto placeOf = [&](std::string_view key) { return fmt::format("{}: \"{}\"", node.place(), key); };
    const auto fractionOf = [&](const char* key) {
        return node.at(key).is_string() ? parseNumber(node.get<std::string>(key), placeOf(key)) : node.get<double>(key);
    };
    if (node.has("tolerance"))
        scene.tolerance = fractionOf("tolerance");
    if (node.has("light_tolerance"))
        scene.lightTolerance = fractionOf("light_tolerance");
    checkSceneOptions(scene, placeOf);
    return scene;
}

std::string check(const char* what, double found, double limit, bool atMost)
{
    // Written so that a NaN fails either way.
    if (atMost ? found <= limit : found >= limit)
        return {};
    return fmt::format("{} is {:.6g}, expected at {} {:.6g}", what, found, atMost ? "most" : "least", limit);
}

} // namespace

ViewFile readViewFile(const std::string& path)
{
    const json root = parse(path);
    const std::filesystem::path folder = std::filesystem::path(path).parent_path();
    const Node node(root, path,
                    {"data",
                     "derive",
                     "field",
                     "non_finite",
                     "tf",
                     "color_field",
                     "color_range",
                     "colormap",
                     "range",
                     "opacity_scale",
                     "shading",
                     "volume",
                     "iso",
                     "iso_color",
                     "iso_opacity",
                     "mesh",
                     "mesh_scale",
                     "mesh_offset",
                     "mesh_color",
                     "light",
                     "ambient",
                     "light_tolerance",
                     "specular",
                     "shininess",
                     "ambient_occlusion",
                     "ambient_occlusion_rays",
                     "plane",
                     "plane_opacity",
                     "streamlines",
                     "streamline_vector",
                     "streamline_length",
                     "streamline_radius",
                     "clip_plane",
                     "clip_box",
                     "clip_sphere",
                     "method",
                     "tolerance",
                     "dt",
                     "lod",
                     "views"});
    ViewFile file;
    file.path = path;
    file.scene = sceneOf(node, folder);

    const json& views = node.at("views");
    if (!views.is_array() || views.empty())
        throw Error(path, "\"views\" must be a list of at least one view");
    std::set<std::string> names;
    for (std::size_t i = 0; i < views.size(); ++i) {
        const std::string place = fmt::format("{}: view {}", path, i);
        file.views.push_back(viewOf(views[i], place, folder));
        if (!names.insert(file.views.back().view.name).second)
            throw Error(place, fmt::format("the name \"{}\" is there twice", file.views.back().view.name));
    }
    return file;
}

std::vector<std::string> failuresOf(const Expectation& expect, const Frame& frame)
{
    std::vector<std::string> failures;
    const auto add = [&](std::string line) {
        if (!line.empty())
            failures.push_back(std::move(line));
    };
    if (!expect.image.empty()) {
        const FrameDifference difference = compareFrames(frame, readExr(expect.image));
        if (expect.meanDifference)
            add(check("mean difference", difference.mean, *expect.meanDifference, true));
        if (expect.maxDifference)
            add(check("largest difference", difference.max, *expect.maxDifference, true));
        if (expect.psnr)
            add(check("PSNR", difference.psnr, *expect.psnr, false));
    }
    if (expect.alphaSum) {
        double sum = 0.0;
        for (const vec4f& c : frame.color)
            sum += c.a;
        const double allowed = expect.alphaTolerance * std::abs(*expect.alphaSum);
        if (!(std::abs(sum - *expect.alphaSum) <= allowed))
            add(fmt::format("sum of alpha is {:.6g}, expected {:.6g} +- {:.3g}", sum, *expect.alphaSum, allowed));
    }
    for (const ExpectedHit& hit : expect.hits) {
        const double depth = frame.depth[frame.index(hit.x, hit.y)];
        if (!(std::abs(depth - hit.depth) <= hit.tolerance))
            add(fmt::format("depth at pixel {}, {} is {:.7g}, expected {:.7g} +- {:.3g}", hit.x, hit.y, depth,
                            hit.depth, hit.tolerance));
    }
    return failures;
}

} // namespace brickwall
