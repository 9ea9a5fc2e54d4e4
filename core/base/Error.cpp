// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>

namespace brickwall {
namespace {

/// A name read from a hostile file may contain line ends; the message still has to be one line.
std::string oneLine(std::string_view place, std::string_view message)
{
    std::string line = place.empty() ? std::string(message) : std::string(place) + ": " + std::string(message);
    std::replace_if(
        line.begin(), line.end(), [](unsigned char c) { return c < 0x20 || c == 0x7f; }, ' ');
    return line;
}

/// How many characters of UTF-8 begin in these bytes: a caret counts what is seen.
std::size_t characterCount(std::string_view bytes)
{
    return static_cast<std::size_t>(
        std::count_if(bytes.begin(), bytes.end(), [](char c) { return (static_cast<unsigned char>(c) >> 6) != 2; }));
}

} // namespace

Error::Error(std::string_view place, std::string_view message) : std::runtime_error(oneLine(place, message)) {}

TextError::TextError(std::string_view place, std::string_view message, std::string_view text, std::size_t at)
    : Error(place, fmt::format("{}, at character {} of \"{}\"", message, characterCount(text.substr(0, at)) + 1, text)),
      excerpt_(oneLine("", text) + "\n" + std::string(characterCount(text.substr(0, at)), ' ') + "^")
{
}

} // namespace brickwall
