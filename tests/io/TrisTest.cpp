// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/ExaGeometry.h"
#include "brickwall/tests/io/IoTest.h"
#include "brickwall/tests/oracles/WriteExa.h"

#include <limits>

namespace brickwall {
namespace {

using namespace oracles;

const TriangleMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};

std::string trisError(const std::vector<TriangleMesh>& meshes, std::uintmax_t cut = 0)
{
    const std::string path = testFolder() + "/t.tris";
    writeTriangles(path, meshes);
    std::filesystem::resize_file(path, std::filesystem::file_size(path) - cut);
    Progress silent;
    return errorOf([&] { readTriangles(path, silent); });
}

TEST(Tris, TruncationIsAnErrorWithItsPlace)
{
    EXPECT_TRUE(says(trisError({triangle}, 1), {"t.tris", "1 triangles announced at byte 40", "room for 0"}));
    EXPECT_TRUE(says(trisError({triangle}, 14), {"t.tris", "the number of triangles"}));
    EXPECT_TRUE(says(trisError({triangle, triangle}, 54), {"t.tris", "the number of vertices"}));
}

TEST(Tris, AbsurdCountsAreRefused)
{
    const std::string path = testFolder() + "/t.tris";
    for (const std::int32_t count : {0x7fffffff, -5, 0x03000000}) {
        const std::int32_t words[] = {count, 0, 0, 0};
        writeBytes(path, std::as_bytes(std::span(words)));
        Progress silent;
        EXPECT_TRUE(says(errorOf([&] { readTriangles(path, silent); }),
                         {"t.tris", "vertices", "byte 0", std::to_string(count)}));
    }
}

TEST(Tris, IndicesHaveToBeOfVertices)
{
    TriangleMesh bad = triangle;
    bad.triangles.push_back({0, 3, 1});
    EXPECT_TRUE(says(trisError({triangle, bad}), {"t.tris", "mesh 1, triangle 1", "(0,3,1)"}));
    bad.triangles.back() = {0, -1, 1};
    EXPECT_TRUE(says(trisError({bad}), {"mesh 0, triangle 1", "(0,-1,1)"}));
}

TEST(Tris, VerticesHaveToBeFinite)
{
    TriangleMesh bad = triangle;
    bad.vertices[2].y = std::numeric_limits<float>::quiet_NaN();
    EXPECT_TRUE(says(trisError({bad}), {"t.tris", "mesh 0, vertex 2", "nan"}));
}

} // namespace
} // namespace brickwall
