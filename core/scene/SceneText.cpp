// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/scene/SceneText.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/scene/SceneArguments.h"

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace brickwall {
namespace {

constexpr std::string_view blanks = " \t\n";

/// Separated by blanks, except between quotes, which vanish.
std::vector<std::string> wordsOf(std::string_view text)
{
    std::vector<std::string> words;
    std::string word;
    bool inWord = false;
    char quote = 0;
    for (const char c : text) {
        if (quote ? c == quote : c == '"' || c == '\'') {
            quote = quote ? 0 : c;
            inWord = true;
        } else if (!quote && blanks.find(c) != blanks.npos) {
            if (std::exchange(inWord, false))
                words.push_back(std::exchange(word, {}));
        } else {
            word += c;
            inWord = true;
        }
    }
    if (quote)
        throw Error("options", fmt::format("a quote ({}) is not closed in: {}", quote, text));
    if (inWord)
        words.push_back(word);
    return words;
}

/// A word for every option that is not as it was at the start.
class Line
{
public:
    template <class T>
    void add(const char* key, const T& value, const T& otherwise)
    {
        if (value != otherwise)
            addWord(key, textOf(value));
    }
    void addWord(const char* key, const std::string& value)
    {
        const bool plain = !value.empty() && value.find_first_of(" \t\n'\"") == std::string::npos;
        const char quote = value.find('"') == std::string::npos ? '"' : '\'';
        line_ += line_.empty() ? "" : " ";
        line_ += plain ? fmt::format("{}={}", key, value) : fmt::format("{}={}{}{}", key, quote, value, quote);
    }
    std::string take() { return std::move(line_); }

private:
    static std::string textOf(const std::string& value) { return value; }
    static std::string textOf(double value) { return fmt::format("{}", value); }
    static std::string textOf(int value) { return fmt::format("{}", value); }
    static std::string textOf(const std::vector<double>& values) { return fmt::format("{}", fmt::join(values, ",")); }
    static std::string textOf(const std::optional<double>& value) { return fmt::format("{}", value.value()); }

    std::string line_;
};

} // namespace

std::vector<std::string> readSceneText(std::string_view text, SceneOptions& options)
{
    SceneOptions changed = options;
    CLI::App app;
    addDeriveOption(app, changed);
    addSceneOptions(app, changed);
    addBackgroundOption(app, changed);
    addMethodOptions(app, changed);

    std::vector<std::string> unknown, arguments;
    for (const std::string& word : wordsOf(text)) {
        const std::size_t equals = word.find('=');
        std::string name = "--" + word.substr(0, equals);
        std::replace(name.begin(), name.end(), '_', '-');
        if (equals == std::string::npos || name == "--help" || !app.get_option_no_throw(name))
            unknown.push_back(word);
        else
            arguments.push_back(name + word.substr(equals));
    }
    std::reverse(arguments.begin(), arguments.end()); // CLI11 takes them from the back
    try {
        app.parse(std::move(arguments));
    } catch (const CLI::ParseError& error) {
        throw Error("options", error.what());
    }
    checkSceneOptions(changed, commandLinePlace);
    options = std::move(changed);
    return unknown;
}

std::string sceneText(const SceneOptions& options)
{
    const SceneOptions start;
    Line line;
    for (const std::string& field : options.derive)
        line.addWord("derive", field);
    line.add("field", options.field, start.field);
    line.add("non-finite", options.nonFinite, start.nonFinite);
    line.add("tf", options.transferFunction, start.transferFunction);
    line.add("colormap", options.colorMap, start.colorMap);
    line.add("range", options.range, start.range);
    line.add("color-field", options.colorField, start.colorField);
    line.add("color-range", options.colorRange, start.colorRange);
    line.add("opacity-scale", options.opacityScale, start.opacityScale);
    line.add("shading", options.shading, start.shading);
    line.add("volume", options.volume, start.volume);
    line.add("iso", options.iso, start.iso);
    line.add("iso-color", options.isoColors, start.isoColors);
    line.add("iso-opacity", options.isoOpacity, start.isoOpacity);
    for (const std::string& mesh : options.meshes)
        line.addWord("mesh", mesh);
    line.add("mesh-scale", options.meshScale, start.meshScale);
    line.add("mesh-offset", options.meshOffset, start.meshOffset);
    line.add("mesh-color", options.meshColor, start.meshColor);
    line.add("light", options.light, start.light);
    line.add("ambient", options.ambient, start.ambient);
    line.add("light-tolerance", options.lightTolerance, start.lightTolerance);
    line.add("specular", options.specular, start.specular);
    line.add("shininess", options.shininess, start.shininess);
    line.add("ambient-occlusion", options.ambientOcclusion, start.ambientOcclusion);
    line.add("ambient-occlusion-rays", options.ambientOcclusionRays, start.ambientOcclusionRays);
    line.add("plane", options.planes, start.planes);
    line.add("plane-opacity", options.planeOpacity, start.planeOpacity);
    for (const std::string& seeds : options.streamlines)
        line.addWord("streamlines", seeds);
    line.add("streamline-vector", options.streamlineVector, start.streamlineVector);
    line.add("streamline-length", options.streamlineLength, start.streamlineLength);
    line.add("streamline-radius", options.streamlineRadius, start.streamlineRadius);
    line.add("clip-plane", options.clipPlanes, start.clipPlanes);
    line.add("clip-box", options.clipBox, start.clipBox);
    line.add("clip-sphere", options.clipSphere, start.clipSphere);
    line.add("background", options.background, start.background);
    line.add("method", options.method, start.method);
    line.add("tolerance", options.tolerance, start.tolerance);
    line.add("dt", options.dt, start.dt);
    line.add("lod", options.lod, start.lod);
    line.add("threads", options.threads, start.threads);
    return line.take();
}

} // namespace brickwall
