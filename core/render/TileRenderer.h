// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Frame.h"
#include "brickwall/core/render/RayTiles.h"
#include "brickwall/core/render/Renderer.h"

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
    /// `triangles` may be null; everything is borrowed.
    TileRenderer(const ViewRays& rays, TraceScene scene, const TriangleScene* triangles,
                 const RenderSettings& settings);

    /// Writes the pixels of the tile at (x, y) of the frame.
    TileCounts render(int x, int y, Frame& frame) const;

private:
    /// Integrates the volume along the rays, by the method of the settings.
    void integrate(const RayTile& tile, TileResult& result) const;

    ViewRays rays_;
    TraceScene scene_;
    const TriangleScene* triangles_;
    RenderSettings settings_;
};

} // namespace brickwall
