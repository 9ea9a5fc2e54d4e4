// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/DataName.h"
#include "brickwall/core/io/Formats.h"
#include "brickwall/core/io/InputFile.h"
#include "brickwall/core/io/TextCursor.h"
#include "brickwall/core/io/VolumeFile.h"

#include <glm/gtc/matrix_transform.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace brickwall {
namespace {

/// Three positive numbers between x: "256x256x128", "1x1x2.5".
std::optional<vec3d> parseTriple(std::string_view text)
{
    vec3d triple{0.0};
    for (int axis = 0; axis < 3; ++axis) {
        const std::size_t end = axis < 2 ? text.find('x') : text.size();
        if (end == std::string_view::npos || !parseNumber(text.substr(0, end), triple[axis]) || !(triple[axis] > 0.0))
            return std::nullopt;
        text.remove_prefix(axis < 2 ? end + 1 : end);
    }
    return triple;
}

std::optional<vec3i> parseSize(std::string_view text)
{
    const auto triple = parseTriple(text);
    if (text.find_first_not_of("0123456789x") != std::string_view::npos || !triple)
        return std::nullopt;
    // What no int can hold is refused for its size, as everything above coordinateLimit is.
    return vec3i(glm::min(*triple, vec3d(coordinateLimit + 1)));
}

/// What NAME_WxHxD_TYPE or the options say.
struct RawShape
{
    std::string name;
    std::optional<vec3i> size;
    std::optional<NumberType> type;
    bool bigEndian = false;
    vec3d spacing{1.0};
};

RawShape shapeInName(const std::string& stem)
{
    RawShape shape;
    shape.name = stem;
    for (std::size_t at = stem.find('_'); at != std::string::npos; at = stem.find('_', at + 1)) {
        const std::size_t end = std::min(stem.find('_', at + 1), stem.size());
        const auto size = parseSize(std::string_view(stem).substr(at + 1, end - at - 1));
        if (!size)
            continue;
        shape.name = stem.substr(0, at);
        shape.size = size;
        if (end < stem.size())
            shape.type = numberTypeNamed(std::string_view(stem).substr(end + 1));
    }
    return shape;
}

void readOption(const std::string& option, const std::string& place, RawShape& shape)
{
    const auto size = parseSize(option);
    const auto type = numberTypeNamed(option);
    if (size) {
        shape.size = size;
    } else if (type) {
        shape.type = type;
    } else if (option == "big" || option == "little") {
        shape.bigEndian = option == "big";
    } else if (option.starts_with("spacing=")) {
        const auto spacing = parseTriple(std::string_view(option).substr(8));
        if (!spacing)
            throw Error(place, fmt::format("expected spacing=AxBxC with three positive numbers, found '{}'", option));
        shape.spacing = *spacing;
    } else if (!option.starts_with("threshold=")) {
        throw Error(place,
                    fmt::format("expected WxHxD, a type (int8, uint8, int16, uint16, int32, uint32, int64, uint64, "
                                "float32, float64), big, little, spacing=AxBxC or threshold=T, found '{}'",
                                option));
    }
}

} // namespace

// A raw volume is nothing but numbers: the extension or a size in the options says what the file claims to be, and the
// length of the file has to be that of so many numbers.
std::unique_ptr<DataSet> openRaw(const std::string& data)
{
    const DataName name = splitDataName(data);
    RawShape shape = shapeInName(stemOf(name.file));
    const bool sized = std::any_of(name.options.begin(), name.options.end(),
                                   [](const std::string& option) { return parseSize(option).has_value(); });
    if (!isRegularFile(name.file) || (extensionOf(name.file) != ".raw" && !sized))
        return nullptr;
    for (const std::string& option : name.options)
        readOption(option, data, shape);
    if (!shape.size || !shape.type)
        throw Error(data, fmt::format("expected its {}: name it NAME_WxHxD_TYPE.raw, or append them, as in "
                                      "{}:256x256x128:uint8",
                                      shape.size ? "type" : "size and type", name.file));
    VolumeFile volume;
    volume.format = "raw volume";
    volume.place = volume.data = name.file;
    volume.size = *shape.size;
    volume.type = *shape.type;
    volume.bigEndian = shape.bigEndian;
    volume.field = shape.name;
    volume.worldFromVoxel = glm::scale(mat4d(1.0), shape.spacing);
    volume.threshold = parseThreshold(name.valueOf("threshold"), data);
    checkVolume(volume);
    const std::uint64_t bytes =
        std::uint64_t(bytesOf(volume.type)) * std::uint64_t(volume.size.x) * volume.size.y * volume.size.z;
    if (const std::uint64_t found = InputFile(name.file).size(); found != bytes)
        throw Error(name.file, fmt::format("expected {} bytes for {} x {} x {} numbers of {} bytes, found {}", bytes,
                                           volume.size.x, volume.size.y, volume.size.z, bytesOf(volume.type), found));
    return makeVolumeDataSet(std::move(volume));
}

} // namespace brickwall
