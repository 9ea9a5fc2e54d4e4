// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/io/ProceduralNoise.h"
#include "brickwall/core/io/ProceduralSet.h"

#include <algorithm>
#include <cmath>

namespace brickwall {
namespace {

constexpr double width = 32.0; // of the domain, in parsecs

/// log10 of the density in g/cm^3. A multifractal of ridges (after Musgrave, "Texturing and Modeling", ch. 16): a finer
/// octave counts only where the coarser ones are high, so that structure grows on structure and the rest stays empty.
double logDensity(const vec3d& world)
{
    const vec3d p = world * (2.0 / width); // -1..1
    const vec3d q = p + 0.17 * gradientNoise3(1.7 * p, 11);
    const double radius2 = p.x * p.x + p.y * p.y + p.z * p.z;
    const double bank = smoothStep(-0.35, 0.5, gradientNoise(1.3 * q + vec3d(0.37), 14));
    double sum = 0.0, weight = bank * (1.0 - smoothStep(0.1, 1.2, radius2)), frequency = 2.0, amplitude = 1.0;
    for (std::uint32_t octave = 0; octave < 6 && weight > 1e-4; ++octave) {
        const double ridge = 1.0 - std::abs(1.15 * gradientNoise(frequency * q, 21 + octave));
        const double signal = std::max(0.0, ridge) * weight;
        sum += amplitude * signal * signal * std::max(0.0, ridge);
        weight = std::min(1.0, 1.5 * signal * signal);
        frequency *= 2.03;
        amplitude *= 0.62;
    }
    return -24.0 + 3.8 * sum;
}

double density(const vec3d& world)
{
    return portableExp2(3.3219280948873626 * logDensity(world));
}

/// Gas that is thin is warm, gas that is dense shields itself and is cold.
double temperature(const vec3d& world)
{
    return 10.0 + 8000.0 / (1.0 + density(world) / 1e-22);
}

} // namespace

ProceduralSet proceduralCloud(std::uint64_t cells)
{
    const int across = std::max(2, int(std::cbrt(double(cells) / 34000.0) + 0.5));
    ProceduralSet set;
    set.name = "cloud";
    set.fields = {{"density", "g/cm^3", density}, {"temperature", "K", temperature}};
    set.refinedBy = logDensity;
    set.rootBlocks = vec3i(across);
    set.levels = 5;
    set.cells = cells;
    set.worldFromVoxel = worldFromGrid(vec3d(-0.5 * width), width, across, set.levels);
    return set;
}

} // namespace brickwall
