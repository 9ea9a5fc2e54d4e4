// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/TriangleScene.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/tests/common/Numbers.h"

#include <glm/geometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

namespace brickwall {
namespace {

using test::Numbers;

/// Twelve triangles; the vertices' bits choose the corner.
TriangleMesh boxMesh(const vec3f& lower, const vec3f& upper)
{
    TriangleMesh mesh;
    for (int i = 0; i < 8; ++i)
        mesh.vertices.emplace_back(i & 1 ? upper.x : lower.x, i & 2 ? upper.y : lower.y, i & 4 ? upper.z : lower.z);
    mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

TriangleMesh sphereMesh(const vec3d& center, double radius, int rings)
{
    TriangleMesh mesh;
    const int columns = 2 * rings;
    for (int j = 0; j <= rings; ++j)
        for (int i = 0; i < columns; ++i) {
            const double theta = std::numbers::pi * j / rings, phi = std::numbers::pi * i / rings;
            mesh.vertices.emplace_back(center + radius * vec3d(std::sin(theta) * std::cos(phi),
                                                               std::sin(theta) * std::sin(phi), std::cos(theta)));
        }
    for (int j = 0; j < rings; ++j)
        for (int i = 0; i < columns; ++i) {
            const int k = (i + 1) % columns, a = j * columns, b = a + columns;
            mesh.triangles.emplace_back(a + i, b + i, b + k);
            mesh.triangles.emplace_back(a + i, b + k, a + k);
        }
    return mesh;
}

TriangleScene sceneOf(const TriangleMesh& mesh)
{
    return TriangleScene(std::span(&mesh, 1));
}

TriangleHit hitOf(const TriangleScene& scene, const vec3d& origin, const vec3d& direction)
{
    TriangleHit hit;
    scene.intersect(std::span(&origin, 1), std::span(&direction, 1), std::span(&hit, 1));
    return hit;
}

/// The nearest face of a box with t > 0 by the slabs, or infinity.
double boxDistance(const vec3d& lower, const vec3d& upper, const vec3d& o, const vec3d& d)
{
    double enter = -std::numeric_limits<double>::infinity(), leave = std::numeric_limits<double>::infinity();
    for (int i = 0; i < 3; ++i) {
        const double a = (lower[i] - o[i]) / d[i], b = (upper[i] - o[i]) / d[i];
        enter = std::max(enter, std::min(a, b));
        leave = std::min(leave, std::max(a, b));
    }
    if (enter > leave || leave <= 0.0)
        return std::numeric_limits<double>::infinity();
    return enter > 0.0 ? enter : leave;
}

std::string messageOf(const TriangleMesh& mesh)
{
    try {
        sceneOf(mesh);
    } catch (const Error& error) {
        return error.what();
    }
    return "";
}

TEST(TriangleScene, HitsABoxWhereTheSlabsSay)
{
    const vec3d lower(-1.0, -0.5, 0.25), upper(2.0, 1.5, 0.75);
    const TriangleScene scene = sceneOf(boxMesh(lower, upper));
    Numbers number(1);
    int hits = 0, misses = 0;
    for (int i = 0; i < 20000; ++i) {
        const vec3d o = number.point(4.0), d = number.point(1.0);
        const double expected = boxDistance(lower, upper, o, d);
        if (std::abs(boxDistance(lower - 1e-5, upper + 1e-5, o, d) - expected) > 1e-3)
            continue; // so near to an edge that floats may decide either way
        const TriangleHit hit = hitOf(scene, o, d);
        ASSERT_EQ(hit.hit, std::isfinite(expected));
        ++(hit.hit ? hits : misses);
        if (hit.hit) {
            EXPECT_NEAR(hit.t * glm::length(d), expected * glm::length(d), 1e-5);
        }
    }
    EXPECT_GT(hits, 500);
    EXPECT_GT(misses, 1000);
}

TEST(TriangleScene, HitsASphereWithinItsTessellation)
{
    // A chord's sagitta is r (1 - cos(pi / rings)): with 200 rings 1.3e-4 r, twice for the two directions.
    const vec3d center(0.3, 0.2, -0.1);
    const TriangleScene scene = sceneOf(sphereMesh(center, 1.5, 200));
    Numbers number(2);
    for (int i = 0; i < 5000; ++i) {
        const vec3d o = center + 5.0 * glm::normalize(number.point(1.0)), aim = center + number.point(0.5);
        const vec3d d = aim - o;
        const double a = glm::dot(d, d), b = glm::dot(d, o - center), c = glm::dot(o - center, o - center) - 1.5 * 1.5;
        const double expected = (-b - std::sqrt(b * b - a * c)) / a;
        const TriangleHit hit = hitOf(scene, o, d);
        ASSERT_TRUE(hit.hit);
        EXPECT_NEAR(hit.t, expected, 4e-4 / glm::length(d) * 2.0);
        EXPECT_NEAR(glm::length(hit.normal), 1.0f, 1e-6f);
        const vec3d outwards = glm::normalize(o + expected * d - center);
        EXPECT_GT(std::abs(glm::dot(vec3d(hit.normal), outwards)), 0.999);
    }
}

TEST(TriangleScene, IsHitFromInside)
{
    const TriangleScene scene = sceneOf(boxMesh({-1, -1, -1}, {1, 1, 1}));
    const TriangleHit hit = hitOf(scene, {0.1, 0.2, 0.3}, {0.0, 0.0, -2.0});
    ASSERT_TRUE(hit.hit);
    EXPECT_NEAR(hit.t, 0.65, 1e-6); // along the direction as given, two long
    EXPECT_NEAR(std::abs(hit.normal.z), 1.0, 1e-6);
}

TEST(TriangleScene, LetsNoRayOutOfAClosedMesh)
{
    const TriangleScene scene = sceneOf(sphereMesh({0, 0, 0}, 1.0, 24));
    Numbers number(3);
    for (int i = 0; i < 20000; ++i)
        ASSERT_TRUE(hitOf(scene, number.point(0.5), number.point(1.0)).hit);
    for (const vec3f& v : sphereMesh({0, 0, 0}, 1.0, 24).vertices) // through the vertices and along the seams
        ASSERT_TRUE(hitOf(scene, {0, 0, 0}, vec3d(v)).hit);
}

TEST(TriangleScene, GivesTheNearestOfSeveralMeshes)
{
    const TriangleMesh meshes[] = {boxMesh({-1, -1, 4}, {1, 1, 5}), TriangleMesh{}, boxMesh({-1, -1, 2}, {1, 1, 3})};
    const TriangleScene scene{std::span(meshes)};
    EXPECT_NEAR(hitOf(scene, {0.2, 0.1, 0}, {0, 0, 1}).t, 2.0f, 1e-6f);
    EXPECT_NEAR(hitOf(scene, {0.2, 0.1, 3.5}, {0, 0, 1}).t, 0.5f, 1e-6f);
    EXPECT_NEAR(hitOf(scene, {0.2, 0.1, 9}, {0, 0, -1}).t, 4.0f, 1e-6f);
    EXPECT_FALSE(hitOf(scene, {0.2, 0.1, 9}, {0, 0, 1}).hit);
}

TEST(TriangleScene, KeepsItsDigitsFromFarAwayAndFarOut)
{
    // Floats about the origin would place the box to 0.06 and the hit to 16.
    const vec3d center(1e6, -2e6, 5e5);
    const TriangleScene scene = sceneOf(boxMesh(center - 1.0, center + 1.0));
    const vec3d eye = center + vec3d(0.2, 0.3, 1e8);
    const TriangleHit hit = hitOf(scene, eye, {0.0, 0.0, -1e8});
    ASSERT_TRUE(hit.hit);
    EXPECT_NEAR(hit.t, (1e8 - 1.0) / 1e8, 1e-7);
    EXPECT_NEAR(hitOf(scene, center + vec3d(0.2, 0.3, 3.0), {0, 0, -1}).t, 2.0f, 1e-6f);
    EXPECT_FALSE(hitOf(scene, eye, vec3d(1.5, 0.0, -1e8)).hit);
}

TEST(TriangleScene, OfTinyTrianglesIsHitToo)
{
    const TriangleScene scene = sceneOf(boxMesh(vec3f(-1e-6f), vec3f(1e-6f)));
    EXPECT_NEAR(hitOf(scene, {1e-7, 2e-7, 1.0}, {0, 0, -1}).t, 1.0 - 1e-6, 1e-7);
    EXPECT_FALSE(hitOf(scene, {1e-5, 0.0, 1.0}, {0, 0, -1}).hit);
}

TEST(TriangleScene, WithoutTrianglesIsEmptyAndNeverHit)
{
    const TriangleScene nothing{std::span<const TriangleMesh>()};
    const TriangleScene points = sceneOf({{{0, 0, 0}, {1, 1, 1}}, {}});
    EXPECT_TRUE(nothing.empty());
    EXPECT_TRUE(points.empty());
    EXPECT_FALSE(hitOf(nothing, {0, 0, 0}, {0, 0, 1}).hit);
    EXPECT_FALSE(hitOf(points, {0, 0, -1}, {0, 0, 1}).hit);
    EXPECT_FALSE(sceneOf(boxMesh({0, 0, 0}, {1, 1, 1})).empty());
}

TEST(TriangleScene, RefusesIndicesOutOfRange)
{
    TriangleMesh mesh = boxMesh({0, 0, 0}, {1, 1, 1});
    mesh.triangles[7].y = 8;
    EXPECT_NE(messageOf(mesh).find("triangle 7"), std::string::npos) << messageOf(mesh);
    mesh.triangles[7].y = -1;
    EXPECT_NE(messageOf(mesh).find("-1"), std::string::npos) << messageOf(mesh);
    mesh.triangles[7].y = 7;
    EXPECT_EQ(messageOf(mesh), "");
    EXPECT_NE(messageOf({{}, {{0, 0, 0}}}), "");
}

TEST(TriangleScene, RefusesVerticesThatAreNotFinite)
{
    for (const float bad : {std::numeric_limits<float>::quiet_NaN(), std::numeric_limits<float>::infinity()}) {
        TriangleMesh mesh = boxMesh({0, 0, 0}, {1, 1, 1});
        mesh.vertices[5].y = bad;
        EXPECT_NE(messageOf(mesh).find("vertex 5"), std::string::npos) << messageOf(mesh);
    }
}

TEST(TriangleScene, RaysThatAreNoneHitNothing)
{
    const double nan = std::numeric_limits<double>::quiet_NaN();
    const TriangleScene scene = sceneOf(boxMesh({-1, -1, -1}, {1, 1, 1}));
    EXPECT_FALSE(hitOf(scene, {0, 0, 0}, {0, 0, 0}).hit);
    EXPECT_FALSE(hitOf(scene, {0, 0, 0}, {0, nan, 1}).hit);
    EXPECT_FALSE(hitOf(scene, {nan, 0, 0}, {0, 0, 1}).hit);
    std::vector<TriangleHit> two(2);
    const vec3d one(1.0);
    EXPECT_THROW(scene.intersect(std::span(&one, 1), std::span(&one, 1), two), Error);
}

TEST(TriangleScene, AnswersManyThreadsAlike)
{
    const TriangleScene scene = sceneOf(sphereMesh({0, 0, 0}, 1.0, 32));
    Numbers number(4);
    std::vector<vec3d> origins, directions;
    for (int i = 0; i < 2000; ++i) {
        origins.push_back(number.point(3.0));
        directions.push_back(number.point(1.0));
    }
    std::vector<std::vector<TriangleHit>> hits(4, std::vector<TriangleHit>(origins.size()));
    std::vector<std::jthread> threads;
    for (std::vector<TriangleHit>& h : hits)
        threads.emplace_back([&] { scene.intersect(origins, directions, h); });
    threads.clear();
    for (const std::vector<TriangleHit>& h : hits)
        for (std::size_t i = 0; i < h.size(); ++i) {
            ASSERT_EQ(h[i].hit, hits[0][i].hit);
            ASSERT_EQ(h[i].t, hits[0][i].t);
        }
}

} // namespace
} // namespace brickwall
