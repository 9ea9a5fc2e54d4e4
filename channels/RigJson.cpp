// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/RigJson.h"
#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <iterator>

namespace brickwall {
namespace {

using Json = nlohmann::ordered_json;

/// Characters of a text; the line of the last one read is where the parser is.
class CountingIterator
{
public:
    using iterator_category = std::input_iterator_tag;
    using value_type = char;
    using difference_type = std::ptrdiff_t;
    using pointer = const char*;
    using reference = const char&;

    CountingIterator(const char* place, int* lineNumber) : at(place), line(lineNumber) {}
    const char& operator*() const { return *at; }
    CountingIterator& operator++()
    {
        *line += *at == '\n';
        ++at;
        return *this;
    }
    bool operator==(const CountingIterator& other) const { return at == other.at; }
    bool operator!=(const CountingIterator& other) const { return at != other.at; }

private:
    const char* at;
    int* line;
};

/// Notes the line of each key, and of each table in a list.
class LineRecorder : public nlohmann::json_sax<Json>
{
public:
    LineRecorder(RigRecord& rigRecord, const int& lineNumber) : record(rigRecord), line(lineNumber) {}

    bool null() override { return next(); }
    bool boolean(bool) override { return next(); }
    bool number_integer(number_integer_t) override { return next(); }
    bool number_unsigned(number_unsigned_t) override { return next(); }
    bool number_float(number_float_t, const string_t&) override { return next(); }
    bool string(string_t&) override { return next(); }
    bool binary(binary_t&) override { return next(); }
    bool start_object(std::size_t) override { return open(-1); }
    bool end_object() override { return close(); }
    bool start_array(std::size_t) override { return open(0); }
    bool end_array() override { return close(); }
    bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

    bool key(string_t& name) override
    {
        stack.back().key = name;
        if (stack.size() <= deepest)
            record.lines[pointer()] = line;
        return true;
    }

private:
    struct Level
    {
        int index; ///< of the next item of a list; -1 in a table
        std::string key;
    };

    static constexpr std::size_t deepest = 6; ///< no rig is deeper; deeper nesting is refused by the reader

    RigRecord& record;
    const int& line;
    std::vector<Level> stack;

    std::string pointer() const
    {
        std::string path;
        for (const Level& level : stack)
            path += "/" + (level.index < 0 ? level.key : std::to_string(level.index));
        return path;
    }

    bool open(int index)
    {
        if (stack.size() <= deepest)
            record.lines.try_emplace(pointer(), line);
        stack.push_back({index, ""});
        return true;
    }

    bool close()
    {
        stack.pop_back();
        return next();
    }

    bool next()
    {
        if (!stack.empty() && stack.back().index >= 0)
            ++stack.back().index;
        return true;
    }
};

} // namespace

RigRecord recordOfJson(const RigText& source)
{
    RigRecord record;
    record.file = source.file;
    try {
        record.root = Json::parse(source.text);
    } catch (const Json::parse_error& error) {
        throw Error(placeOfLine(source, lineOfOffset(source.text, error.byte > 0 ? error.byte - 1 : 0)),
                    fmt::format("expected well-formed JSON, found: {}", error.what()));
    } catch (const Json::out_of_range& error) { // a number that no double holds
        throw Error(source.file, fmt::format("expected numbers that can be held, found: {}", error.what()));
    }
    int line = 1;
    const char* begin = source.text.data();
    LineRecorder recorder(record, line);
    Json::sax_parse(CountingIterator(begin, &line), CountingIterator(begin + source.text.size(), &line), &recorder);
    return record;
}

} // namespace brickwall
