// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/ExaDataSet.h"
#include "brickwall/core/io/Formats.h"
#include "brickwall/core/io/TextCursor.h"

#include <glm/gtc/matrix_transform.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <unordered_map>
#include <utility>

namespace brickwall {
namespace {

constexpr std::array<std::string_view, 7> keywords{"bricks",    "scalar",     "vector",  "value_range",
                                                   "triangles", "remap_from", "remap_to"};

struct Token
{
    std::string text;
    std::string place; ///< "FILE:LINE"
};

/// Blank-separated words; one that starts with # ends its line.
std::vector<Token> tokenize(const std::string& path, std::string_view text)
{
    constexpr std::string_view blanks = " \t\r\n\v\f";
    std::vector<Token> tokens;
    int line = 1;
    for (std::size_t i = 0; i < text.size();) {
        if (blanks.find(text[i]) != std::string_view::npos) {
            line += text[i++] == '\n';
            continue;
        }
        if (text[i] == '#') {
            i = std::min(text.find('\n', i), text.size());
            continue;
        }
        const std::size_t end = std::min(text.find_first_of(blanks, i), text.size());
        tokens.push_back({std::string(text.substr(i, end - i)), fmt::format("{}:{}", path, line)});
        i = end;
    }
    return tokens;
}

bool isKeyword(std::string_view word)
{
    return std::find(keywords.begin(), keywords.end(), word) != keywords.end();
}

class ExaParser
{
public:
    ExaParser(const std::string& path, std::vector<Token> tokens) : path_(path), tokens_(std::move(tokens))
    {
        parts_.data = path;
    }

    ExaParts parse()
    {
        while (at_ < tokens_.size())
            statement(next("a keyword"));
        if (parts_.geometry.empty())
            throw Error(path_, "expected a line 'bricks FILE', found none");
        parts_.worldFromVoxel = cornersToBox(to_) * glm::inverse(cornersToBox(from_));
        return std::move(parts_);
    }

private:
    using Corners = std::array<double, 6>;

    const Token& next(const std::string& what)
    {
        if (at_ == tokens_.size())
            throw Error(tokens_.empty() ? path_ : tokens_.back().place,
                        fmt::format("expected {}, found the end of the file", what));
        return tokens_[at_++];
    }

    double number(const std::string& what)
    {
        const Token& token = next(what);
        double value = 0;
        if (!parseNumber(token.text, value) || !std::isfinite(static_cast<float>(value)))
            throw Error(token.place, fmt::format("expected {}, a finite number, found '{}'", what, token.text));
        return value;
    }

    /// File names are relative to the folder of the .exa file; absolute ones stay as they are.
    std::string file(const std::string& what)
    {
        const Token token = next(what);
        const std::string path = (std::filesystem::path(path_).parent_path() / token.text).string();
        if (!isRegularFile(path))
            throw Error(token.place, fmt::format("expected {}, found no file {}", what, path));
        return path;
    }

    void statement(const Token& keyword)
    {
        const std::string place = keyword.place;
        if (keyword.text == "bricks")
            bricks(place);
        else if (keyword.text == "scalar")
            scalar(place);
        else if (keyword.text == "vector")
            vector(place);
        else if (keyword.text == "value_range")
            valueRange(place);
        else if (keyword.text == "triangles")
            parts_.triangles = file("a .tris file after 'triangles'");
        else if (keyword.text == "remap_from")
            from_ = corners(place, keyword.text);
        else if (keyword.text == "remap_to")
            to_ = corners(place, keyword.text);
        else
            throw Error(place, fmt::format("unknown keyword '{}'; expected one of {}", keyword.text,
                                           fmt::join(keywords, ", ")));
    }

    void bricks(const std::string& place)
    {
        parts_.geometry = file("a .bricks file after 'bricks'");
        if (extensionOf(parts_.geometry) == ".cells")
            throw Error(
                place,
                fmt::format("expected a .bricks file, found {}; loose cells are read by opening that file itself",
                            parts_.geometry));
    }

