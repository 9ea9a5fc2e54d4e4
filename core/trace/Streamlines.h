// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Executor.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/trace/VectorSampler.h"

#include <cstddef>
#include <span>
#include <vector>

namespace brickwall {

/// Why a line ends.
enum class StreamlineEnd {
    edge,       ///< there are no cells further on: the end of the data, or a hole
    stagnation, ///< the speed is next to nothing
    length,     ///< it is as long as was asked for
    steps,      ///< it has as many steps as were asked for
};

struct StreamlineConfig
{
    double tolerance = 1e-7;  ///< largest estimated error of a step, in widths of the cell that it is in; > 0
    double longestStep = 0.5; ///< in the same widths, which keeps the lines round; > 0
    double length = 0.0;      ///< of each direction, in world units; 0: no limit but that of the steps
    int steps = 20000;        ///< of each direction, at most
    double stagnation = 1e-6; ///< of the data's largest speed: less is none
    bool backward = true;     ///< also against the vectors, from the seed
    bool forward = true;
};

struct Streamline
{
    std::vector<vec3d> points; ///< world space, along the vectors; at least one, the seed
    std::size_t seed = 0;      ///< which of them is the seed
    StreamlineEnd begin = StreamlineEnd::length, end = StreamlineEnd::length;
};

/// Lines along the vectors through each of the seeds, in world space; seeds without a cell yield no line. By the method
/// of Dormand and Prince (1980), of order 5 with an estimate of order 4 that sets its steps; a step that would leave
/// the data is halved until it ends within 1e-3 of a cell of their edge. Deterministic, whatever the executor. Throws
/// Error for limits that are none, and Cancelled.
std::vector<Streamline> traceStreamlines(const VectorSampler& vectors, double largestSpeed,
                                         std::span<const vec3d> seeds, const StreamlineConfig& config,
                                         const Executor& executor, Progress& progress);

/// `count` points spread evenly, but on no grid, over a box (Halton 1960): the first of them are the same for every
/// count.
std::vector<vec3d> scatteredSeeds(const Box3d& box, int count);

/// The middles of counts.x * counts.y * counts.z equal parts of a box, x fastest.
std::vector<vec3d> griddedSeeds(const Box3d& box, const vec3i& counts);

/// Tubes around lines of at least two points, with closed ends. `sides` is at least 3.
TriangleMesh tubesAround(std::span<const Streamline> lines, double radius, int sides);

} // namespace brickwall
