// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Frame.h"
#include "brickwall/core/render/RayTiles.h"
#include "brickwall/core/render/Renderer.h"
#include "brickwall/core/trace/ReferenceIntegrator.h"
#include "brickwall/core/trace/Surfaces.h"

namespace brickwall {

struct TileCounts
{
    TraceCounts trace;
    std::uint64_t surfaceHits = 0;
    float largestBound = 0.0f;
    std::uint64_t pixelsBeyond = 0; ///< whose bound is more than the tolerance

    TileCounts& operator+=(const TileCounts& other);
};

/// What tiles are rendered from. Everything is borrowed.
struct TileScene
{
    TraceScene volume; ///< `origin` is set per view
    std::span<const IsoSurface> surfaces;
    std::span<const KdNode> surfaceNodes;
    const TriangleScene* triangles = nullptr;       ///< may be null
    const ReferenceIntegrator* reference = nullptr; ///< for that method
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
    /// The volume in front of each surface in turn, then that surface; after the last one the rest of the volume.
    void trace(const RayTile& tile, TileResult& result, SurfaceHits& hits) const;
    TileCounts countsOf(const RayTile& tile, const TileResult& result, const SurfaceHits& hits) const;
    /// Integrates the volume along the rays, by the method of the settings.
    void integrate(const RayTile& tile, TileResult& result) const;

    ViewRays rays_;
    TileScene scene_;
    RenderSettings settings_;
};

} // namespace brickwall
