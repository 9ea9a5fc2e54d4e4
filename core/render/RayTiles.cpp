// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/RayTiles.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/base/SplitMix.h"

#include <fmt/format.h>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <utility>

namespace brickwall {
namespace {

/// In voxels: beyond, even a double cannot tell the cells along a ray.
constexpr double farthestEye = 1e12;

/// Every second bit of a Morton code.
int evenBits(int code)
{
    return (code & 1) | (code >> 1 & 2) | (code >> 2 & 4) | (code >> 3 & 8);
}

/// In [0, 1), the same for a pixel of a screen wherever it is rendered.
float offsetOfPixel(int x, int y)
{
    const std::uint64_t h = splitMix(std::uint64_t(std::uint32_t(x)) << 32 | std::uint32_t(y));
    return static_cast<float>(h >> 40) * 0x1p-24f;
}

/// The matrices of a host may mirror, so that the corners run the other way round; they then say themselves that the
/// eye is their centre (w = 0) and the screen ahead of it (w > 0).
bool mirroredInFront(const View& view)
{
    const vec3d center = 0.5 * (view.lowerLeft + view.upperRight);
    const double atEye = (view.clipFromWorld * vec4d(view.eye, 1.0)).w;
    const double atScreen = (view.clipFromWorld * vec4d(center, 1.0)).w;
    return atScreen > 0.0 && std::abs(atEye) < 1e-6 * atScreen;
}

void checkView(const View& view)
{
    const std::string place = fmt::format("view '{}'", view.name);
    if (view.screenWidth < 1 || view.screenHeight < 1 || view.window.width < 1 || view.window.height < 1)
        throw Error(place, fmt::format("expected a screen and a window with pixels, found {} x {} and {} x {}",
                                       view.screenWidth, view.screenHeight, view.window.width, view.window.height));
    if (!isFinite(view.eye) || !isFinite(view.lowerLeft) || !isFinite(view.lowerRight) || !isFinite(view.upperRight))
        throw Error(place, "expected finite positions of the eye and the screen's corners");
    if (!(eyeDistance(view) > 0.0) && !mirroredInFront(view))
        throw Error(place,
                    fmt::format("the eye has to be in front of its screen, found {:g} behind it", -eyeDistance(view)));
    checkSceneDepth(view);
}

} // namespace

ViewRays::ViewRays(const View& view, const Box3i& halfBounds, const mat4d& worldFromVoxel, bool interleave,
                   const ClipRegion& region)
    : view_(view),
      bounds_{0.5 * vec3d(halfBounds.lower), 0.5 * vec3d(halfBounds.upper)},
      region_(region),
      interleave_(interleave),
      voxelFromWorld_(glm::inverse(worldFromVoxel)),
      voxelWidth_(stretchOf(worldFromVoxel))
{
    checkView(view);
    eye_ = transformPoint(voxelFromWorld_, view.eye);
    toLowerLeft_ = transformVector(voxelFromWorld_, view.lowerLeft - view.eye);
    right_ = transformVector(voxelFromWorld_, view.lowerRight - view.lowerLeft);
    up_ = transformVector(voxelFromWorld_, view.upperRight - view.lowerRight);
    if (!isFinite(eye_))
        throw Error(fmt::format("view '{}'", view.name), "expected worldFromVoxel to be invertible");
    pixelWidth_ = std::sqrt(glm::length(glm::cross(right_, up_)) / double(view.screenWidth) / view.screenHeight);
    const vec3d nearest = glm::clamp(eye_, bounds_.lower, bounds_.upper);
    origin_ = vec3i(glm::round(2.0 * nearest));
    start_ = std::floor(glm::distance(eye_, nearest));
    if (!(start_ < farthestEye))
        throw Error(
            fmt::format("view '{}'", view.name),
            fmt::format("the eye is {:g} finest cells from the data, where nothing can be seen of it: expected at "
                        "most {:g}",
                        start_, farthestEye));
}

void ViewRays::fill(int x, int y, TilePixels& pixels, RayTile& rays) const
{
    int n = 0;
    for (int code = 0; code < RayTile::capacity; ++code) {
        const int px = x + evenBits(code), py = y + evenBits(code >> 1);
        if (px >= view_.window.width || py >= view_.window.height)
            continue;
        const int screenX = view_.window.x + px, screenY = view_.window.y + py;
        const double u = (screenX + 0.5) / view_.screenWidth, v = (screenY + 0.5) / view_.screenHeight;
        const vec3d direction = toLowerLeft_ + u * right_ + v * up_;
        pixels.x[n] = px;
        pixels.y[n] = py;
        pixels.worldDirection[n] = rayDirection(view_, screenX, screenY);
        pixels.voxelLength[n] = glm::length(direction);
        rays.offset[n] = interleave_ ? offsetOfPixel(screenX, screenY) : 0.0f;
        const double worldLength = glm::length(pixels.worldDirection[n]) / voxelWidth_;
        rays.worldStretch[n] = static_cast<float>(worldLength / pixels.voxelLength[n]);
        setRay(n, direction / pixels.voxelLength[n], pixels, rays);
        ++n;
    }
    pixels.count = rays.count = n;
}

void ViewRays::setRay(int ray, const vec3d& direction, const TilePixels& pixels, RayTile& rays) const
{
    const vec3d org = (eye_ + start_ * direction) - 0.5 * vec3d(origin_);
    auto inside = clip(bounds_, eye_, direction);
    if (inside && !region_.isEverything())
        inside = clip(region_, view_.eye, pixels.worldDirection[ray] / pixels.voxelLength[ray], inside->first,
                      inside->second);
    for (int axis = 0; axis < 3; ++axis) {
        rays.org[axis][ray] = inside ? static_cast<float>(org[axis]) : 0.0f;
        rays.dir[axis][ray] = static_cast<float>(direction[axis]);
    }
    rays.tNear[ray] = inside ? static_cast<float>(std::max(0.0, inside->first - start_)) : 0.0f;
    rays.tEnd[ray] = rays.tFar[ray] = inside ? static_cast<float>(std::max(0.0, inside->second - start_)) : 0.0f;
}

void ViewRays::endAt(int ray, double t, const TilePixels& pixels, RayTile& rays) const
{
    const double end = std::max(0.0, tileFromWorld(ray, t, pixels));
    rays.tEnd[ray] = rays.tFar[ray] = std::min(rays.tFar[ray], static_cast<float>(end));
}

float ViewRays::whereWide(int ray, double width, const TilePixels& pixels) const
{
    constexpr double farthest = 1e30; // for floats
    return static_cast<float>(std::clamp(tileFromWorld(ray, width / pixelWidth_, pixels), 0.0, farthest));
}

float ViewRays::sceneDepthAt(int ray, const TilePixels& pixels) const
{
    const SceneDepth* scene = view_.sceneDepth.get();
    if (!scene)
        return 1.0f;
    const int x = view_.window.x + pixels.x[ray] - scene->window.x,
              y = view_.window.y + pixels.y[ray] - scene->window.y;
    const float depth = scene->depth[std::size_t(y) * scene->window.width + x];
    return depth < 1.0f ? depth : 1.0f;
}

vec3d ViewRays::voxelAt(int ray, double t, const TilePixels& pixels) const
{
    return eye_ + t * transformVector(voxelFromWorld_, pixels.worldDirection[ray]);
}

double ViewRays::sceneAt(int ray, const TilePixels& pixels) const
{
    constexpr double nowhere = std::numeric_limits<double>::infinity();
    const float depth = sceneDepthAt(ray, pixels);
    if (depth == 1.0f)
        return nowhere;
    // z = d w, both of which are affine along the ray.
    const vec4d from = view_.clipFromWorld * vec4d(view_.eye, 1.0);
    const vec4d along = view_.clipFromWorld * vec4d(pixels.worldDirection[ray], 0.0);
    const double d = 2.0 * depth - 1.0;
    const double t = (d * from.w - from.z) / (along.z - d * along.w);
    return t >= 0.0 ? t : nowhere; // a depth that no point before the eye has
}

float ViewRays::depthAt(int ray, double t, const TilePixels& pixels) const
{
    const vec4d clip = view_.clipFromWorld * vec4d(view_.eye + t * pixels.worldDirection[ray], 1.0);
    return static_cast<float>(std::clamp(0.5 * (clip.z / clip.w) + 0.5, 0.0, 1.0));
}

} // namespace brickwall
