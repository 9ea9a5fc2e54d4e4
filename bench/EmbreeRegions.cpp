// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/bench/EmbreeRegions.h"

#include "brickwall/core/base/Error.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <limits>
#include <vector>

namespace brickwall::bench {
namespace {

constexpr int lanes = 16;

/// Relative to the origin of the scene's rays, in voxels.
struct RegionBox
{
    float lower[3], upper[3];
};

/// What one traversal is about, where Embree's callback finds it; by the rays' IDs.
struct Query
{
    RTCIntersectContext context; // first, so that a pointer to it is one to all
    alignas(64) float reciprocal[3][lanes];
    alignas(64) float exit[lanes];
};

void boundsOf(const RTCBoundsFunctionArguments* arguments)
{
    const RegionBox& box = static_cast<const RegionBox*>(arguments->geometryUserPtr)[arguments->primID];
    RTCBounds& bounds = *arguments->bounds_o;
    bounds = {box.lower[0], box.lower[1], box.lower[2], 0.0f, box.upper[0], box.upper[1], box.upper[2], 0.0f};
}

/// A ray that goes through the box behind its `tnear`, and enters it before what it has found already, has found it.
/// With the widest vectors that the renderer's own walk has, so that the comparison is fair. Embree's arrays have as
/// many rays as its own vectors: all 16, or fewer where it was built without such vectors.
template <unsigned n>
__attribute__((target("avx512f,avx512vl,avx512dq,avx512bw,fma"))) void
intersectBoxes(const RTCIntersectFunctionNArguments* arguments)
{
    const RegionBox& box = static_cast<const RegionBox*>(arguments->geometryUserPtr)[arguments->primID];
    auto* const floats = reinterpret_cast<float*>(arguments->rayhit); // RTCRayN: twelve arrays, then RTCHitN
    auto* const integers = reinterpret_cast<unsigned*>(arguments->rayhit);
    float *const tnear = floats + 3 * n, *const tfar = floats + 8 * n;
    unsigned *const ids = integers + 10 * n, *const primIDs = integers + 17 * n, *const geomIDs = integers + 18 * n;
    auto& query = *reinterpret_cast<Query*>(arguments->context);
    alignas(64) float enter[n], exit[n];
    for (unsigned i = 0; i < n; ++i)
        enter[i] = tnear[i], exit[i] = std::numeric_limits<float>::infinity();
    for (unsigned axis = 0; axis < 3; ++axis)
        for (unsigned i = 0; i < n; ++i) {
            const float reciprocal = query.reciprocal[axis][n == lanes ? i : ids[i]];
            const float a = (box.lower[axis] - floats[axis * n + i]) * reciprocal;
            const float b = (box.upper[axis] - floats[axis * n + i]) * reciprocal;
            const float first = a < b ? a : b, last = a < b ? b : a;
            enter[i] = first > enter[i] ? first : enter[i];
            exit[i] = last < exit[i] ? last : exit[i];
        }
    for (unsigned i = 0; i < n; ++i) {
        const bool found = arguments->valid[i] != 0 && enter[i] < exit[i] && enter[i] < tfar[i];
        float& exitOfRay = query.exit[n == lanes ? i : ids[i]];
        tfar[i] = found ? enter[i] : tfar[i];
        primIDs[i] = found ? arguments->primID : primIDs[i];
        geomIDs[i] = found ? arguments->geomID : geomIDs[i];
        exitOfRay = found ? exit[i] : exitOfRay;
    }
}

void intersectBox(const RTCIntersectFunctionNArguments* arguments)
{
    if (arguments->N == 16)
        intersectBoxes<16>(arguments);
    else if (arguments->N == 8)
        intersectBoxes<8>(arguments);
    else
        intersectBoxes<4>(arguments);
}

} // namespace

struct EmbreeRegions::Embree
{
    std::vector<RegionBox> boxes;
    RTCDevice device = nullptr;
    RTCScene scene = nullptr;

