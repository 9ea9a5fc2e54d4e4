// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/TileScene.h"

namespace brickwall {

/// A point of an opaque or translucent surface, to be lit.
struct SurfacePoint
{
    bool wanted = false;
    vec3d position{0.0}; ///< voxels, relative to the origin of the scene's volume
    vec3d normal{0.0};   ///< in world space, unit length, on the viewer's side; 0 if there is none
    vec3d toEye{0.0};    ///< in world space, unit length
    float headlight = 1; ///< what its colour is multiplied with where there is no light
};

/// Rays through a scene from points of it: towards a light, or to see what is near. Points are in voxels relative to
/// the origin of the scene's volume, directions and distances in world space. Any number of threads may ask.
class SecondaryRays
{
public:
    template <class T>
    using PerRay = RayTile::PerRay<T>;

    /// The origin of the scene's volume has been set.
    explicit SecondaryRays(const TileScene& scene);

    const TileScene& scene() const { return scene_; }

    /// The point of a tile's ray, as its floats have it.
    static vec3d pointAt(const RayTile& rays, int ray, double t);
    vec3d pointOf(const vec3d& world) const { return transformPoint(voxelFromWorld_, world); }
    /// The direction of a tile's ray, in world space.
    vec3d worldDirection(const RayTile& rays, int ray) const;
    /// Of a surface with this gradient (voxel space), on the side that the ray comes from.
    vec3d worldNormal(const vec3f& gradient, const RayTile& rays, int ray) const;
    /// The surface's point, so far above it that it is not in its own way: more than the rounding of floats there.
    vec3d above(const vec3d& position, const vec3d& normal) const;

    /// A triangle lies in this direction (unit length), less than `distance` away.
    bool blocked(const vec3d& point, const vec3d& direction, double distance) const;
    /// Appends the ray from a point in a direction (unit length) as far as `distance`.
    void append(const vec3d& point, const vec3d& direction, double distance, RayTile& rays) const;
    /// Multiplies the rays' transmittance with that of the isosurfaces that they meet.
    void passSurfaces(const RayTile& rays, TileResult& result) const;

private:
    TileScene scene_;
    Box3d bounds_;         ///< voxels, relative to the origin
    mat4d worldFromVoxel_; ///< from voxels that are relative to the origin
    mat4d voxelFromWorld_; ///< to those
    double stretch_;       ///< of worldFromVoxel_
};

} // namespace brickwall
