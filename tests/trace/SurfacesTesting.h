// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/trace/ReferenceIntegrator.h"
#include "brickwall/core/trace/Surfaces.h"
#include "brickwall/core/trace/VisibleNodes.h"
#include "brickwall/tests/oracles/Fields.h"
#include "brickwall/tests/oracles/RandomLayout.h"

#include <glm/geometric.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>
#include <utility>
#include <vector>

namespace brickwall::test {

/// A model, its regions, and surfaces in it.
struct SurfaceScene
{
    Model model;
    RegionTree tree;
    PaddedField field;
    std::vector<IsoSurface> surfaces;
    std::vector<KdNode> nodes;
    bool headlight = false;
    std::array<float, 6> metric{1, 1, 1, 0, 0, 0};

    SurfaceScene(Model itsModel, const std::vector<float>& values, float opacity = 0.01f) : model(std::move(itsModel))
    {
        const Executor serial(1);
        Progress silent;
        tree = buildRegions(model.bricks, serial, silent);
        field = padField(model.fields[0], model.bricks, tree, serial, silent);
        for (const float value : values)
            surfaces.push_back({value, vec3f(1.0f), opacity});
        nodes = surfaceNodes(tree, field, surfaces, serial);
    }

    void find(const vec3i& origin, const RayTile& rays, SurfaceHits& hits) const
    {
        TraceScene scene;
        scene.regions = &tree;
        scene.field = &field;
        scene.origin = origin;
        scene.gradientMetric = metric;
        TraceCounts counts;
        findSurfaces(scene, nodes, surfaces, headlight, rays, hits, counts);
    }

    /// One ray, of any length, in voxels; t in units of `dir`.
    std::vector<SurfaceHit> along(const vec3d& org, const vec3d& dir, double tFar) const
    {
        const vec3i origin(glm::round(2.0 * org));
        const double length = glm::length(dir);
        RayTile tile;
        tile.count = 1;
        for (int axis = 0; axis < 3; ++axis) {
            tile.org[axis][0] = float(org[axis] - 0.5 * origin[axis]);
            tile.dir[axis][0] = float(dir[axis] / length);
        }
        tile.tFar[0] = float(tFar * length);
        tile.worldStretch[0] = 1.0f;
        SurfaceHits hits;
        find(origin, tile, hits);
        for (SurfaceHit& hit : hits.hits)
            hit.t /= length;
        return hits.hits;
    }
};

/// In "surface@t" with few digits, for whole lists at a glance.
inline std::string toString(const std::vector<SurfaceHit>& hits)
{
    std::string text;
    for (const SurfaceHit& hit : hits) {
        char one[64];
        std::snprintf(one, sizeof one, "%s%d@%.6g", text.empty() ? "" : " ", hit.surface, hit.t);
        text += one;
    }
    return text;
}

/// Rays that go through random points around random cells, so that small cells, level boundaries and the rim get their
/// share; some start inside, some along an axis or in a diagonal plane.
class RandomRays
{
public:
    RandomRays(const SurfaceScene& scene, std::uint64_t seed) : scene_(scene), random_(seed) {}

    /// A full tile. Returns its origin.
    vec3i fill(RayTile& tile)
    {
        const vec3i origin(glm::round(2.0 * point()));
        tile.count = RayTile::capacity;
        for (int i = 0; i < tile.count; ++i)
            set(tile, i, origin);
        return origin;
    }

private:
    vec3d vector() { return 2.0 * vec3d(random_.real(), random_.real(), random_.real()) - 1.0; }

    vec3d point()
    {
        const Brick& brick = scene_.model.bricks[std::size_t(random_.below(int(scene_.model.bricks.size())))];
        const vec3d cells = (0.5 + 0.6 * vector()) * (vec3d(brick.size) + 1.0) - 0.5;
        return vec3d(brick.lower) + cells * double(brick.cellWidth());
    }

    void set(RayTile& tile, int i, const vec3i& origin)
    {
        const vec3d through = point();
        vec3d direction = vector();
        // Far from the origin floats are so coarse that such rays lie in the rim of bricks, where D = 0.
        const bool isNear = glm::distance(through, 0.5 * vec3d(origin)) < 1e5;
        if (isNear && random_.below(8) == 0)
            direction[random_.below(3)] = 0.0;
        if (random_.below(16) == 0)
            direction[random_.below(3)] *= 1e-5;
        while (!(glm::length(direction) > 0.1))
            direction = vector();
        direction = glm::normalize(direction);
        const Box3d bounds{0.5 * vec3d(scene_.tree.bounds.lower), 0.5 * vec3d(scene_.tree.bounds.upper)};
        const vec3d org = random_.below(4) == 0 ? through : through - 24.0 * random_.real() * direction;
        double tNear = 0.0, tFar = 1e30;
        for (int axis = 0; axis < 3; ++axis) {
            tile.org[axis][i] = float(org[axis] - 0.5 * origin[axis]);
            tile.dir[axis][i] = float(direction[axis]);
            const double d = tile.dir[axis][i], o = double(tile.org[axis][i]) + 0.5 * origin[axis];
            if (d == 0.0) {
                // In the rim itself D = 0, but the renderer shows what B tends to.
                if (o <= bounds.lower[axis] || o >= bounds.upper[axis])
                    tFar = 0.0;
                continue;
            }
            const double a = (bounds.lower[axis] - o) / d, b = (bounds.upper[axis] - o) / d;
            tNear = std::max(tNear, std::min(a, b));
            tFar = std::min(tFar, std::max(a, b));
        }
        tile.tNear[i] = tNear < tFar ? float(tNear) : 0.0f;
        tile.tFar[i] = tNear < tFar ? float(tFar) : 0.0f;
        tile.worldStretch[i] = 1.0f;
    }

    const SurfaceScene& scene_;
    oracles::Random random_;
};

} // namespace brickwall::test
