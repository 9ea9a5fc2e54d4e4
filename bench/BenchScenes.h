// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/bench/Roofline.h"
#include "brickwall/core/render/RayTiles.h"
#include "brickwall/core/render/Renderer.h"

#include <cstdint>
#include <string>
#include <vector>

namespace brickwall::bench {

/// Data as `brickwall render` would show them, with the transfer function that it would choose.
struct BenchScene
{
    Scene scene;
    std::uint64_t cells = 0;

    Box3d voxelBounds() const; ///< of the regions
};

/// The samples with 2 million cells, what is in ../shared/data next to this repository, and "dense": the wake with all
/// cells of one level, in bricks 64 wide. A name stands for the same scene throughout the process.
std::vector<std::string> sceneNames();
/// Null if the data are not there.
const BenchScene* sceneNamed(const std::string& name);

/// From the side and in front, filling the picture.
View viewOf(const BenchScene& scene, int pixels);

/// Of a picture so many pixels wide and high.
std::vector<RayTile> tilesOf(const ViewRays& rays, int pixels);

/// A scene's field on a dense grid over the same box, with as many values as its padded bricks have: as many bytes, and
/// much the same values along a ray.
DenseVolume denseTwin(const BenchScene& scene);

} // namespace brickwall::bench
