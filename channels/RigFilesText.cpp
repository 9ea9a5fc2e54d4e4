// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/RigFilesText.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

namespace brickwall {
namespace {

struct ModeWord
{
    std::string_view covise;
    StereoMode mode;
};

/// The first word of a mode is the one that is written.
constexpr std::array<ModeWord, 18> modeWords{{
    {"NONE", StereoMode::mono},
    {"MONO", StereoMode::mono},
    {"MIDDLE", StereoMode::mono},
    {"LEFT", StereoMode::left},
    {"LEFT_EYE", StereoMode::left},
    {"RIGHT", StereoMode::right},
    {"RIGHT_EYE", StereoMode::right},
    {"HORIZONTAL_SPLIT", StereoMode::horizontalSplit},
    {"VERTICAL_SPLIT", StereoMode::verticalSplit},
    {"ANAGLYPHIC", StereoMode::anaglyphic},
    {"ANAGLYPH", StereoMode::anaglyphic},
    {"QUAD_BUFFER", StereoMode::quadBuffer},
    {"QUAD_BUFFERED", StereoMode::quadBuffer},
    {"HORIZONTAL_INTERLACE", StereoMode::horizontalInterlace},
    {"VERTICAL_INTERLACE", StereoMode::verticalInterlace},
    {"STIPPLE", StereoMode::verticalInterlace},
    {"CHECKERBOARD", StereoMode::checkerboard},
    {"", StereoMode::mono},
}};

std::string lettersOf(std::string_view word)
{
    std::string letters = lowerCase(word);
    std::erase_if(letters, [](char c) { return c == '_' || c == '-' || c == ' '; });
    return letters;
}

template <typename Number>
std::optional<Number> parseAll(std::string_view word)
{
    if (word.size() > 1 && word[0] == '+' && word[1] != '-')
        word.remove_prefix(1);
    Number value{};
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (error != std::errc() || end != word.data() + word.size())
        return std::nullopt;
    return value;
}

} // namespace

std::string placeOfLine(const RigText& source, int line)
{
    return fmt::format("{}:{}", source.file, line);
}

int lineOfOffset(std::string_view text, std::size_t offset)
{
    const std::string_view before = text.substr(0, std::min(offset, text.size()));
    return 1 + int(std::count(before.begin(), before.end(), '\n'));
}

std::optional<double> parseNumber(std::string_view word)
{
    const std::optional<double> value = parseAll<double>(word);
    return value && std::isfinite(*value) ? value : std::nullopt;
}

std::optional<int> parseInteger(std::string_view word)
{
    return parseAll<int>(word);
}

std::vector<std::string> splitWords(std::string_view text, std::string_view separators)
{
    std::vector<std::string> words;
    for (std::size_t begin = text.find_first_not_of(separators); begin != text.npos;) {
        const std::size_t end = std::min(text.find_first_of(separators, begin), text.size());
        words.emplace_back(text.substr(begin, end - begin));
        begin = text.find_first_not_of(separators, end);
    }
    return words;
}

std::string lowerCase(std::string_view text)
{
    std::string lower(text);
    std::transform(lower.begin(), lower.end(), lower.begin(), [](unsigned char c) { return char(std::tolower(c)); });
    return lower;
}

std::optional<StereoMode> stereoModeOf(std::string_view word)
{
    const std::string letters = lettersOf(word);
    for (const ModeWord& known : modeWords)
        if (letters == lettersOf(known.covise))
            return known.mode;
    return std::nullopt;
}

std::string coviseWordOf(StereoMode mode)
{
    const auto known =
        std::find_if(modeWords.begin(), modeWords.end(), [&](const ModeWord& w) { return w.mode == mode; });
    return std::string(known->covise);
}

std::string enumerate(const std::vector<std::string>& words)
{
    std::string text;
    for (std::size_t i = 0; i < words.size(); ++i)
        text += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
    return text;
}

std::string uniqueName(const std::string& name, const std::vector<std::string>& taken)
{
    std::string unique = name;
    for (int number = 2; std::find(taken.begin(), taken.end(), unique) != taken.end(); ++number)
        unique = fmt::format("{}-{}", name, number);
    return unique;
}

} // namespace brickwall
