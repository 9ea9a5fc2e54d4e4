// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/MeshFile.h"
#include "brickwall/core/base/Box.h"
#include "brickwall/tests/io/IoTest.h"

#include <glm/geometric.hpp>

#include <cstring>
#include <fstream>
#include <limits>

namespace brickwall {
namespace {

struct Notes : Progress
{
    std::string all;
    void note(std::string_view line) override { all += line; }
};

std::string written(const std::string& name, const std::string& content)
{
    const std::string path = testFolder() + "/" + name;
    std::ofstream(path, std::ios::binary) << content;
    return path;
}

std::string meshError(const std::string& name, const std::string& content)
{
    Progress silent;
    return errorOf([&] { readMesh(written(name, content), silent); });
}

std::vector<TriangleMesh> meshOf(const std::string& name, const std::string& content)
{
    Progress silent;
    return readMesh(written(name, content), silent);
}

double areaOf(const TriangleMesh& mesh)
{
    double area = 0.0;
    for (const vec3i& t : mesh.triangles) {
        const vec3d a(mesh.vertices[t.x]), b(mesh.vertices[t.y]), c(mesh.vertices[t.z]);
        area += 0.5 * glm::length(glm::cross(b - a, c - a));
    }
    return area;
}

/// Numbers as they lie in memory.
template <class... Numbers>
std::string bytes(Numbers... numbers)
{
    std::string all;
    const auto add = [&](auto number) {
        char raw[sizeof number];
        std::memcpy(raw, &number, sizeof number);
        all.append(raw, sizeof number);
    };
    (add(numbers), ...);
    return all;
}

/// The unit square at z = 2, as two triangles or a polygon, in every form.
TEST(MeshFile, EveryFormHoldsTheSameSquare)
{
    const std::string corners = "0 0 2\n1 0 2\n1 1 2\n0 1 2\n";
    const std::string plyHead = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n"
                                "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string plyBody =
        bytes(0.f, 0.f, 2.f, 1.f, 0.f, 2.f, 1.f, 1.f, 2.f, 0.f, 1.f, 2.f) + bytes(std::uint8_t(4), 0, 1, 2, 3);
    const auto facet = [](const char* a, const char* b, const char* c) {
        return std::string("facet normal 0 0 1\nouter loop\nvertex ") + a + "\nvertex " + b + "\nvertex " + c +
               "\nendloop\nendfacet\n";
    };
    const std::string stl =
        "solid s\n" + facet("0 0 2", "1 0 2", "1 1 2") + facet("0 0 2", "1 1 2", "0 1 2") + "endsolid s\n";
    const auto raw = [](float x1, float y1, float x2, float y2) {
        return bytes(0.f, 0.f, 1.f, 0.f, 0.f, 2.f, x1, y1, 2.f, x2, y2, 2.f, std::uint16_t(0));
    };
    const std::string rawStl = std::string(80, ' ') + bytes(std::uint32_t(2)) + raw(1, 0, 1, 1) + raw(1, 1, 0, 1);
    const std::vector<std::pair<std::string, std::string>> files = {
        {"a.obj", "v 0 0 2\nv 1 0 2\nv 1 1 2\nv 0 1 2\nf 1 2 3 4\n"},
        {"b.obj", "v 0 0 2\nv 1 0 2\nv 1 1 2\nv 0 1 2\nvn 0 0 1\nf -4//1 -3//1 -2//1\nf 1//1 3//1 4//1\n"},
        {"c.ply", "ply\nformat ascii 1.0\n" + plyHead + corners + "4 0 1 2 3\n"},
        {"d.ply", "ply\nformat binary_little_endian 1.0\n" + plyHead + plyBody},
        {"e.stl", stl},
        {"F.STL", rawStl}};
    for (const auto& [name, content] : files) {
        const std::vector<TriangleMesh> meshes = meshOf(name, content);
        ASSERT_EQ(meshes.size(), 1u) << name;
        EXPECT_EQ(meshes[0].triangles.size(), 2u) << name;
        EXPECT_NEAR(areaOf(meshes[0]), 1.0, 1e-6) << name;
        Box3d bounds;
        for (const vec3f& v : meshes[0].vertices)
            bounds.extend(vec3d(v));
        EXPECT_EQ(bounds, (Box3d{vec3d(0, 0, 2), vec3d(1, 1, 2)})) << name;
        EXPECT_EQ(meshes[0].color, vec3f(0.8f)) << name;
    }
}

TEST(MeshFile, MaterialsOfObjAreMeshesWithTheirColour)
{
    written("two.mtl", "newmtl red\nKd 1 0.25 0\nnewmtl blue\nKd 0 0 1\n");
    const auto meshes = meshOf("two.obj", "mtllib two.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nusemtl red\nf 1 2 3\n"
                                          "usemtl blue\nf 1 2 4\nusemtl red\nf 2 3 4\n");
    ASSERT_EQ(meshes.size(), 2u);
    EXPECT_EQ(meshes[0].color, vec3f(1.0f, 0.25f, 0.0f));
    EXPECT_EQ(meshes[0].triangles.size(), 2u);
    EXPECT_EQ(meshes[1].color, vec3f(0.0f, 0.0f, 1.0f));
    EXPECT_EQ(meshes[1].vertices.size(), 3u);
}

TEST(MeshFile, TrianglesWithoutAnAreaAreCounted)
{
    Notes notes;
    const auto meshes =
        readMesh(written("thin.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nv 2 0 0\nf 1 2 3\nf 1 2 4\nf 1 1 3\n"), notes);
    EXPECT_EQ(meshes[0].triangles.size(), 1u);
    EXPECT_TRUE(says(notes.all, {"thin.obj", "2 triangles without an area"}));
}

TEST(MeshFile, BrokenOnesAreNamedInOneLine)
{
    const std::string points = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
    EXPECT_TRUE(says(meshError("far.obj", points + "f 1 2 9\n"), {"far.obj"}));
    const std::string facet = "facet normal 0 0 1\nouter loop\nvertex 0 0 ";
    EXPECT_TRUE(says(meshError("nan.stl", "solid s\n" + facet + "nan\n"), {"nan.stl:4", "a coordinate"}));
    EXPECT_TRUE(says(meshError("two.stl", "solid s\n" + facet + "0\nendloop\n"), {"two.stl:5", "three vertices"}));
    const std::string head = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n"
                             "element face 1\nproperty list uchar int vertex_indices\nend_header\n";
    const std::string ascii = "ply\nformat ascii 1.0\n" + head,
                      binary = "ply\nformat binary_little_endian 1.0\n" + head;
    const std::string corners = bytes(0.f, 0.f, 2.f, 1.f, 0.f, 2.f, 1.f, 1.f, 2.f);
    EXPECT_TRUE(says(meshError("a.ply", ascii + "0 0 0 1 0 0 0 1 0 3 0 1 3\n"), {"a.ply", "vertex 3", "0 to 2"}));
    EXPECT_TRUE(says(meshError("b.ply", ascii + "0 0 0 1 0 0 0 1 0 1e9 0 1"), {"b.ply", "1000000000 items"}));
    EXPECT_TRUE(says(meshError("c.ply", binary + corners + bytes(std::uint8_t(3), 0, 1)), {"c.ply", "truncated"}));
    EXPECT_TRUE(says(meshError("d.ply", binary + corners + bytes(std::uint8_t(3), 0, 1, -2)), {"d.ply", "vertex -2"}));
    const float nan = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(says(meshError("e.ply", binary + bytes(nan) + corners.substr(4) + bytes(std::uint8_t(3), 0, 1, 2)),
                     {"e.ply", "vertex 0", "finite"}));
    EXPECT_TRUE(
        says(meshError("f.ply", "ply\nformat ascii 1.0\nelement vertex 99999999999\nend_header\n"), {"f.ply:3"}));
    EXPECT_TRUE(says(meshError("g.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty half x\nend_header\n"),
                     {"g.ply:4", "half"}));
    EXPECT_TRUE(says(meshError("none.obj", points), {"none.obj", "no triangle"}));
    EXPECT_TRUE(says(meshError("empty.obj", ""), {"empty.obj", "no triangle"}));
    EXPECT_TRUE(says(meshError("flat.obj", points + "f 1 1 2\n"), {"flat.obj", "no triangle with an area"}));
    EXPECT_TRUE(says(meshError("no.ply", "not a mesh"), {"no.ply"}));
    EXPECT_TRUE(says(meshError("cut.ply", "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\n"), {"cut.ply"}));
    EXPECT_TRUE(says(meshError("cut.stl", std::string(80, ' ') + bytes(std::uint32_t(1000))), {"cut.stl"}));
    EXPECT_TRUE(says(meshError("picture.png", "png"), {"picture.png", ".obj, .ply, .stl or .tris"}));
    Progress silent;
    EXPECT_TRUE(says(errorOf([&] { readMesh(testFolder() + "/absent.obj", silent); }), {"absent.obj", "no such file"}));
    EXPECT_TRUE(says(errorOf([&] { readMesh(testFolder() + "/absent.stl", silent); }), {"absent.stl", "no such file"}));
}

} // namespace
} // namespace brickwall
