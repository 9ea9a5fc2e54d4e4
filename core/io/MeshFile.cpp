// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/MeshFile.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/ExaGeometry.h"
#include "brickwall/core/io/InputFile.h"
#include "brickwall/core/io/MeshFormats.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <cmath>
#include <cstdint>

namespace brickwall {
namespace {

std::vector<TriangleMesh> readByExtension(const std::string& path, Progress& progress)
{
    const std::string extension = extensionOf(path);
    if (extension != ".tris" && extension != ".obj" && extension != ".ply" && extension != ".stl")
        throw Error(path, "expected a mesh: .obj, .ply, .stl or .tris");
    if (!isRegularFile(path))
        throw Error(path, "there is no such file");
    if (extension == ".tris")
        return readTriangles(path, progress);
    if (extension == ".obj")
        return readObj(path);
    return {extension == ".ply" ? readPly(path, progress) : readStl(path, progress)};
}

bool hasArea(const TriangleMesh& mesh, const vec3i& t)
{
    const vec3d a(mesh.vertices[t.x]), b(mesh.vertices[t.y]), c(mesh.vertices[t.z]);
    return glm::length(glm::cross(b - a, c - a)) > 0.0;
}

} // namespace

void addPolygon(TriangleMesh& mesh, const std::vector<double>& corners, const std::string& place)
{
    for (const double corner : corners)
        if (!(corner >= 0.0 && corner < double(mesh.vertices.size())))
            throw Error(place, fmt::format("a face has vertex {}, expected 0 to {}", corner,
                                           std::int64_t(mesh.vertices.size()) - 1));
    for (std::size_t i = 2; i < corners.size(); ++i)
        mesh.triangles.push_back({int(corners[0]), int(corners[i - 1]), int(corners[i])});
}

std::vector<TriangleMesh> readMesh(const std::string& path, Progress& progress)
{
    std::vector<TriangleMesh> meshes = readByExtension(path, progress);
    std::size_t without = 0, left = 0;
    for (TriangleMesh& mesh : meshes) {
        progress.check();
        for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
            if (const vec3f& v = mesh.vertices[i]; !isFinite(vec3d(v)))
                throw Error(path,
                            fmt::format("vertex {}: expected finite numbers, found ({}, {}, {})", i, v.x, v.y, v.z));
        without += std::erase_if(mesh.triangles, [&](const vec3i& t) { return !hasArea(mesh, t); });
        left += mesh.triangles.size();
    }
    if (left == 0)
        throw Error(path, "there is no triangle with an area");
    if (without > 0)
        progress.note(fmt::format("{}: {} triangles without an area were left out", path, without));
    return meshes;
}

} // namespace brickwall
