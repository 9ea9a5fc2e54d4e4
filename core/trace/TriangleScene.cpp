// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/TriangleScene.h"

#include "brickwall/core/base/Box.h"
#include "brickwall/core/base/Error.h"

#include <embree3/rtcore.h>
#include <fmt/format.h>
#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <vector>

namespace brickwall {
namespace {

const char* toString(RTCError error)
{
    switch (error) {
    case RTC_ERROR_INVALID_ARGUMENT:
        return "invalid argument";
    case RTC_ERROR_INVALID_OPERATION:
        return "invalid operation";
    case RTC_ERROR_OUT_OF_MEMORY:
        return "out of memory";
    case RTC_ERROR_UNSUPPORTED_CPU:
        return "this processor is not supported";
    case RTC_ERROR_CANCELLED:
        return "cancelled";
    default:
        return "unknown error";
    }
}

/// Embree keeps the first error until it is asked.
void throwIfFailed(RTCDevice device, const char* task)
{
    if (const RTCError error = rtcGetDeviceError(device); error != RTC_ERROR_NONE)
        throw Error("triangle meshes", fmt::format("Embree could not {}: {}", task, toString(error)));
}

void checkMesh(const TriangleMesh& mesh, std::size_t number)
{
    constexpr std::size_t most = std::numeric_limits<unsigned>::max();
    if (mesh.vertices.size() > most || mesh.triangles.size() > most)
        throw Error(fmt::format("triangle mesh {}", number), "expected fewer than 2^32 vertices and triangles");
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
        if (const vec3f& v = mesh.vertices[i]; !isFinite(vec3d(v)))
            throw Error(fmt::format("triangle mesh {}, vertex {}", number, i),
                        fmt::format("expected finite coordinates, found ({}, {}, {})", v.x, v.y, v.z));
    const auto valid = [&](int index) { return index >= 0 && std::size_t(index) < mesh.vertices.size(); };
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
        if (const vec3i& t = mesh.triangles[i]; !valid(t.x) || !valid(t.y) || !valid(t.z))
            throw Error(fmt::format("triangle mesh {}, triangle {}", number, i),
                        fmt::format("expected vertex numbers from 0 to {}, found {}, {}, {}",
                                    std::int64_t(mesh.vertices.size()) - 1, t.x, t.y, t.z));
}

} // namespace

/// Coordinates inside Embree are relative to `center`, so that meshes far from the origin keep their digits.
struct TriangleScene::Embree
{
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;
    vec3d center{0.0};
    double radius = 0.0; ///< of the sphere around `center` that has all triangles
    bool empty = true;
    std::vector<vec3f> colors; ///< by Embree's number of a mesh

    ~Embree();
    void place(std::span<const TriangleMesh> meshes);
    void add(const TriangleMesh& mesh);
    TriangleHit intersect(const vec3d& origin, const vec3d& direction) const;
};

TriangleScene::Embree::~Embree()
{
    if (scene)
        rtcReleaseScene(scene);
    if (device)
        rtcReleaseDevice(device);
}

void TriangleScene::Embree::place(std::span<const TriangleMesh> meshes)
{
    Box3d bounds;
    for (const TriangleMesh& mesh : meshes) {
        empty = empty && mesh.triangles.empty();
        for (const vec3f& v : mesh.vertices)
            bounds.extend(vec3d(v));
    }
    if (empty)
        return;
    center = 0.5 * (bounds.lower + bounds.upper);
    // A little more than the sphere, so that rounding never moves a ray's start behind a triangle.
    radius = 0.5 * glm::length(bounds.extent()) * (1.0 + 1e-5);
}

void TriangleScene::Embree::add(const TriangleMesh& mesh)
{
    if (mesh.triangles.empty())
        return;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    throwIfFailed(device, "make a mesh");
    auto* vertices = static_cast<float*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                                                 3 * sizeof(float), mesh.vertices.size()));
    auto* indices = static_cast<unsigned*>(rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                                                   3 * sizeof(unsigned), mesh.triangles.size()));
    if (vertices && indices) {
        for (const vec3f& v : mesh.vertices)
            for (int i = 0; i < 3; ++i)
                *vertices++ = float(double(v[i]) - center[i]);
        for (const vec3i& t : mesh.triangles)
            for (int i = 0; i < 3; ++i)
                *indices++ = unsigned(t[i]);
        rtcCommitGeometry(geometry);
        const unsigned number = rtcAttachGeometry(scene, geometry);
        colors.resize(std::max<std::size_t>(colors.size(), number + 1));
        colors[number] = mesh.color;
    }
    rtcReleaseGeometry(geometry);
    throwIfFailed(device, "take the vertices and triangles");
}

