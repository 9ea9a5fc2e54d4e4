// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/RayTiles.h"
#include "brickwall/core/render/TileScene.h"

#include <array>
#include <cstdint>
#include <vector>

namespace brickwall {

/// What a ray crosses that has no thickness: a surface or a contour plane.
struct Layer
{
    double t = 0.0; ///< along the tile's ray
    vec3f color{0.0f};
    float opacity = 1.0f;
    float headlight = 1.0f; ///< |cos| of gradient and ray, for surfaces if they are `shaded`
    bool isShaded = false;  ///< a surface, which light and its highlight change
    vec3f gradient{0.0f};   ///< of the field, as SurfaceHit has it
};

/// The layers of a tile's rays.
struct Layers
{
    std::vector<Layer> layers;
    std::array<std::uint32_t, RayTile::capacity + 1> first{}; ///< of ray i: [first[i], first[i + 1]), ascending t

    /// Null beyond the ray's last one.
    Layer* at(int ray, std::uint32_t number);
};

/// All surfaces (with gradients if `shaded`) and contour planes of the scene, up to the first surface behind which
/// nothing is visible.
Layers findLayers(const TileScene& scene, const ViewRays& view, bool shaded, const TilePixels& pixels,
                  const RayTile& tile, TraceCounts& counts);

} // namespace brickwall
