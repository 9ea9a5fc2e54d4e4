// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/VtkPiece.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/NumberType.h"
#include "brickwall/core/io/TextCursor.h"
#include "brickwall/core/io/VtkBytes.h"

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <string_view>
#include <utility>

namespace brickwall {
namespace {

/// Text is not counted in lines, as the attribute's place is unknown to pugixml.
TextCursor attributeText(const VtkXml& xml, const pugi::xml_node& node, const char* attribute)
{
    const pugi::xml_attribute found = node.attribute(attribute);
    const std::string place = fmt::format("{}: {} of {}", xml.path(), attribute, node.name());
    if (!found)
        throw Error(place, "is missing");
    return TextCursor(place, found.as_string());
}

/// Numbers as text, as doubles.
std::vector<std::byte> parseAscii(std::string_view text, std::uint64_t count, const std::string& place)
{
    if (count > text.size())
        throw Error(place, fmt::format("truncated: expected {} numbers, found {} characters", count, text.size()));
    std::vector<std::byte> bytes(count * sizeof(double));
    constexpr std::string_view blanks = " \t\r\n";
    for (std::uint64_t i = 0; i < count; ++i) {
        text.remove_prefix(std::min(text.find_first_not_of(blanks), text.size()));
        const std::string_view word = text.substr(0, text.find_first_of(blanks));
        double number = 0.0;
        if (word.empty())
            throw Error(place, fmt::format("truncated: expected {} numbers, found {}", count, i));
        if (!parseNumber(word, number))
            throw Error(place, fmt::format("expected number {}, found '{}'", i, word.substr(0, 40)));
        std::memcpy(bytes.data() + i * sizeof(double), &number, sizeof(double));
        text.remove_prefix(word.size());
    }
    return bytes;
}

/// An array as the file has it.
struct StoredArray
{
    std::vector<std::byte> bytes;
    NumberType type = NumberType::float64;
    bool bigEndian = false;
};

StoredArray readArray(const VtkXml& xml, const pugi::xml_node& node, std::uint64_t numbers, const std::string& place)
{
    StoredArray array;
    const auto type = numberTypeNamed(node.attribute("type").as_string());
    if (!type)
        throw Error(place, fmt::format("expected numbers, found type '{}'", node.attribute("type").as_string()));
    array.type = *type;
    array.bigEndian = xml.bigEndian();
    const std::uint64_t bytes = numbers * std::uint64_t(bytesOf(array.type));
    const VtkEncoding encoding{xml.headerBytes(), array.bigEndian, xml.compressed()};
    const std::string_view format = node.attribute("format").as_string("ascii");
    if (format == "ascii") {
        array.bytes = parseAscii(node.text().get(), numbers, place);
        array.type = NumberType::float64;
        array.bigEndian = std::endian::native == std::endian::big;
    } else if (format == "binary") {
        array.bytes = unpackVtk(*base64Bytes(node.text().get(), place), encoding, bytes, place);
    } else if (format == "appended") {
        if (!xml.hasAppended())
            throw Error(place, "expected an element AppendedData, found none");
        const auto offset = static_cast<std::uint64_t>(
            attributeText(xml, node, "offset").integer("an offset", 0, std::int64_t(1) << 62));
        const std::uint64_t at = xml.appendedBegin() + offset;
        const auto in = xml.appendedBase64() ? base64Bytes(xml.file(), at, place) : rawBytes(xml.file(), at, place);
        array.bytes = unpackVtk(*in, encoding, bytes, place);
    } else {
        throw Error(place, fmt::format("expected format ascii, binary or appended, found '{}'", format));
    }
    return array;
}

class PieceReader : public BoxReader
{
public:
    PieceReader(const std::string& path, const Box3i& box, ArrayField field)
        : place_(fmt::format("{}: '{}'", path, field.array)), box_(box), field_(std::move(field))
    {
        const VtkPiece piece(path);
        const vec3i size = piece.size(), expected = box.extent();
        if (size != expected)
            throw Error(path, fmt::format("expected {} x {} x {} cells, as its amr_box says, found {} x {} x {}",
                                          expected.x, expected.y, expected.z, size.x, size.y, size.z));
        const pugi::xml_node node = piece.array(field_.array);
        if (const int found = node.attribute("NumberOfComponents").as_int(1); found != field_.components)
            throw Error(place_, fmt::format("expected {} components, as in the first piece, found {}",
                                            field_.components, found));
        stored_ = readArray(piece.xml(), node, static_cast<std::uint64_t>(volume(box)) * field_.components, place_);
    }

