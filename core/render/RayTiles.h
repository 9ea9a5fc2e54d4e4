// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Box.h"
#include "brickwall/core/render/ClipRegion.h"
#include "brickwall/core/render/View.h"
#include "brickwall/core/trace/TraceTile.h"

#include <array>

namespace brickwall {

/// The pixels of a tile in the order of its rays, and what is needed to get from a distance along a ray back to the
/// world.
struct TilePixels
{
    static constexpr int width = 16; ///< of a tile; its height, too
    static_assert(width * width == RayTile::capacity);

    int count = 0;
    std::array<int, RayTile::capacity> x; ///< in the frame
    std::array<int, RayTile::capacity> y;
    std::array<vec3d, RayTile::capacity> worldDirection; ///< as of `rayDirection`, not normalised
    std::array<double, RayTile::capacity> voxelLength;   ///< of that direction in voxel space
};

/// The rays of a view through data with these bounds, computed in double, per pixel from nothing but its position on
/// the screen: tiles of a screen have the rays of the whole, bit for bit.
class ViewRays
{
public:
    /// `halfBounds` in half voxels. Throws Error for a view that is not finite, has no pixels, whose eye is not in
    /// front of its screen, or whose SceneDepth does not have its pixels.
    ViewRays(const View& view, const Box3i& halfBounds, const mat4d& worldFromVoxel, bool interleave,
             const ClipRegion& region = {});

    /// Half voxels; the eye, or the point of the bounds nearest to it: floats are relative to this.
    const vec3i& origin() const { return origin_; }
    const View& view() const { return view_; }

    /// Rays of the tile at (x, y) of the frame, clipped to its edges, to the data's bounds and to the region.
    /// Neighbouring rays are neighbours on the screen, in blocks of 2 x 2, 4 x 2, 4 x 4 and so on.
    void fill(int x, int y, TilePixels& pixels, RayTile& rays) const;
    /// Ends the ray at a hit at `t` along its worldDirection.
    void endAt(int ray, double t, const TilePixels& pixels, RayTile& rays) const;

    /// Ray parameters: the one of RayTile (voxels) from the one of worldDirection, and back.
    double tileFromWorld(int ray, double t, const TilePixels& pixels) const
    {
        return t * pixels.voxelLength[ray] - start_;
    }
    double worldFromTile(int ray, double t, const TilePixels& pixels) const
    {
        return (t + start_) / pixels.voxelLength[ray];
    }

    /// The point at `t` along a ray's worldDirection, in voxel space.
    vec3d voxelAt(int ray, double t, const TilePixels& pixels) const;

    /// How many voxels a pixel is wide at that parameter of RayTile.
    double pixelWidthAt(int ray, double t, const TilePixels& pixels) const
    {
        return pixelWidth_ * worldFromTile(ray, t, pixels); // at 1 of worldDirection it is on the screen
    }
    /// The parameter of RayTile where a pixel is `width` voxels wide; 0 where it is wider already.
    float whereWide(int ray, double width, const TilePixels& pixels) const;

    /// Where a ray meets the view's SceneDepth, along its worldDirection; infinite where nothing is there. Never
    /// negative.
    double sceneAt(int ray, const TilePixels& pixels) const;
    /// That depth itself; 1 without one.
    float sceneDepthAt(int ray, const TilePixels& pixels) const;

    /// The window depth in [0, 1] of the point at `t` along a ray's worldDirection.
    float depthAt(int ray, double t, const TilePixels& pixels) const;

private:
    void setRay(int ray, const vec3d& direction, const TilePixels& pixels, RayTile& rays) const;

    View view_;
    Box3d bounds_; ///< voxels
    ClipRegion region_;
    bool interleave_;
    mat4d voxelFromWorld_;
    vec3d eye_; ///< voxel space, as the next three
    vec3d toLowerLeft_;
    vec3d right_;
    vec3d up_;
    vec3i origin_;
    double voxelWidth_;  ///< world space, the mean
    double pixelWidth_;  ///< of a pixel on the screen, in voxels: the root of its area
    double start_ = 0.0; ///< distance from the eye at which the rays' parameters start: no data is nearer
};

} // namespace brickwall
