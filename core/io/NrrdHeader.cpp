// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/NrrdHeader.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/InputFile.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>
#include <string_view>
#include <vector>

namespace brickwall {
namespace {

constexpr std::size_t mostBytes = 1 << 20; ///< of a header

std::string keyOf(std::string_view name)
{
    std::string key;
    for (const char c : name)
        if (c != ' ')
            key += c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c;
    if (key == "centerings")
        return "centers";
    return key;
}

} // namespace

NrrdHeader::NrrdHeader(const std::string& path) : path_(path)
{
    const std::string text = fileStart(path, mostBytes);
    int number = 1;
    for (std::size_t begin = 0; begin < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        std::string_view line = std::string_view(text).substr(begin, end - begin);
        begin = end + 1;
        if (line.ends_with('\r'))
            line.remove_suffix(1);
        if (line.empty()) {
            bytes_ = begin;
            return;
        }
        const std::size_t colon = line.find(':');
        if (number == 1 || line.starts_with('#'))
            continue; // the magic, or a comment
        if (colon == std::string_view::npos)
            throw Error(fmt::format("{}:{}", path, number), "expected 'FIELD: DESCRIPTION', found no colon");
        if (line.substr(colon).starts_with(":="))
            continue; // a key and a value, for people
        fields_[keyOf(line.substr(0, colon))] = {std::string(line.substr(colon + 1)), number};
    }
    if (text.size() == mostBytes)
        throw Error(path, fmt::format("expected a header of at most {} bytes", mostBytes));
}

std::string NrrdHeader::where(const std::string& field) const
{
    return fmt::format("{}:{}", path_, fields_.at(field).number);
}

TextCursor NrrdHeader::cursor(const std::string& field) const
{
    const auto found = fields_.find(field);
    if (found == fields_.end())
        throw Error(path_, fmt::format("expected a field '{}' in the header, found none", field));
    // Line ends before it make the cursor count as the file does.
    TextCursor text(path_, std::string(static_cast<std::size_t>(found->second.number) - 1, '\n') + found->second.text);
    text.where();
    return text;
}

std::int64_t NrrdHeader::integer(const std::string& field, std::int64_t lowest, std::int64_t highest) const
{
    return has(field) ? cursor(field).integer(field, lowest, highest) : 0;
}

double NrrdHeader::perAxis(const std::string& field, int axis) const
{
    if (!has(field))
        return std::numeric_limits<double>::quiet_NaN();
    TextCursor text = cursor(field);
    double number = 0.0;
    for (int i = 0; i <= axis; ++i)
        if (const std::string word = text.word(field); !parseNumber(word, number))
            throw Error(where(field), fmt::format("expected three numbers, found '{}'", word));
    return number;
}

bool NrrdHeader::isNode(int axis) const
{
    if (!has("centers"))
        return false;
    TextCursor text = cursor("centers");
    std::string word;
    for (int i = 0; i <= axis; ++i)
        word = text.word("centers");
    return word == "node";
}

vec3d readNrrdVector(TextCursor& text)
{
    const std::string what = "a vector (X,Y,Z)";
    vec3d v{0.0};
    text.expect("(", what);
    for (int axis = 0; axis < 3; ++axis) {
        v[axis] = text.number(what);
        text.expect(axis < 2 ? "," : ")", what);
    }
    return v;
}

std::uint64_t afterLines(const std::string& path, std::uint64_t offset, std::int64_t lines)
{
    if (lines == 0)
        return offset;
    const InputFile file(path);
    std::vector<char> some(1 << 16);
    while (offset < file.size()) {
        some.resize(std::min<std::uint64_t>(some.size(), file.size() - offset));
        file.readAt(offset, std::span<char>(some), "lines to skip");
        for (const char c : some) {
            ++offset;
            if (c == '\n' && --lines == 0)
                return offset;
        }
    }
    throw Error(path, fmt::format("truncated: {} more lines to skip, but the file ends at byte {}", lines, offset));
}

} // namespace brickwall
