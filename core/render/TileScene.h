// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Renderer.h"
#include "brickwall/core/shade/TransferFunction.h"
#include "brickwall/core/trace/ReferenceIntegrator.h"
#include "brickwall/core/trace/Surfaces.h"

#include <span>
#include <vector>

namespace brickwall {

/// Coarser data of the same field.
struct TileMember
{
    int level = 0;
    TraceScene volume;
};

/// What tiles are rendered from. Everything is borrowed.
struct TileScene
{
    TraceScene volume;               ///< `origin` is set per view, also of the members
    std::vector<TileMember> pyramid; ///< ascending by level
    std::span<const IsoSurface> surfaces;
    std::span<const KdNode> surfaceNodes;
    std::span<const ContourPlane> planes;
    const TransferFunction* transferFunction = nullptr; ///< of the planes
    const ClipRegion* clip = nullptr;
    mat4d worldFromVoxel{1.0};
    const TriangleScene* triangles = nullptr;       ///< may be null
    const TriangleScene* occluders = nullptr;       ///< may be null
    const ReferenceIntegrator* reference = nullptr; ///< for that method
    bool referenceHasSurfaces = false;              ///< and composites them itself
};

/// Integrates a volume alone along the rays of a tile, by the method of the settings; their light is not asked.
/// `reference` is for that method.
void integrateVolume(const TraceScene& volume, const ReferenceIntegrator* reference, const RenderSettings& settings,
                     const RayTile& tile, TileResult& result);

} // namespace brickwall
