// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/base/Error.h"
#include "brickwall/core/io/MeshFormats.h"

#include <fmt/format.h>
#include <tiny_obj_loader.h>

#include <algorithm>
#include <cstdint>
#include <map>
#include <unordered_map>
#include <utility>

namespace brickwall {
namespace {

std::string firstLine(const std::string& text)
{
    return text.substr(0, text.find('\n'));
}

/// A mesh for each material.
class ObjMeshes
{
public:
    explicit ObjMeshes(const std::string& path) : path_(path)
    {
        tinyobj::ObjReaderConfig config;
        config.vertex_color = false;
        if (!reader_.ParseFromFile(path, config))
            throw Error(path, reader_.Error().empty() ? "is no Wavefront OBJ file" : firstLine(reader_.Error()));
    }

    std::vector<TriangleMesh> take()
    {
        for (const tinyobj::shape_t& shape : reader_.GetShapes()) {
            const tinyobj::mesh_t& mesh = shape.mesh;
            for (std::size_t t = 0; t < mesh.num_face_vertices.size(); ++t)
                add(&mesh.indices[3 * t], mesh.material_ids[t]);
        }
        std::vector<TriangleMesh> meshes;
        for (auto& [material, part] : parts_)
            meshes.push_back(std::move(part.mesh));
        return meshes;
    }

private:
    struct Part
    {
        TriangleMesh mesh;
        std::unordered_map<int, int> numberOf; ///< in the mesh, of a vertex of the file
    };

    void add(const tinyobj::index_t* corners, int material)
    {
        auto [found, isNew] = parts_.try_emplace(material);
        Part& part = found->second;
        if (isNew && material >= 0)
            for (int c = 0; c < 3; ++c)
                part.mesh.color[c] = std::clamp(reader_.GetMaterials()[std::size_t(material)].diffuse[c], 0.0f, 1.0f);
        vec3i triangle(0);
        for (int i = 0; i < 3; ++i)
            triangle[i] = numberOf(part, corners[i].vertex_index);
        part.mesh.triangles.push_back(triangle);
    }

    int numberOf(Part& part, int vertex)
    {
        const std::vector<float>& numbers = reader_.GetAttrib().vertices;
        if (vertex < 0 || 3 * std::size_t(vertex) + 2 >= numbers.size())
            throw Error(path_, fmt::format("a face has vertex {}, expected 1 to {}", std::int64_t(vertex) + 1,
                                           numbers.size() / 3));
        const auto [found, isNew] = part.numberOf.try_emplace(vertex, int(part.mesh.vertices.size()));
        if (isNew)
            part.mesh.vertices.emplace_back(numbers[3 * std::size_t(vertex)], numbers[3 * std::size_t(vertex) + 1],
                                            numbers[3 * std::size_t(vertex) + 2]);
        return found->second;
    }

    std::string path_;
    tinyobj::ObjReader reader_;
    std::map<int, Part> parts_;
};

} // namespace

std::vector<TriangleMesh> readObj(const std::string& path)
{
    return ObjMeshes(path).take();
}

} // namespace brickwall