    ExaField& declare(const std::string& place, const std::string& keyword)
    {
        const Token& name = next(fmt::format("a field's name after '{}'", keyword));
        if (const auto [known, isNew] = declared_.emplace(name.text, place); !isNew)
            throw Error(place, fmt::format("field '{}' is declared twice, first at {}; give one of them another name",
                                           name.text, known->second));
        parts_.fields.push_back({name.text, place, {}, {}, {}});
        return parts_.fields.back();
    }

    void scalar(const std::string& place)
    {
        ExaField& field = declare(place, "scalar");
        if (at_ < tokens_.size() && tokens_[at_].text == "expr") {
            ++at_;
            field.expression.emplace(expression(place), parts_.fields.size() - 1, place);
        } else {
            field.files = {file(fmt::format("the .scalars file of '{}'", field.name))};
        }
    }

    /// The words between two double quotes, which may stand alone or touch the words.
    std::vector<std::string> expression(const std::string& place)
    {
        std::string word = next("an expression in double quotes after 'expr'").text;
        if (word[0] != '"')
            throw Error(place, fmt::format("expected an expression in double quotes after 'expr', found '{}'", word));
        word.erase(0, 1);
        std::vector<std::string> words;
        while (!word.ends_with('"')) {
            if (!word.empty())
                words.push_back(word);
            word = next(fmt::format("the closing quote of the expression at {}", place)).text;
        }
        word.pop_back();
        if (!word.empty())
            words.push_back(word);
        return words;
    }

    void vector(const std::string& place)
    {
        ExaField& field = declare(place, "vector");
        for (const char axis : {'x', 'y', 'z'})
            field.files.push_back(file(fmt::format("the .scalars file of '{}', component {}", field.name, axis)));
    }

    void valueRange(const std::string& place)
    {
        if (parts_.fields.empty())
            throw Error(place, "expected 'value_range' after the field that it belongs to, found no field before it");
        const double lo = number("the lower end of value_range"), hi = number("the upper end of value_range");
        if (!(lo < hi))
            throw Error(place, fmt::format("expected a range from a lower to a higher value, found {} to {}", lo, hi));
        parts_.fields.back().preferredRange = {static_cast<float>(lo), static_cast<float>(hi)};
    }

    Corners corners(const std::string& place, const std::string& keyword)
    {
        Corners c{};
        for (double& v : c)
            v = number(fmt::format("a coordinate of {}", keyword));
        for (int axis = 0; axis < 3; ++axis)
            if (c[axis] == c[axis + 3])
                throw Error(place, fmt::format("expected a box of {} that has a volume, found {} to {} along {}",
                                               keyword, c[axis], c[axis + 3], "xyz"[axis]));
        return c;
    }

    /// Takes the unit cube to the box with these corners.
    static mat4d cornersToBox(const Corners& c)
    {
        const vec3d lower(c[0], c[1], c[2]), upper(c[3], c[4], c[5]);
        return glm::scale(glm::translate(mat4d(1.0), lower), upper - lower);
    }

    std::string path_;
    std::vector<Token> tokens_;
    std::size_t at_ = 0;
    ExaParts parts_;
    std::unordered_map<std::string, std::string> declared_; ///< the places of the fields' declarations
    Corners from_{0, 0, 0, 1, 1, 1};
    Corners to_{0, 0, 0, 1, 1, 1};
};

/// Text whose first word, comments apart, is a keyword; a file called .exa has to be one.
bool looksLikeExa(const std::string& data)
{
    if (extensionOf(data) == ".exa")
        return true;
    const std::string start = fileStart(data, 4096);
    if (start.find('\0') != std::string::npos)
        return false;
    const std::vector<Token> tokens = tokenize(data, start);
    return !tokens.empty() && isKeyword(tokens[0].text);
}

} // namespace

std::unique_ptr<DataSet> openExa(const std::string& data)
{
    if (!isRegularFile(data) || !looksLikeExa(data))
        return nullptr;
    return makeExaDataSet(ExaParser(data, tokenize(data, readText(data))).parse());
}

} // namespace brickwall
