// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/TileScene.h"

#include <array>

namespace brickwall {

/// A point of an opaque or translucent surface, to be lit.
struct SurfacePoint
{
    bool wanted = false;
    vec3d position{0.0}; ///< voxels, relative to the origin of the scene's volume
    vec3d normal{0.0};   ///< in world space, unit length, on the viewer's side; 0 if there is none
};

/// How much of the settings' light reaches points of a scene. Any number of threads may ask.
class LightVisibility
{
public:
    template <class T>
    using PerRay = RayTile::PerRay<T>;

    /// The origin of the scene's volume has been set.
    LightVisibility(const TileScene& scene, const RenderSettings& settings);

    /// Voxels, relative to the origin of the scene's volume: the point of a tile's ray, as its floats have it.
    static vec3d pointAt(const RayTile& rays, int ray, double t);
    /// As it is in SurfacePoint.
    vec3d positionOf(const vec3d& world) const { return transformPoint(voxelFromWorld_, world); }
    /// Of a surface with this gradient (voxel space), on the side that the ray comes from.
    vec3d worldNormal(const vec3f& gradient, const RayTile& rays, int ray) const;

    /// The transmittance towards the light from the points of the first `count` rays that are wanted; the others'
    /// numbers stay. What it costs is added to `counts`.
    void from(const PerRay<vec3d>& points, const PerRay<bool>& wanted, int count, PerRay<float>& visibility,
              TraceCounts& counts) const;

    /// The part of a surface's colour that remains, of the first `count` points that are wanted.
    void onSurfaces(const PerRay<SurfacePoint>& points, int count, PerRay<float>& shades, TraceCounts& counts) const;

    /// The part of the volume's colour that remains, for a visibility.
    float remains(float visibility) const { return ambient_ + (1.0f - ambient_) * visibility; }

private:
    bool blocked(const vec3d& point) const;
    void setRay(const vec3d& point, RayTile& shadow) const;
    void passSurfaces(RayTile& shadow, TileResult& result) const;

    TileScene scene_;
    RenderSettings settings_; ///< of the rays towards the light
    Box3d bounds_;            ///< voxels, relative to the origin
    mat4d worldFromVoxel_;    ///< from voxels that are relative to the origin
    mat4d voxelFromWorld_;    ///< to those
    vec3d worldTowards_;      ///< unit length, as the next one
    vec3d towards_;           ///< in voxel space
    float worldStretch_;
    float ambient_;
};

} // namespace brickwall
