// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"
#include "brickwall/core/shade/TransferFunction.h"
#include "brickwall/core/trace/TraceTile.h"

#include <cstdint>
#include <vector>

namespace brickwall::bench {

/// Values on a dense grid, x fastest. In its own space value (x, y, z) lies at (x, y, z). The array is longer than the
/// grid by what a sample at the last value reads beyond it.
struct DenseVolume
{
    vec3i size;
    std::vector<float> values;
    mat4d worldFromGrid{1.0};

    explicit DenseVolume(const vec3i& size);
};

/// What a march does with each sample.
enum class Work {
    fetch,    ///< the trilinear value, added up
    composite ///< and transfer function, exponential, colour and transmittance
};

/// The least that a volume renderer has to do, and nothing else: samples at equal steps along rays in lanes, the
/// trilinear interpolant of the eight values around, transfer function, exponential, front-to-back compositing. No
/// regions, levels, skipping, early end, shading, depth, bounds or statistics. What it takes is what this core can do.
///
/// `step` in grid widths, `lengthPerStep` in finest cells. The rays are in the grid's space, relative to `origin` (half
/// grid widths), and inside of it. Returns the number of samples.
std::uint64_t marchDense(const DenseVolume& volume, const TransferTable& table, Work work, float step,
                         float lengthPerStep, const vec3i& origin, const RayTile& rays, TileResult& result);

} // namespace brickwall::bench
