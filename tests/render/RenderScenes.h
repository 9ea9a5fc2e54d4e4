// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Renderer.h"
#include "brickwall/tests/oracles/Fields.h"
#include "brickwall/tests/oracles/RandomLayout.h"

#include <glm/geometric.hpp>

#include <cmath>
#include <functional>
#include <memory>
#include <random>
#include <utility>
#include <vector>

/// Small data that the tests of rays and renderers share.
namespace brickwall::test {

using VoxelFunction = std::function<double(const vec3d& voxel)>;

inline std::vector<Brick> numbered(std::vector<Brick> bricks)
{
    oracles::numberCells(bricks);
    return bricks;
}

/// A cube of `width` finest cells at `lower`, cut into bricks of `cut` cells of a level.
inline std::vector<Brick> cubeOfBricks(const vec3i& lower, int width, int cut, int level = 0)
{
    std::vector<Brick> bricks;
    const int step = cut << level;
    for (int z = 0; z < width; z += step)
        for (int y = 0; y < width; y += step)
            for (int x = 0; x < width; x += step)
                bricks.push_back({lower + vec3i(x, y, z), vec3i(cut), level, 0});
    return numbered(bricks);
}

/// A cube of 16^3 voxels per octant, 32^3 in all, where the octants have level 0, 1 or 2 at random, and bricks of 4
/// cells.
inline std::vector<Brick> threeLevels(unsigned seed, const vec3i& lower = vec3i(0))
{
    std::mt19937 random(seed);
    std::vector<Brick> bricks;
    for (int octant = 0; octant < 8; ++octant) {
        const vec3i corner = lower + 16 * vec3i(octant & 1, octant >> 1 & 1, octant >> 2);
        const int level = int(random() % 3);
        const auto part = cubeOfBricks(corner, 16, 4, level);
        bricks.insert(bricks.end(), part.begin(), part.end());
    }
    return numbered(bricks);
}

/// The function at the cells' centres.
inline Field fieldOf(const std::vector<Brick>& bricks, const VoxelFunction& value)
{
    return oracles::modelOf(bricks, value).fields.front();
}

inline Scene sceneOf(const std::vector<Brick>& bricks, const Field& field, const TransferFunction& tf,
                     const mat4d& worldFromVoxel = mat4d(1.0))
{
    const Executor serial(1);
    Progress silent;
    Scene scene;
    auto regions = std::make_shared<RegionTree>(buildRegions(bricks, serial, silent));
    scene.field = std::make_shared<PaddedField>(padField(field, bricks, *regions, serial, silent));
    scene.regions = regions;
    scene.transferFunction = tf;
    scene.worldFromVoxel = worldFromVoxel;
    return scene;
}

/// Extinction rises linearly from `lo` at the range's lower end to `hi`; white, or from black to red.
inline TransferFunction extinctionRamp(Range range, float lo, float hi, bool white = true)
{
    TransferFunction tf;
    tf.range = range;
    tf.kind = TransferFunction::Kind::extinction;
    tf.opacity = {{0.0f, lo}, {1.0f, hi}};
    tf.colors = white ? std::vector<ColorPoint>{{0.0f, vec3f(1.0f)}}
                      : std::vector<ColorPoint>{{0.0f, vec3f(0.0f)}, {1.0f, {1.0f, 0.0f, 0.0f}}};
    return tf;
}

/// Colour and extinction with peaks, so that nothing is symmetric.
inline TransferFunction colorful(Range range)
{
    TransferFunction tf = extinctionRamp(range, 0.0f, 0.2f);
    tf.opacity = {{0.0f, 0.02f}, {32.0f / 127.0f, 0.3f}, {64.0f / 127.0f, 0.0f}, {1.0f, 0.5f}};
    tf.colors = {{0.0f, {1.0f, 0.2f, 0.1f}}, {64.0f / 127.0f, {0.1f, 0.9f, 0.3f}}, {1.0f, {0.2f, 0.1f, 1.0f}}};
    return tf;
}

/// Smooth, with values in about [-1, 1].
inline double waves(const vec3d& p)
{
    return 0.5 * std::sin(0.31 * p.x + 0.2 * p.y) + 0.5 * std::cos(0.23 * p.z - 0.11 * p.x);
}

inline View lookAt(const vec3d& eye, const vec3d& at, int width, int height, double fov = 40.0)
{
    const vec3d up = std::abs(at.x - eye.x) + std::abs(at.z - eye.z) > 1e-9 ? vec3d(0, 1, 0) : vec3d(0, 0, 1);
    return viewOfCamera("test", eye, at, up, fov, width, height, 0.1, 1e7);
}

/// One pixel that looks exactly along an axis, without any rounding for coordinates of few bits.
inline View lookAlong(const vec3d& eye, int axis, double sign)
{
    vec3d ahead(0.0), right(0.0), up(0.0);
    ahead[axis] = sign;
    right[(axis + (sign > 0 ? 2 : 1)) % 3] = 0.5;
    up[(axis + (sign > 0 ? 1 : 2)) % 3] = 0.5;
    return viewOfScreen("along", eye, eye + ahead - right - up, eye + ahead + right - up, eye + ahead + right + up, 1,
                        1, 0.1, 1e4);
}

inline RenderSettings settingsOf(float dt, Shading shading = Shading::off)
{
    RenderSettings settings;
    settings.method = Method::midpoint;
    settings.step.dt = dt;
    settings.step.terminationOpacity = 1.0f;
    settings.shading = shading;
    return settings;
}

inline Frame renderOne(const Scene& scene, const View& view, const RenderSettings& settings, int threads = 1)
{
    const Executor executor(threads);
    Progress silent;
    return std::move(Renderer(scene, executor).render({&view, 1}, settings, silent).front());
}

/// The largest difference of any component of any pixel.
inline double difference(const Frame& a, const Frame& b)
{
    double d = 0.0;
    for (std::size_t i = 0; i < a.color.size(); ++i)
        for (int c = 0; c < 4; ++c)
            d = std::max(d, std::abs(double(a.color[i][c]) - b.color[i][c]));
    return d;
}

} // namespace brickwall::test