    ~Embree()
    {
        if (scene)
            rtcReleaseScene(scene);
        if (device)
            rtcReleaseDevice(device);
    }
};

EmbreeRegions::EmbreeRegions(const TraceScene& scene) : embree_(std::make_unique<Embree>())
{
    for (std::size_t r = 0; r < scene.regions->regions.size(); ++r) {
        if (!(scene.regionBounds[r].extinction > 0.0f))
            continue;
        const Region& region = scene.regions->regions[r];
        RegionBox& box = embree_->boxes.emplace_back();
        for (int axis = 0; axis < 3; ++axis) {
            box.lower[axis] = 0.5f * float(region.lower[axis] - scene.origin[axis]);
            box.upper[axis] = 0.5f * float(region.upper[axis] - scene.origin[axis]);
        }
    }
    embree_->device = rtcNewDevice("threads=1");
    embree_->scene = rtcNewScene(embree_->device);
    rtcSetSceneBuildQuality(embree_->scene, RTC_BUILD_QUALITY_HIGH);
    RTCGeometry geometry = rtcNewGeometry(embree_->device, RTC_GEOMETRY_TYPE_USER);
    rtcSetGeometryUserPrimitiveCount(geometry, unsigned(embree_->boxes.size()));
    rtcSetGeometryUserData(geometry, embree_->boxes.data());
    rtcSetGeometryBoundsFunction(geometry, boundsOf, nullptr);
    rtcSetGeometryIntersectFunction(geometry, intersectBox);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(embree_->scene, geometry);
    rtcReleaseGeometry(geometry);
    rtcCommitScene(embree_->scene);
    if (rtcGetDeviceError(embree_->device) != RTC_ERROR_NONE)
        throw Error("Embree", "could not build the regions");
}

EmbreeRegions::~EmbreeRegions() = default;

std::uint64_t EmbreeRegions::count(const RayTile& rays) const
{
    std::uint64_t found = 0;
    Query query;
    rtcInitIntersectContext(&query.context);
    query.context.flags = RTC_INTERSECT_CONTEXT_FLAG_COHERENT;
    RTCRayHit16 packet{};
    alignas(64) int valid[lanes];
    for (int first = 0; first < rays.count; first += lanes) {
        const int n = std::min(lanes, rays.count - first);
        for (int i = 0; i < lanes; ++i) {
            const int ray = first + std::min(i, n - 1);
            packet.ray.org_x[i] = rays.org[0][ray], packet.ray.dir_x[i] = rays.dir[0][ray];
            packet.ray.org_y[i] = rays.org[1][ray], packet.ray.dir_y[i] = rays.dir[1][ray];
            packet.ray.org_z[i] = rays.org[2][ray], packet.ray.dir_z[i] = rays.dir[2][ray];
            packet.ray.tnear[i] = rays.tNear[ray], packet.ray.mask[i] = ~0u, packet.ray.id[i] = unsigned(i);
            for (int axis = 0; axis < 3; ++axis)
                query.reciprocal[axis][i] = 1.0f / rays.dir[axis][ray];
            valid[i] = i < n && rays.tNear[ray] < rays.tFar[ray] ? -1 : 0;
        }
        while (std::ranges::any_of(valid, [](int v) { return v != 0; })) {
            for (int i = 0; i < lanes; ++i) {
                packet.ray.tfar[i] = rays.tFar[first + std::min(i, n - 1)];
                packet.hit.geomID[i] = RTC_INVALID_GEOMETRY_ID;
                packet.hit.instID[0][i] = RTC_INVALID_GEOMETRY_ID;
            }
            rtcIntersect16(valid, embree_->scene, &query.context, &packet);
            for (int i = 0; i < lanes; ++i) {
                const bool met = valid[i] != 0 && packet.hit.geomID[i] != RTC_INVALID_GEOMETRY_ID;
                found += met;
                packet.ray.tnear[i] = met ? query.exit[i] : packet.ray.tnear[i];
                valid[i] = met && query.exit[i] < rays.tFar[first + std::min(i, n - 1)] ? -1 : 0;
            }
        }
    }
    return found;
}

} // namespace brickwall::bench