    std::string place() const override { return place_; }
    Box3i box() const override { return box_; }

    void read(int zBegin, int zEnd, std::vector<double>& values) override
    {
        const std::size_t plane = std::size_t(box_.extent().x) * box_.extent().y;
        const std::size_t first = plane * std::size_t(zBegin - box_.lower.z);
        values.resize(plane * std::size_t(zEnd - zBegin));
        if (field_.component != ArrayField::magnitude)
            return decode(first, field_.component, values);
        std::vector<double> component(values.size());
        std::fill(values.begin(), values.end(), 0.0);
        for (int c = 0; c < field_.components; ++c) {
            decode(first, c, component);
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] += component[i] * component[i];
        }
        for (double& v : values)
            v = std::sqrt(v);
    }

private:
    void decode(std::size_t firstCell, int component, std::span<double> values) const
    {
        const std::size_t stride = static_cast<std::size_t>(field_.components);
        const std::size_t number = firstCell * stride + static_cast<std::size_t>(component);
        decodeNumbers(stored_.type, stored_.bigEndian,
                      std::span(stored_.bytes).subspan(number * static_cast<std::size_t>(bytesOf(stored_.type))),
                      stride, values);
    }

    std::string place_;
    Box3i box_;
    ArrayField field_;
    StoredArray stored_;
};

} // namespace

VtkPiece::VtkPiece(const std::string& path) : xml_(path)
{
    if (xml_.type() != "ImageData")
        throw Error(path, fmt::format("expected a piece of type ImageData, found '{}'", xml_.type()));
    const pugi::xml_node image = xml_.content();
    const pugi::xml_node piece = image.child("Piece");
    if (!piece || piece.next_sibling("Piece"))
        throw Error(path, fmt::format("expected one element Piece, found {}", piece ? "several" : "none"));
    const Box3i points = vtkExtent(xml_, piece, "Extent");
    size_ = points.extent();
    spacing_ = vtkVector(xml_, image, "Spacing");
    lower_ = vtkVector(xml_, image, "Origin") + vec3d(points.lower) * spacing_;
    cellData_ = piece.child("CellData");
    if (const char* direction = image.attribute("Direction").as_string(nullptr);
        direction && std::string_view(direction) != "1 0 0 0 1 0 0 0 1")
        throw Error(path, fmt::format("expected image data along the axes, found Direction '{}'", direction));
}

std::vector<ArrayField> VtkPiece::fields() const
{
    std::vector<ArrayField> fields;
    for (const pugi::xml_node& node : cellData_.children("DataArray")) {
        const std::string name = node.attribute("Name").as_string();
        const int components = node.attribute("NumberOfComponents").as_int(1);
        if (components < 1 || components > 1024)
            throw Error(fmt::format("{}: '{}'", xml_.path(), name),
                        fmt::format("expected 1 to 1024 components, found {}", components));
        if (name != "vtkGhostType" && name != "vtkGhostLevels")
            appendArrayFields(name, components, fields);
    }
    return fields;
}

pugi::xml_node VtkPiece::array(const std::string& name) const
{
    std::vector<std::string> names;
    for (const pugi::xml_node& node : cellData_.children("DataArray")) {
        names.push_back(node.attribute("Name").as_string());
        if (names.back() == name)
            return node;
    }
    throw Error(xml_.path(), fmt::format("expected an array '{}' of cell data, found {}", name,
                                         names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
}

std::unique_ptr<BoxReader> openVtkPiece(const std::string& path, const Box3i& box, const ArrayField& field)
{
    return std::make_unique<PieceReader>(path, box, field);
}

vec3d vtkVector(const VtkXml& xml, const pugi::xml_node& node, const char* attribute)
{
    TextCursor text = attributeText(xml, node, attribute);
    vec3d v{0.0};
    for (int axis = 0; axis < 3; ++axis)
        v[axis] = text.number("three numbers");
    return v;
}

Box3i vtkExtent(const VtkXml& xml, const pugi::xml_node& node, const char* attribute)
{
    TextCursor text = attributeText(xml, node, attribute);
    constexpr std::int64_t most = std::int64_t(1) << 29; // extents stay ints
    Box3i box;
    for (int axis = 0; axis < 3; ++axis) {
        box.lower[axis] = static_cast<int>(text.integer("six indices", -most, most));
        box.upper[axis] = static_cast<int>(text.integer("six indices", -most, most));
    }
    return box;
}

} // namespace brickwall
