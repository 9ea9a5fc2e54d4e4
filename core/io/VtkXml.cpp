// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/VtkXml.h"

#include "brickwall/core/base/Error.h"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>

namespace brickwall {
namespace {

constexpr std::string_view appendedTag = "<AppendedData";

/// The value of NAME="VALUE" in a tag; empty without it.
std::string attributeIn(std::string_view tag, std::string_view name)
{
    const std::size_t at = tag.find(std::string(name) + "=");
    if (at == std::string_view::npos)
        return {};
    const std::size_t quote = at + name.size() + 1;
    const std::size_t end = quote < tag.size() ? tag.find(tag[quote], quote + 1) : std::string_view::npos;
    return end == std::string_view::npos ? std::string() : std::string(tag.substr(quote + 1, end - quote - 1));
}

} // namespace

VtkXml::VtkXml(const std::string& path, std::uint64_t limit) : file_(path), text_(head(limit))
{
    const auto result = document_.load_buffer_inplace(text_.data(), text_.size());
    if (!result)
        throw Error(fmt::format("{}: byte {}", path, result.offset),
                    fmt::format("is broken XML: {}", result.description()));
    if (!root())
        throw Error(path, "expected a VTK XML file with an element VTKFile");
}

std::string VtkXml::head(std::uint64_t limit)
{
    constexpr std::uint64_t step = 1 << 20;
    std::string text;
    while (text.size() < file_.size()) {
        const std::uint64_t begin = text.size();
        if (begin >= limit)
            throw Error(file_.path(), fmt::format("expected at most {} bytes of XML", limit));
        text.resize(std::min(begin + step, file_.size()));
        file_.readAt(begin, std::span<char>(text).subspan(begin), "its XML");
        // The tag may lie across two steps.
        const std::size_t from = begin - std::min<std::uint64_t>(begin, appendedTag.size());
        if (const std::size_t at = text.find(appendedTag, from); at != std::string::npos) {
            findAppended(at);
            text.resize(at);
            return text + "</VTKFile>";
        }
    }
    return text;
}

void VtkXml::findAppended(std::uint64_t element)
{
    std::string start(std::min<std::uint64_t>(4096, file_.size() - element), '\0');
    file_.readAt(element, std::span<char>(start), "the element AppendedData");
    const std::size_t end = start.find('>');
    const std::size_t underscore = start.find('_', std::min(end, start.size()));
    if (end == std::string::npos || underscore == std::string::npos)
        throw Error(fmt::format("{}: byte {}", file_.path(), element),
                    "expected an underscore in front of the appended data, found none");
    const std::string encoding = attributeIn(std::string_view(start).substr(0, end), "encoding");
    if (encoding != "raw" && encoding != "base64")
        throw Error(fmt::format("{}: byte {}", file_.path(), element),
                    fmt::format("expected appended data with encoding raw or base64, found '{}'", encoding));
    appendedBegin_ = element + underscore + 1;
    appendedBase64_ = encoding == "base64";
}

pugi::xml_node VtkXml::content() const
{
    const pugi::xml_node node = root().child(type().c_str());
    if (!node)
        throw Error(path(), fmt::format("expected an element {}, as the type says, found none", type()));
    return node;
}

bool VtkXml::bigEndian() const
{
    const std::string_view order = root().attribute("byte_order").as_string("LittleEndian");
    if (order != "LittleEndian" && order != "BigEndian")
        throw Error(path(), fmt::format("expected byte_order LittleEndian or BigEndian, found '{}'", order));
    return order == "BigEndian";
}

int VtkXml::headerBytes() const
{
    const std::string_view type = root().attribute("header_type").as_string("UInt32");
    if (type != "UInt32" && type != "UInt64")
        throw Error(path(), fmt::format("expected header_type UInt32 or UInt64, found '{}'", type));
    return type == "UInt64" ? 8 : 4;
}

bool VtkXml::compressed() const
{
    const std::string_view compressor = root().attribute("compressor").as_string();
    if (!compressor.empty() && compressor != "vtkZLibDataCompressor")
        throw Error(path(), fmt::format("expected no compressor or vtkZLibDataCompressor, found '{}'", compressor));
    return !compressor.empty();
}

std::string vtkXmlType(const std::string& path)
{
    const std::string start = fileStart(path, 4096);
    const std::size_t tag = start.find("<VTKFile");
    if (tag == std::string::npos || start.find('<') != std::min(tag, start.find("<?xml")))
        return {};
    return attributeIn(std::string_view(start).substr(tag, start.find('>', tag) - tag), "type");
}

} // namespace brickwall
