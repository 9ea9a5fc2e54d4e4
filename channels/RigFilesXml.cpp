// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/channels/RigFilesXml.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

namespace brickwall {
namespace {

/// The offset of an attribute's name within its element's start tag; pugixml keeps offsets of elements only.
std::size_t offsetOfAttribute(std::string_view text, std::size_t element, std::string_view attribute)
{
    char quote = 0;
    for (std::size_t i = element; i < text.size(); ++i) {
        const char c = text[i];
        if (quote) {
            quote = c == quote ? 0 : quote;
        } else if (c == '"' || c == '\'') {
            quote = c;
        } else if (c == '>') {
            break;
        } else if (std::isspace((unsigned char)c) && text.substr(i + 1, attribute.size()) == attribute) {
            const std::size_t after = text.find_first_not_of(" \t\r\n", i + 1 + attribute.size());
            if (after != text.npos && text[after] == '=')
                return i + 1;
        }
    }
    return element;
}

} // namespace

RigXml::RigXml(RigText text) : source(std::move(text))
{
    lineBegins.push_back(0);
    for (std::size_t i = 0; i < source.text.size(); ++i)
        if (source.text[i] == '\n')
            lineBegins.push_back(i + 1);
    // Bytes as they are, whatever encoding the file declares: a conversion would shift the offsets.
    const pugi::xml_parse_result result =
        document.load_buffer(source.text.data(), source.text.size(), pugi::parse_default, pugi::encoding_utf8);
    if (!result)
        throw Error(placeOfLine(source, lineAt(std::size_t(std::max<std::ptrdiff_t>(result.offset, 0)))),
                    fmt::format("expected well-formed XML, found: {}", result.description()));
}

std::string RigXml::placeOf(const pugi::xml_node& element) const
{
    return placeOfLine(source, lineAt(std::size_t(std::max<std::ptrdiff_t>(element.offset_debug(), 0))));
}

std::string RigXml::placeOf(const pugi::xml_node& element, std::string_view attribute) const
{
    const std::size_t offset = std::size_t(std::max<std::ptrdiff_t>(element.offset_debug(), 0));
    return placeOfLine(source, lineAt(offsetOfAttribute(source.text, offset, attribute)));
}

int RigXml::lineAt(std::size_t offset) const
{
    return int(std::upper_bound(lineBegins.begin(), lineBegins.end(), offset) - lineBegins.begin());
}

} // namespace brickwall
