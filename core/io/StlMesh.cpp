// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/InputFile.h"
#include "brickwall/core/io/MeshFormats.h"
#include "brickwall/core/io/TextCursor.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <span>

namespace brickwall {
namespace {

constexpr std::uint64_t headBytes = 84, triangleBytes = 50; ///< a text and a count; a normal, three corners, two bytes

void addTriangle(TriangleMesh& mesh, const std::array<vec3f, 3>& corners)
{
    const int first = int(mesh.vertices.size());
    mesh.vertices.insert(mesh.vertices.end(), corners.begin(), corners.end());
    mesh.triangles.push_back({first, first + 1, first + 2});
}

TriangleMesh readBinary(const InputFile& file, std::uint64_t count, Progress& progress)
{
    TriangleMesh mesh;
    constexpr std::uint64_t atOnce = 10000;
    std::vector<std::byte> bytes(atOnce * triangleBytes);
    for (std::uint64_t done = 0; done < count; done += atOnce) {
        progress.check();
        const std::uint64_t now = std::min(atOnce, count - done);
        file.readAt(headBytes + done * triangleBytes, std::span(bytes).first(now * triangleBytes), "triangles");
        for (std::uint64_t i = 0; i < now; ++i) {
            std::array<vec3f, 3> corners;
            static_assert(sizeof corners == 36);
            std::memcpy(corners.data(), bytes.data() + i * triangleBytes + 12, sizeof corners);
            addTriangle(mesh, corners);
        }
    }
    return mesh;
}

TriangleMesh readAscii(const std::string& path, Progress& progress)
{
    TriangleMesh mesh;
    TextCursor text(path);
    text.expect("solid", "a triangle mesh, text or binary");
    text.line("the name");
    while (!text.nextIs("endsolid")) {
        progress.check();
        text.expect("facet", "a facet");
        text.line("the normal");
        text.expect("outer", "a loop");
        text.expect("loop", "a loop");
        std::array<vec3f, 3> corners;
        for (vec3f& corner : corners) {
            text.expect("vertex", "three vertices");
            for (int axis = 0; axis < 3; ++axis)
                corner[axis] = float(text.number("a coordinate"));
        }
        text.expect("endloop", "the end of a loop of three vertices");
        text.expect("endfacet", "the end of the facet");
        addTriangle(mesh, corners);
    }
    return mesh;
}

} // namespace

TriangleMesh readStl(const std::string& path, Progress& progress)
{
    const InputFile file(path);
    std::uint32_t count = 0; // little-endian, as the numbers
    if (file.size() >= headBytes)
        file.readAt(headBytes - sizeof count, std::span(&count, 1), "the number of triangles");
    // Text begins with "solid", but so do the heads of many binary files.
    if (file.size() >= headBytes && file.size() == headBytes + triangleBytes * count)
        return readBinary(file, count, progress);
    return readAscii(path, progress);
}

} // namespace brickwall
