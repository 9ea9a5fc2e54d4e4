// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Frame.h"
#include "brickwall/core/render/Layers.h"
#include "brickwall/core/render/LightVisibility.h"
#include "brickwall/core/render/RayTiles.h"
#include "brickwall/core/render/TileScene.h"

#include <cstdint>
#include <optional>

namespace brickwall {

struct TileCounts
{
    TraceCounts trace;
    std::uint64_t surfaceHits = 0;
    float largestBound = 0.0f;
    std::uint64_t pixelsBeyond = 0; ///< whose bound is more than the tolerance

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
    /// Whether surfaces and planes are found here, and not by the method.
    bool hasLayers() const;
    /// The volume in front of each layer in turn, then that layer; after the last one the rest of the volume.
    void trace(const RayTile& tile, Layers& layers, TileResult& result) const;
    /// Integrates the volume along the rays, in the light of the settings.
    void integrate(const RayTile& tile, TileResult& result) const;
    /// Gives the layers with this number of all rays their light, instead of that of the eye.
    void light(const RayTile& tile, std::uint32_t number, Layers& layers, TileResult& result) const;
    /// What the colours of triangles that are drawn are multiplied with.
    RayTile::PerRay<float> shadesOf(const TilePixels& pixels, const Ends& ends, TileResult& result) const;
    TileCounts countsOf(const RayTile& tile, const TileResult& result, const Layers& layers) const;

    ViewRays rays_;
    TileScene scene_;
    RenderSettings settings_;
    std::optional<LightVisibility> light_;
};

} // namespace brickwall
