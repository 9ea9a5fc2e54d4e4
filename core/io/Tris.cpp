// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/ExaGeometry.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace brickwall {
namespace {

/// A count and as many triples of 4 bytes; moves `offset` behind them.
template <class Triple>
std::vector<Triple> readTriples(const InputFile& file, std::uint64_t& offset, const std::string& what)
{
    static_assert(sizeof(Triple) == 12);
    std::int32_t count = 0;
    file.readAt(offset, std::span(&count, 1), "the number of " + what);
    const std::uint64_t room = (file.size() - offset - sizeof(count)) / sizeof(Triple);
    if (count < 0 || static_cast<std::uint64_t>(count) > room)
        throw Error(file.path(), fmt::format("truncated or not little-endian: {} {} announced at byte {}, room for {}",
                                             count, what, offset, room));
    std::vector<Triple> triples(static_cast<std::size_t>(count));
    file.readAt(offset + sizeof(count), std::span(triples), what);
    offset += sizeof(count) + triples.size() * sizeof(Triple);
    return triples;
}

void checkMesh(const InputFile& file, std::size_t index, const TriangleMesh& mesh)
{
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        const vec3f v = mesh.vertices[i];
        if (!isFinite(vec3d(v)))
            throw Error(file.path(), fmt::format("mesh {}, vertex {}: expected finite numbers, found ({},{},{})", index,
                                                 i, v.x, v.y, v.z));
    }
    const int count = static_cast<int>(mesh.vertices.size());
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        const vec3i t = mesh.triangles[i];
        if (std::min({t.x, t.y, t.z}) < 0 || std::max({t.x, t.y, t.z}) >= count)
            throw Error(file.path(), fmt::format("mesh {}, triangle {}: expected indices below {}, found ({},{},{})",
                                                 index, i, count, t.x, t.y, t.z));
    }
}

} // namespace

std::vector<TriangleMesh> readTriangles(const std::string& path, Progress& progress)
{
    const InputFile file(path);
    progress.begin("reading triangles", file.size());
    std::vector<TriangleMesh> meshes;
    for (std::uint64_t offset = 0; offset < file.size();) {
        progress.check();
        const std::uint64_t begin = offset;
        TriangleMesh mesh;
        mesh.vertices = readTriples<vec3f>(file, offset, "vertices");
        mesh.triangles = readTriples<vec3i>(file, offset, "triangles");
        checkMesh(file, meshes.size(), mesh);
        meshes.push_back(std::move(mesh));
        progress.advance(offset - begin);
    }
    progress.end();
    if (meshes.empty())
        throw Error(path, "the file is empty, expected triangle meshes");
    return meshes;
}

} // namespace brickwall
