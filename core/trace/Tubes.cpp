// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/Streamlines.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace brickwall {
namespace {

vec3d directionAt(const std::vector<vec3d>& points, std::size_t i)
{
    const vec3d& before = points[i == 0 ? 0 : i - 1];
    const vec3d across = points[std::min(i + 1, points.size() - 1)] - before;
    return glm::normalize(glm::length(across) > 0.0 ? across : points[i] - before); // there and back
}

vec3d anyNormal(const vec3d& direction)
{
    const vec3d d = glm::abs(direction);
    const vec3d axis = d.x <= d.y && d.x <= d.z ? vec3d(1, 0, 0) : d.y <= d.z ? vec3d(0, 1, 0) : vec3d(0, 0, 1);
    return glm::normalize(glm::cross(direction, axis));
}

/// A ring of vertices around every point, that turns no more than the line does, and a fan over the ring at either end.
void addTube(const std::vector<vec3d>& points, double radius, int sides, TriangleMesh& mesh)
{
    const int first = int(mesh.vertices.size());
    vec3d normal = anyNormal(directionAt(points, 0));
    for (std::size_t i = 0; i < points.size(); ++i) {
        const vec3d direction = directionAt(points, i);
        const vec3d kept = normal - glm::dot(normal, direction) * direction;
        normal = glm::length(kept) > 1e-6 ? glm::normalize(kept) : anyNormal(direction);
        const vec3d binormal = glm::cross(direction, normal);
        for (int s = 0; s < sides; ++s) {
            const double angle = 2.0 * std::numbers::pi * s / sides;
            mesh.vertices.push_back(
                vec3f(points[i] + radius * (std::cos(angle) * normal + std::sin(angle) * binormal)));
        }
    }
    for (std::size_t i = 0; i + 1 < points.size(); ++i)
        for (int s = 0; s < sides; ++s) {
            const int ring = first + int(i) * sides, next = (s + 1) % sides;
            mesh.triangles.push_back({ring + s, ring + next, ring + sides + next});
            mesh.triangles.push_back({ring + s, ring + sides + next, ring + sides + s});
        }
    const int last = int(mesh.vertices.size()) - sides;
    for (int s = 1; s + 1 < sides; ++s) {
        mesh.triangles.push_back({first, first + s + 1, first + s});
        mesh.triangles.push_back({last, last + s, last + s + 1});
    }
}

} // namespace

TriangleMesh tubesAround(std::span<const Streamline> lines, double radius, int sides)
{
    TriangleMesh mesh;
    for (const Streamline& line : lines) {
        std::vector<vec3d> points;
        for (const vec3d& p : line.points) // a tube needs directions
            if (points.empty() || glm::distance(p, points.back()) > 1e-3 * radius)
                points.push_back(p);
        if (points.size() >= 2)
            addTube(points, radius, sides, mesh);
    }
    return mesh;
}

} // namespace brickwall
