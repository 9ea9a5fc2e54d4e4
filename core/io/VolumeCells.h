// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/io/VolumeFile.h"
#include "brickwall/core/model/Model.h"

#include <vector>

namespace brickwall {

/// The leaf cells of a volume.
struct VolumeCells
{
    std::vector<Brick> bricks;
    std::vector<float> values;
    std::uint64_t cellCount = 0;
};

/// Merges the voxels of a volume into coarser cells where little happens. 2 x 2 x 2 cells of a level become one of the
/// next, with their mean, if they and the layer of cells of the same level around them are all there, and if all voxels
/// in these vary by at most `threshold` times the range of the whole volume. So cells that touch differ by at most one
/// level, every voxel is within that of its cell's value, and what is next to a change stays fine, which keeps the
/// reconstruction there as it was. With a threshold of 0 only equal values are merged. At odd ends voxels stay single.
///
/// Reads the volume twice, plane by plane. Memory beyond the result: at most 2.3 bytes per voxel and a few planes. A
/// voxel that is not finite is an Error that names it, or (`nonFinite` = empty) stays a NaN in a cell of its own.
/// Throws Error also for a file that ends early and for 2^32 cells, and Cancelled.
VolumeCells mergeVolume(const VolumeFile& volume, NonFinite nonFinite, const Executor& executor, Progress& progress);

} // namespace brickwall
