// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/RigToml.h"
#include "brickwall/core/base/Error.h"

#include <fmt/format.h>
#include <toml++/toml.h>

namespace brickwall {
namespace {

using Json = nlohmann::ordered_json;

/// Copies a node and what is under it, with the lines.
Json jsonOf(const toml::node& node, const std::string& pointer, RigRecord& record)
{
    record.lines[pointer] = int(node.source().begin.line);
    Json value;
    if (const toml::table* table = node.as_table()) {
        value = Json::object();
        for (const auto& [key, child] : *table) {
            const std::string name(key.str());
            value[name] = jsonOf(child, pointer + "/" + name, record);
            record.lines[pointer + "/" + name] = int(key.source().begin.line);
        }
    } else if (const toml::array* array = node.as_array()) {
        value = Json::array();
        for (std::size_t i = 0; i < array->size(); ++i)
            value.push_back(jsonOf((*array)[i], fmt::format("{}/{}", pointer, i), record));
    } else if (const auto* text = node.as_string()) {
        value = text->get();
    } else if (const auto* integer = node.as_integer()) {
        value = integer->get();
    } else if (const auto* number = node.as_floating_point()) {
        value = number->get();
    } else if (const auto* flag = node.as_boolean()) {
        value = flag->get();
    } else {
        throw Error(fmt::format("{}:{}", record.file, record.lines[pointer]),
                    "dates and times have no meaning in a rig");
    }
    return value;
}

std::string tomlOf(const Json& value)
{
    if (!value.is_array()) {
        // JSON's texts, numbers and flags are TOML's, but for one control character that JSON allows.
        std::string text = value.dump(-1, ' ', false, Json::error_handler_t::replace);
        for (std::size_t i = text.find('\x7f'); i != text.npos; i = text.find('\x7f', i))
            text.replace(i, 1, "\\u007f");
        return text;
    }
    std::string list;
    for (const Json& item : value)
        list += (list.empty() ? "" : ", ") + tomlOf(item);
    return "[" + list + "]";
}

void writeTable(std::string& text, const std::string& head, const Json& table)
{
    text += text.empty() ? "" : "\n";
    text += head + "\n";
    for (const auto& [key, value] : table.items())
        text += fmt::format("{} = {}\n", key, tomlOf(value));
}

} // namespace

RigRecord recordOfToml(const RigText& source)
{
    RigRecord record;
    record.file = source.file;
    try {
        const toml::table table = toml::parse(source.text, source.file);
        record.root = jsonOf(table, "", record);
    } catch (const toml::parse_error& error) {
        throw Error(placeOfLine(source, int(error.source().begin.line)),
                    fmt::format("expected well-formed TOML, found: {}", error.description()));
    }
    return record;
}

std::string tomlOfRecord(const Json& root)
{
    std::string text;
    for (const auto& [key, value] : root.items()) {
        if (value.is_object())
            writeTable(text, "[" + key + "]", value);
        else
            for (const Json& table : value)
                writeTable(text, "[[" + key + "]]", table);
    }
    return text;
}

} // namespace brickwall
