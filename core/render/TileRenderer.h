// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Frame.h"
#include "brickwall/core/render/Layers.h"
#include "brickwall/core/render/Lighting.h"
#include "brickwall/core/render/RayTiles.h"
#include "brickwall/core/render/TileMembers.h"
#include "brickwall/core/render/TileScene.h"

#include <array>
#include <cstdint>
#include <memory>
#include <vector>

namespace brickwall {

struct TileCounts
{
    using PerLevel = std::array<std::uint64_t, maxLevel + 1>;

    TraceCounts trace;
    std::uint64_t surfaceHits = 0;
    float largestBound = 0.0f;
    std::uint64_t pixelsBeyond = 0; ///< whose bound is more than the tolerance
    PerLevel memberSamples{};       ///< by the level of the data that they were taken from; [0]: the data themselves

    TileCounts& operator+=(const TileCounts& other);
};

/// Tiles of one view: rays, triangles, volume, colour and depth. Any number of threads may render different tiles of a
/// frame.
class TileRenderer
{
public:
    TileRenderer(const ViewRays& rays, const TileScene& scene, const RenderSettings& settings);

    /// Writes the pixels of the tile at (x, y) of the frame.
    TileCounts render(int x, int y, Frame& frame) const;

private:
    /// Where the rays of a tile end in front of the data's end.
    struct Ends
    {
        RayTile::PerRay<TriangleHit> hits; ///< that are drawn
        RayTile::PerRay<float> depth;      ///< window depth of what is drawn elsewhere; 1 for nothing
    };

    Ends endRays(const TilePixels& pixels, RayTile& tile) const;
    void intersect(const TriangleScene* triangles, const TilePixels& pixels, RayTile::PerRay<TriangleHit>& hits) const;
    /// The volume in front of each layer in turn, then that layer; after the last one the rest of the volume.
    void trace(const RayTile& tile, const TileMembers& members, Layers& layers, TileResult& result,
               TileCounts& counts) const;
    /// Integrates the volume along the rays, in the light of the settings.
    void integrate(const RayTile& tile, const TileMembers& members, TileResult& result, TileCounts& counts) const;
    /// In the data first, further away in one member of the pyramid after the other.
    void integrateAll(const RayTile& tile, const TileMembers& members, TileResult& result, TileCounts& counts) const;
    void integrateIn(std::size_t member, const RayTile& tile, TileResult& result, TileCounts& counts) const;
    /// Of the layers with this number of all rays.
    RayTile::PerRay<SurfaceShade> shadesOf(const RayTile& tile, std::uint32_t number, Layers& layers,
                                           TileResult& result) const;
    /// Of the triangles that are drawn.
    RayTile::PerRay<SurfaceShade> shadesOf(const TilePixels& pixels, const Ends& ends, const RayTile& tile,
                                           TileResult& result) const;
    void count(const RayTile& tile, const TileResult& result, const Layers& layers, TileCounts& counts) const;

    ViewRays rays_;
    TileScene scene_;
    RenderSettings settings_;
    std::vector<int> levels_; ///< of the pyramid
    std::unique_ptr<const Lighting> lighting_;
};

} // namespace brickwall
