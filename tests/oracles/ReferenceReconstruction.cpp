// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/oracles/ReferenceReconstruction.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <glm/matrix.hpp>

namespace brickwall::oracles {
namespace {

/// One axis of a tent at offset `x` from its centre, in widths: value and slope per voxel, taken from the right at
/// kinks.
struct Tent
{
    double value, slope;

    Tent(double x, double width) : value(std::max(0.0, 1.0 - std::abs(x))), slope(0.0)
    {
        if (x >= -1.0 && x < 0.0)
            slope = 1.0 / width;
        if (x >= 0.0 && x < 1.0)
            slope = -1.0 / width;
    }
};

/// Numerator and denominator of B with their gradients per voxel.
struct Sums
{
    double n = 0.0, d = 0.0;
    vec3d gradN{0.0}, gradD{0.0};

    void add(const Tent& x, const Tent& y, const Tent& z, double v)
    {
        const double h = x.value * y.value * z.value;
        const vec3d g(x.slope * y.value * z.value, x.value * y.slope * z.value, x.value * y.value * z.slope);
        n += h * v;
        d += h;
        gradN += g * v;
        gradD += g;
    }
};

} // namespace

std::size_t ReferenceReconstruction::KeyHash::operator()(const vec3i& c) const
{
    std::uint64_t h = std::uint64_t(std::uint32_t(c.x)) * 0x9e3779b97f4a7c15u;
    h = (h ^ (h >> 29) ^ std::uint32_t(c.y)) * 0xbf58476d1ce4e5b9u;
    h = (h ^ (h >> 32) ^ std::uint32_t(c.z)) * 0x94d049bb133111ebu;
    return h ^ (h >> 31);
}

ReferenceReconstruction::ReferenceReconstruction(const Model& model, const Field& field)
    : voxelFromWorld_(glm::inverse(model.worldFromVoxel))
{
    const std::vector<std::uint64_t> counts = cellsPerLevel(model.bricks);
    levels_.resize(counts.size());
    for (std::size_t level = 0; level < counts.size(); ++level)
        levels_[level].reserve(counts[level]);
    for (const Brick& brick : model.bricks) {
        const vec3i first = brick.lower / brick.cellWidth(); // exact: bricks are aligned
        std::uint64_t slot = brick.begin;
        for (int k = 0; k < brick.size.z; ++k)
            for (int j = 0; j < brick.size.y; ++j)
                for (int i = 0; i < brick.size.x; ++i)
                    levels_[brick.level][first + vec3i(i, j, k)] = field.values[slot++];
    }
}

ReferenceReconstruction::Sample ReferenceReconstruction::at(const vec3d& world) const
{
    Sample sample = atVoxel(transformPoint(voxelFromWorld_, world));
    sample.gradient = glm::transpose(glm::dmat3(voxelFromWorld_)) * sample.gradient;
    return sample;
}

ReferenceReconstruction::Sample ReferenceReconstruction::atVoxel(const vec3d& p) const
{
    Sums sums;
    double kink = std::numeric_limits<double>::infinity(), finest = 0.0;
    for (std::size_t level = 0; level < levels_.size(); ++level) {
        const double width = std::ldexp(1.0, int(level));
        const vec3d q = p / width - 0.5; // cell i has its centre at q = i
        const vec3i low(glm::floor(q));
        bool reached = false;
        for (int corner = 0; corner < 8; ++corner) {
            const vec3i cell = low + vec3i(corner & 1, (corner >> 1) & 1, corner >> 2);
            const auto it = levels_[level].find(cell);
            if (it == levels_[level].end())
                continue;
            const vec3d x = q - vec3d(cell);
            sums.add({x.x, width}, {x.y, width}, {x.z, width}, it->second);
            reached = true;
        }
        if (!reached)
            continue;
        finest = finest == 0.0 ? width : finest;
        for (int axis = 0; axis < 3; ++axis)
            kink = std::min(kink, std::abs(q[axis] - std::round(q[axis])) * width);
    }
    if (!(sums.d > 0.0))
        return {};
    return {sums.n / sums.d, (sums.gradN * sums.d - sums.gradD * sums.n) / (sums.d * sums.d), sums.d, kink / finest,
            true};
}

} // namespace brickwall::oracles
