// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/InputFile.h"
#include "brickwall/core/io/MeshFormats.h"
#include "brickwall/core/io/NumberType.h"
#include "brickwall/core/io/TextCursor.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <utility>

namespace brickwall {
namespace {

struct Property
{
    std::string name;
    NumberType type = NumberType::float32;
    std::optional<NumberType> countType; ///< of a list
};

struct Element
{
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};

struct Head
{
    bool text = false;
    bool bigEndian = false;
    std::vector<Element> elements;
};

NumberType typeOf(TextCursor& head)
{
    const std::string name = head.word("a type");
    const auto type = numberTypeNamed(name);
    if (!type)
        head.fail(fmt::format("a type of numbers, found {}", name));
    return *type;
}

Property propertyOf(TextCursor& head)
{
    Property property;
    if (head.nextIs("list")) {
        head.expect("list", "a list");
        property.countType = typeOf(head);
    }
    property.type = typeOf(head);
    property.name = head.word("a name");
    return property;
}

Head headOf(TextCursor& text)
{
    Head head;
    text.expect("ply", "a PLY file");
    for (;;) {
        const std::string word = text.word("a line of the head");
        if (word == "end_header")
            return head;
        if (word == "format") {
            const std::string format = text.word("ascii or binary");
            if (format != "ascii" && format != "binary_little_endian" && format != "binary_big_endian")
                text.fail("ascii, binary_little_endian or binary_big_endian, found " + format);
            head.text = format == "ascii";
            head.bigEndian = format == "binary_big_endian";
            text.line("the version");
        } else if (word == "element") {
            Element& element = head.elements.emplace_back();
            element.name = text.word("an element's name");
            element.count = std::uint64_t(text.integer("how many there are", 0, INT32_MAX));
        } else if (word == "property" && !head.elements.empty()) {
            head.elements.back().properties.push_back(propertyOf(text));
        } else if (word == "comment" || word == "obj_info") {
            text.line("a comment");
        } else {
            text.fail("format, element, property, comment or end_header, found " + word);
        }
    }
}

/// The numbers behind the head, one after the other.
class Numbers
{
public:
    virtual ~Numbers() = default;
    virtual double next(NumberType type) = 0;
};

class TextNumbers : public Numbers
{
public:
    explicit TextNumbers(TextCursor& text) : text_(text) {}
    double next(NumberType) override { return text_.number("a number"); }

private:
    TextCursor& text_;
};

class BinaryNumbers : public Numbers
{
public:
    BinaryNumbers(const InputFile& file, std::uint64_t offset, bool bigEndian)
        : file_(file), offset_(offset), bigEndian_(bigEndian)
    {
    }

    double next(NumberType type) override
    {
        const std::size_t size = std::size_t(bytesOf(type));
        if (at_ + size > piece_.size()) {
            offset_ += at_;
            piece_.resize(std::min<std::uint64_t>(1 << 16, file_.size() - std::min(offset_, file_.size())));
            file_.readAt(offset_, std::span(piece_), "vertices and faces");
            at_ = 0;
            if (piece_.size() < size)
                throw Error(file_.path(),
                            fmt::format("truncated: it ends at byte {}, within the vertices and faces", file_.size()));
        }
        double value = 0.0;
        decodeNumbers(type, bigEndian_, std::span(piece_).subspan(at_, size), 1, std::span(&value, 1));
        at_ += size;
        return value;
    }

private:
    const InputFile& file_;
    std::uint64_t offset_; ///< of the piece
    bool bigEndian_;
    std::vector<std::byte> piece_;
    std::size_t at_ = 0;
};

class PlyReader
{
public:
    PlyReader(Numbers& numbers, std::string path, std::uint64_t fileBytes, Progress& progress)
        : numbers_(numbers), path_(std::move(path)), fileBytes_(fileBytes), progress_(progress)
    {
    }

    void read(const Element& element)
    {
        if (element.properties.empty())
            return;
        for (std::uint64_t i = 0; i < element.count; ++i) {
            if (i % 1024 == 0)
                progress_.check();
            vec3f vertex(0.0f);
            for (const Property& property : element.properties)
                readProperty(element, property, vertex);
            if (element.name == "vertex")
                mesh.vertices.push_back(vertex);
        }
    }

    TriangleMesh mesh;

private:
    void readProperty(const Element& element, const Property& property, vec3f& vertex)
    {
        if (!property.countType) {
            const double value = numbers_.next(property.type);
            for (int axis = 0; axis < 3; ++axis)
                if (property.name.size() == 1 && property.name[0] == 'x' + axis)
                    vertex[axis] = float(value);
            return;
        }
        const double count = numbers_.next(*property.countType);
        if (!(count >= 0.0 && count <= double(fileBytes_)))
            throw Error(path_, fmt::format("a list of {} has {} items, in a file of {} bytes", element.name, count,
                                           fileBytes_));
        list_.clear();
        for (double i = 0.0; i < count; ++i)
            list_.push_back(numbers_.next(property.type));
        if (element.name == "face" && (property.name == "vertex_indices" || property.name == "vertex_index"))
            addPolygon(mesh, list_, path_);
    }

    Numbers& numbers_;
    std::string path_;
    std::uint64_t fileBytes_;
    Progress& progress_;
    std::vector<double> list_;
};

/// Behind the line "end_header", which ends within the first megabyte.
std::uint64_t endOfHead(const std::string& path)
{
    const std::string start = fileStart(path, 1 << 20);
    const std::size_t end = start.find("\nend_header");
    const std::size_t line = end == start.npos ? start.npos : start.find('\n', end + 1);
    if (line == start.npos)
        throw Error(path, "expected a PLY file, whose head ends with end_header");
    return line + 1;
}

} // namespace

TriangleMesh readPly(const std::string& path, Progress& progress)
{
    const std::uint64_t body = endOfHead(path);
    const InputFile file(path);
    TextCursor text(path);
    const Head head = headOf(text);
    std::unique_ptr<Numbers> numbers;
    if (head.text)
        numbers = std::make_unique<TextNumbers>(text);
    else
        numbers = std::make_unique<BinaryNumbers>(file, body, head.bigEndian);
    PlyReader reader(*numbers, path, file.size(), progress);
    for (const Element& element : head.elements)
        reader.read(element);
    return std::move(reader.mesh);
}

} // namespace brickwall
