// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/shade/TransferIntegral.h"
#include "brickwall/core/trace/TraceTile.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <functional>

/// Rays through small data whose integrals are known, for the methods that take steps.
namespace brickwall::test {

using TraceMethod = void (*)(const TraceScene&, const StepParameters&, const RayTile&, TileResult&);

/// Data with all that a tile needs to be traced.
struct TracedData
{
    Scene scene;
    TransferTable table;
    TransferIntegral integral;

    TracedData(const std::vector<Brick>& bricks, const VoxelFunction& value, const TransferFunction& tf)
        : scene(sceneOf(bricks, fieldOf(bricks, value), tf)), table(tabulate(tf)), integral(integrate(tf))
    {
    }

    TraceScene traced() const
    {
        TraceScene s;
        s.regions = scene.regions.get();
        s.nodes = scene.regions->nodes;
        s.field = scene.field.get();
        s.table = &table;
        s.integral = &integral;
        return s;
    }
};

/// One ray between two points in voxels.
inline void addRay(RayTile& tile, const vec3d& from, const vec3d& to, float offset = 0.0f)
{
    const int ray = tile.count++;
    const vec3d unit = glm::normalize(to - from);
    for (int a = 0; a < 3; ++a) {
        tile.org[a][ray] = float(from[a]);
        tile.dir[a][ray] = float(unit[a]);
    }
    tile.tNear[ray] = 0.0f;
    tile.tFar[ray] = float(glm::length(to - from));
    tile.offset[ray] = offset;
    tile.worldStretch[ray] = 1.0f;
}

inline vec3d pointOn(const RayTile& tile, int ray, double t)
{
    return vec3d(tile.org[0][ray], tile.org[1][ray], tile.org[2][ray]) +
           t * vec3d(tile.dir[0][ray], tile.dir[1][ray], tile.dir[2][ray]);
}

/// Red, green, blue and opacity of one ray.
inline vec4d resultOf(const TileResult& result, int ray)
{
    return {result.color[0][ray], result.color[1][ray], result.color[2][ray], 1.0 - result.transmittance[ray]};
}

/// The same of a field along [0, length], by Simpson's rule in so many parts that its error is below 1e-8 for what is
/// smooth and below 1e-6 across a step.
inline vec4d integralAlong(const TransferFunction& tf, const std::function<double(double t)>& value, double length,
                           int parts = 20000)
{
    vec3d color(0.0);
    double depth = 0.0;
    const double h = length / parts;
    const auto at = [&](double t) {
        const double sigma = extinctionAt(tf, value(t));
        return vec4d(colorAt(tf, value(t)) * sigma, sigma);
    };
    for (int i = 0; i < parts; ++i) {
        const double t = i * h, inset = 1e-9 * h;
        const vec4d a = at(t + inset), m = at(t + 0.5 * h), b = at(t + h - inset);
        const double toMiddle = h / 24.0 * (5.0 * a.w + 8.0 * m.w - b.w), all = h / 6.0 * (a.w + 4.0 * m.w + b.w);
        color +=
            h / 6.0 * std::exp(-depth) * (vec3d(a) + 4.0 * vec3d(m) * std::exp(-toMiddle) + vec3d(b) * std::exp(-all));
        depth += all;
    }
    return vec4d(color, -std::expm1(-depth));
}

} // namespace brickwall::test
