// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Frame.h"
#include "brickwall/core/render/RayTiles.h"
#include "brickwall/core/render/Renderer.h"

namespace brickwall {

struct TileCounts
{
    std::uint64_t samples = 0;
    std::uint64_t regionsVisited = 0;
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
    ViewRays rays_;
    TraceScene scene_;
    const TriangleScene* triangles_;
    MidpointParameters midpoint_;
};

} // namespace brickwall
