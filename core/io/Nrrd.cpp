// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/DataName.h"
#include "brickwall/core/io/Formats.h"
#include "brickwall/core/io/InputFile.h"
#include "brickwall/core/io/NrrdHeader.h"
#include "brickwall/core/io/VolumeFile.h"

#include <glm/gtc/matrix_transform.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace brickwall {
namespace {

/// "(1,0,0) (0,1,0) (0,0,2)": the world vectors from one sample to the next along each axis.
mat4d directions(TextCursor text, const vec3d& origin)
{
    mat4d world(1.0);
    for (int axis = 0; axis < 3; ++axis)
        world[axis] = vec4d(readNrrdVector(text), 0.0);
    world[3] = vec4d(origin, 1.0);
    // The origin is the centre of the first sample.
    return glm::translate(world, vec3d(-0.5));
}

/// Axis-aligned: without anything said, cells are 1 wide and the volume begins at 0.
mat4d spacings(const NrrdHeader& header)
{
    vec3d spacing{1.0}, lower{0.0};
    for (int axis = 0; axis < 3; ++axis) {
        if (const double s = header.perAxis("spacings", axis); std::isfinite(s) && s != 0.0)
            spacing[axis] = s;
        if (const double min = header.perAxis("axismins", axis); std::isfinite(min))
            lower[axis] = header.isNode(axis) ? min - spacing[axis] / 2.0 : min;
    }
    return glm::scale(glm::translate(mat4d(1.0), lower), spacing);
}

mat4d worldFromVoxel(const NrrdHeader& header)
{
    if (!header.has("spacedirections"))
        return spacings(header);
    vec3d origin{0.0};
    if (header.has("spaceorigin")) {
        TextCursor text = header.cursor("spaceorigin");
        origin = readNrrdVector(text);
    }
    return directions(header.cursor("spacedirections"), origin);
}

NumberType typeOf(const NrrdHeader& header)
{
    const std::string name = header.cursor("type").line("a type");
    const auto type = numberTypeNamed(name);
    if (!type)
        throw Error(header.where("type"), fmt::format("expected a type of numbers, found '{}'", name));
    return *type;
}

bool isBigEndian(const NrrdHeader& header, NumberType type)
{
    if (bytesOf(type) == 1)
        return false;
    const std::string endian = header.cursor("endian").line("big or little");
    if (endian != "big" && endian != "little")
        throw Error(header.where("endian"), fmt::format("expected big or little, found '{}'", endian));
    return endian == "big";
}

/// The file with the numbers, and where in it they begin.
void findData(const NrrdHeader& header, VolumeFile& volume)
{
    volume.data = volume.place;
    volume.offset = header.bytes();
    if (header.has("datafile")) {
        const std::string name = header.cursor("datafile").line("a file name");
        if (name.starts_with("LIST") || name.find('%') != std::string::npos)
            throw Error(header.where("datafile"),
                        fmt::format("expected one data file, found '{}'; join them first", name));
        // An absolute name stays as it is, as the format says.
        volume.data = (std::filesystem::path(volume.place).parent_path() / name).string();
        volume.offset = 0;
    } else if (header.bytes() == 0) {
        throw Error(volume.place, "expected an empty line after the header, or a field 'data file'");
    }
    const std::string encoding = header.cursor("encoding").line("an encoding");
    volume.gzip = encoding == "gzip" || encoding == "gz";
    if (!volume.gzip && encoding != "raw")
        throw Error(header.where("encoding"), fmt::format("expected encoding raw or gzip, found '{}'", encoding));
    volume.offset = afterLines(volume.data, volume.offset, header.integer("lineskip", 0, 1 << 20));
    const std::int64_t skip = header.integer("byteskip", -1, INT64_MAX);
    if (volume.gzip && skip < 0)
        throw Error(header.where("byteskip"), "expected a number of bytes from 0 for gzip data, found -1");
    if (volume.gzip)
        volume.skip = static_cast<std::uint64_t>(skip);
    else if (skip >= 0)
        volume.offset += static_cast<std::uint64_t>(skip);
}

/// A byte skip of -1 says that the numbers are at the end of the file.
void countFromEnd(const NrrdHeader& header, VolumeFile& volume)
{
    if (volume.gzip || header.integer("byteskip", -1, INT64_MAX) >= 0)
        return;
    const std::uint64_t bytes =
        std::uint64_t(bytesOf(volume.type)) * std::uint64_t(volume.size.x) * volume.size.y * volume.size.z;
    volume.offset = std::max(volume.offset, InputFile(volume.data).size() - bytes);
}

} // namespace

std::unique_ptr<DataSet> openNrrd(const std::string& data)
{
    const DataName name = splitDataName(data);
    if (!fileStart(name.file, 8).starts_with("NRRD000"))
        return nullptr;
    for (const std::string& option : name.options)
        if (!option.starts_with("threshold="))
            throw Error(data, fmt::format("expected threshold=T, found '{}'", option));
    const NrrdHeader header(name.file);
    VolumeFile volume;
    volume.format = "NRRD";
    volume.place = name.file;
    if (const std::int64_t dimension = header.cursor("dimension").integer("dimension", 1, 16); dimension != 3)
        throw Error(header.where("dimension"),
                    fmt::format("expected three dimensions of one number each, found {} dimensions", dimension));
    TextCursor sizes = header.cursor("sizes");
    for (int axis = 0; axis < 3; ++axis)
        volume.size[axis] = static_cast<int>(sizes.integer("a size", 1, coordinateLimit));
    volume.type = typeOf(header);
    findData(header, volume);
    volume.bigEndian = isBigEndian(header, volume.type);
    volume.field = stemOf(name.file);
    volume.worldFromVoxel = worldFromVoxel(header);
    volume.threshold = parseThreshold(name.valueOf("threshold"), data);
    checkVolume(volume);
    countFromEnd(header, volume);
    return makeVolumeDataSet(std::move(volume));
}

} // namespace brickwall