TriangleHit TriangleScene::Embree::intersect(const vec3d& origin, const vec3d& direction) const
{
    const double length = glm::length(direction);
    if (!(length > 0.0) || !std::isfinite(length) || !isFinite(origin))
        return {};
    // Start where the ray enters the sphere: a float could not hold a far eye and a near triangle at once.
    const vec3d d = direction / length;
    const vec3d toCenter = center - origin;
    const double start = std::max(0.0, glm::dot(toCenter, d) - radius);
    const vec3d o = start * d - toCenter;
    if (glm::length(o) > 3.0 * radius)
        return {};
    RTCRayHit ray{};
    ray.ray = {float(o.x), float(o.y), float(o.z), std::numeric_limits<float>::min(),      float(d.x),
               float(d.y), float(d.z), 0.0f,       std::numeric_limits<float>::infinity(), ~0u,
               0u,         0u};
    ray.hit.geomID = RTC_INVALID_GEOMETRY_ID;
    ray.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
    RTCIntersectContext context;
    rtcInitIntersectContext(&context);
    rtcIntersect1(scene, &context, &ray);
    if (ray.hit.geomID == RTC_INVALID_GEOMETRY_ID)
        return {};
    const vec3d normal(ray.hit.Ng_x, ray.hit.Ng_y, ray.hit.Ng_z);
    return {float((start + ray.ray.tfar) / length), vec3f(glm::normalize(normal)), true, colors[ray.hit.geomID]};
}

TriangleScene::TriangleScene(std::span<const TriangleMesh> meshes) : embree_(std::make_unique<Embree>())
{
    for (std::size_t i = 0; i < meshes.size(); ++i)
        checkMesh(meshes[i], i);
    embree_->place(meshes);
    if (embree_->empty)
        return;
    embree_->device = rtcNewDevice(nullptr);
    throwIfFailed(embree_->device, "start");
    embree_->scene = rtcNewScene(embree_->device);
    throwIfFailed(embree_->device, "make a scene");
    // Robust: no ray slips through the edge between two triangles.
    rtcSetSceneFlags(embree_->scene, RTC_SCENE_FLAG_ROBUST);
    for (const TriangleMesh& mesh : meshes)
        embree_->add(mesh);
    rtcCommitScene(embree_->scene);
    throwIfFailed(embree_->device, "build the scene");
}

TriangleScene::~TriangleScene() = default;
TriangleScene::TriangleScene(TriangleScene&&) noexcept = default;
TriangleScene& TriangleScene::operator=(TriangleScene&&) noexcept = default;

bool TriangleScene::empty() const
{
    return embree_->empty;
}

void TriangleScene::intersect(std::span<const vec3d> origins, std::span<const vec3d> directions,
                              std::span<TriangleHit> hits) const
{
    if (origins.size() != hits.size() || directions.size() != hits.size())
        throw Error("TriangleScene::intersect",
                    fmt::format("expected as many origins and directions as hits, found {}, {}, {}", origins.size(),
                                directions.size(), hits.size()));
    for (std::size_t i = 0; i < hits.size(); ++i)
        hits[i] = embree_->empty ? TriangleHit{} : embree_->intersect(origins[i], directions[i]);
}

} // namespace brickwall
