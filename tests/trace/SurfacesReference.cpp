// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/model/Layouts.h"
#include "brickwall/tests/oracles/ReferenceReconstruction.h"
#include "brickwall/tests/render/RenderScenes.h"
#include "brickwall/tests/trace/SurfacesTesting.h"

#include <gtest/gtest.h>

#include <fmt/format.h>

#include <atomic>
#include <cmath>
#include <limits>
#include <mutex>

// Against ReferenceIntegrator::surfaceHits, which shares no code with findSurfaces: every hit, in order.
namespace brickwall {
namespace {

using namespace test;

ReferenceRay referenceRay(const RayTile& tile, int i, const vec3i& origin)
{
    ReferenceRay ray{};
    for (int axis = 0; axis < 3; ++axis) {
        ray.org[axis] = double(tile.org[axis][i]) + 0.5 * origin[axis];
        ray.dir[axis] = tile.dir[axis][i];
    }
    ray.tNear = tile.tNear[i];
    ray.tFar = tile.tFar[i];
    return ray;
}

struct Comparison
{
    std::atomic<std::uint64_t> rays = 0, hits = 0, differ = 0;
    std::mutex mutex;
    double distance = 0.0; ///< largest, in voxels
    std::string first;     ///< ray that differs
};

bool sameHits(std::span<const SurfaceHit> hits, std::vector<ReferenceHit> wanted, double& distance)
{
    // A ray that touches a surface within rounding may meet it twice for one and once for the other.
    constexpr double touch = 2e-8;
    const auto again = [](const ReferenceHit& a, const ReferenceHit& b) {
        return a.surface == b.surface && b.t - a.t < touch;
    };
    if (wanted.size() == hits.size() + 1)
        wanted.erase(std::unique(wanted.begin(), wanted.end(), again), wanted.end());
    if (hits.size() != wanted.size())
        return false;
    for (std::size_t i = 0; i < hits.size(); ++i) {
        // Thin shells meet in a plane where B is constant; what is at one t has any order.
        if (hits[i].surface != wanted[i].surface && std::abs(hits[i].t - wanted[i].t) > 1e-9)
            return false;
        if (std::abs(hits[i].t - wanted[i].t) > 1e-3)
            return false;
        distance = std::max(distance, std::abs(hits[i].t - wanted[i].t));
    }
    return true;
}

void compareTile(const SurfaceScene& scene, const ReferenceIntegrator& reference, const vec3i& origin,
                 const RayTile& tile, Comparison& comparison)
{
    SurfaceHits found;
    scene.find(origin, tile, found);
    double distance = 0.0;
    for (int i = 0; i < tile.count; ++i) {
        const auto wanted = tile.tNear[i] < tile.tFar[i] ? reference.surfaceHits(referenceRay(tile, i, origin))
                                                         : std::vector<ReferenceHit>{};
        const auto hits = std::span(found.hits).subspan(found.first[i], found.first[i + 1] - found.first[i]);
        ++comparison.rays;
        comparison.hits += wanted.size();
        double d = 0.0;
        if (sameHits(hits, wanted, d)) {
            distance = std::max(distance, d);
            continue;
        }
        ++comparison.differ;
        std::string text = fmt::format("origin {} {} {}, org {:a} {:a} {:a}, dir {:a} {:a} {:a}, t {:a} {:a}\n",
                                       origin.x, origin.y, origin.z, tile.org[0][i], tile.org[1][i], tile.org[2][i],
                                       tile.dir[0][i], tile.dir[1][i], tile.dir[2][i], tile.tNear[i], tile.tFar[i]);
        for (const SurfaceHit& hit : hits)
            text += fmt::format(" found {}@{:.17g}\n", hit.surface, hit.t);
        for (const ReferenceHit& hit : wanted)
            text += fmt::format(" wanted {}@{:.17g}\n", hit.surface, hit.t);
        const std::lock_guard lock(comparison.mutex);
        comparison.first += comparison.first.size() < 4000 ? text : "";
    }
    const std::lock_guard lock(comparison.mutex);
    comparison.distance = std::max(comparison.distance, distance);
}

/// Three values: two a hundredth of a cell apart or less, one elsewhere.
std::vector<float> valuesFor(const Range& range, oracles::Random& random)
{
    const float a = range.lo + range.span() * float(0.2 + 0.6 * random.real());
    return {a, a + 0.01f * range.span(), range.lo + range.span() * float(random.real())};
}

/// 1e-5 of the finest cell; at the largest coordinates there are, what is left of double near a touch.
double largestDistance(const SurfaceScene& scene)
{
    int finest = maxLevel;
    double coordinate = 0.0;
    for (const Brick& brick : scene.model.bricks) {
        finest = std::min(finest, brick.level);
        for (int axis = 0; axis < 3; ++axis)
            coordinate = std::max(coordinate, std::abs(double(brick.lower[axis])));
    }
    const double width = 1 << finest;
    return width * std::max(1e-5, std::sqrt(std::numeric_limits<double>::epsilon() * coordinate / width));
}

void compare(const NamedLayout& layout, std::uint64_t rays, std::uint64_t seed, const Executor& executor)
{
    SCOPED_TRACE(layout.name);
    oracles::Random random(seed);
    Model model = oracles::modelOf(layout.bricks, [](const vec3d&) { return 0.0; });
    model.fields[0] = oracles::randomField(model.bricks, random.bits());
    const std::vector<float> values = valuesFor(model.fields[0].range, random);
    const SurfaceScene scene(std::move(model), values, 1e-9f);
    const TransferFunction transparent = extinctionRamp({-1.0f, 1.0f}, 0.0f, 0.0f);
    const ReferenceIntegrator reference(scene.tree, scene.field, transparent, scene.surfaces, {1, 1, 1, 0, 0, 0},
                                        false);
    Comparison comparison;
    executor.forEach(rays / RayTile::capacity, 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            RayTile tile;
            RandomRays source(scene, seed + 1000003 * i);
            const vec3i origin = source.fill(tile);
            compareTile(scene, reference, origin, tile, comparison);
        }
    });
    EXPECT_LE(double(comparison.differ), 1e-6 * double(comparison.rays)) << comparison.first;
    EXPECT_LT(comparison.distance, largestDistance(scene));
    testing::Test::RecordProperty(layout.name,
                                  fmt::format("{} rays, {} hits, {} differ, distance {:.2g}", comparison.rays.load(),
                                              comparison.hits.load(), comparison.differ.load(), comparison.distance));
}

/// Rays in planes through cell centres, in faces and along edges, and cells with few values, so that surfaces go
/// through their centres and touch, and B is constant over pieces.
RayTile latticeRays(const SurfaceScene& scene, oracles::Random& random)
{
    RayTile tile;
    tile.count = RayTile::capacity;
    const Box3i box = voxelBounds(scene.model.bricks); // the rim beyond has faces where D is 0
    const Box3i half{2 * box.lower, 2 * box.upper};
    for (int i = 0; i < tile.count; ++i) {
        vec3i direction(0);
        while (direction == vec3i(0))
            direction = {random.below(3) - 1, random.below(3) - 1, random.below(3) - 1};
        vec3i start;
        for (int axis = 0; axis < 3; ++axis)
            start[axis] = half.lower[axis] + random.below(half.upper[axis] - half.lower[axis] + 1);
        float t = 1e9f;
        for (int axis = 0; axis < 3; ++axis) {
            tile.org[axis][i] = 0.5f * float(start[axis]);
            tile.dir[axis][i] = float(direction[axis]); // not of unit length: crossings of several planes are exact
            const int end = direction[axis] > 0 ? half.upper[axis] : half.lower[axis];
            if (direction[axis] != 0)
                t = std::min(t, 0.5f * float(std::abs(end - start[axis])));
        }
        tile.tFar[i] = t;
        tile.worldStretch[i] = 1.0f;
    }
    return tile;
}

TEST(SurfacesReference, AreTheSameInPlanesAndAlongEdges)
{
    // Without holes: those have such faces, too.
    for (const NamedLayout& layout :
         {NamedLayout{"uniform blocks", oracles::uniformBlocks({3, 2, 2}, 4, 1)},
          NamedLayout{"nested levels", oracles::nestedLevels(3, 4, 2)},
          NamedLayout{"jumps of 4 to 1",
                      oracles::randomLayout({.seed = 5, .refined = 0.6, .jump = 1.0, .hole = 0.0})}}) {
        for (const int values : {3, 1000}) {
            SCOPED_TRACE(layout.name + ", " + std::to_string(values) + " values");
            oracles::Random random(31);
            Model model = oracles::modelOf(layout.bricks, [&](const vec3d&) { return double(random.below(values)); });
            const float middle = float(values / 2);
            const SurfaceScene scene(std::move(model), {middle, middle + 0.25f, middle + 0.5f}, 1e-9f);
            const TransferFunction transparent = extinctionRamp({-1.0f, 1.0f}, 0.0f, 0.0f);
            const ReferenceIntegrator reference(scene.tree, scene.field, transparent, scene.surfaces,
                                                {1, 1, 1, 0, 0, 0}, false);
            Comparison comparison;
            for (int i = 0; i < 20; ++i)
                compareTile(scene, reference, vec3i(0), latticeRays(scene, random), comparison);
            EXPECT_EQ(comparison.differ, 0u) << comparison.first;
            EXPECT_GT(comparison.hits, 1000u);
        }
    }
}

/// An extremum of B on the ray, by golden sections around the largest of many samples.
float valueToTouch(const oracles::ReferenceReconstruction& twin, const ReferenceRay& ray, double from, double to)
{
    const auto b = [&](double t) { return twin.atVoxel(ray.org + t * ray.dir).value; };
    constexpr int samples = 64;
    const double step = (to - from) / samples;
    double at = from;
    for (int i = 1; i < samples; ++i)
        at = b(from + i * step) > b(at) ? from + i * step : at;
    double lo = at - step, hi = at + step;
    for (int i = 0; i < 60; ++i) {
        const double p = lo + 0.381966 * (hi - lo), q = hi - 0.381966 * (hi - lo);
        (b(p) > b(q) ? hi : lo) = b(p) > b(q) ? q : p;
    }
    return float(b(0.5 * (lo + hi)));
}

TEST(SurfacesReference, AreTheSameWhereRaysTouch)
{
    // The values next to what B reaches at most, from both sides: as close to a touch as floats come.
    for (const NamedLayout& layout : layouts()) {
        if (layout.name != "octree" && layout.name != "nested levels" && layout.name != "jumps of 4 to 1")
            continue;
        SCOPED_TRACE(layout.name);
        Model model = oracles::modelOf(layout.bricks, [](const vec3d&) { return 0.0; });
        model.fields[0] = oracles::randomField(model.bricks, 17);
        SurfaceScene scene(std::move(model), {0.0f, 0.0f, 0.0f}, 1e-9f);
        const oracles::ReferenceReconstruction twin(scene.model, scene.model.fields[0]);
        const TransferFunction transparent = extinctionRamp({-1.0f, 1.0f}, 0.0f, 0.0f);
        const Executor serial(1);
        RayTile tile;
        const vec3i origin = RandomRays(scene, 3).fill(tile);
        Comparison comparison;
        for (int i = 0; i < tile.count; ++i) {
            const ReferenceRay ray = referenceRay(tile, i, origin);
            const float c = valueToTouch(twin, ray, ray.tNear, ray.tFar);
            scene.surfaces[0].value = std::nextafter(c, -2.0f);
            scene.surfaces[1].value = c;
            scene.surfaces[2].value = std::nextafter(c, 2.0f);
            scene.nodes = surfaceNodes(scene.tree, scene.field, scene.surfaces, serial);
            const ReferenceIntegrator reference(scene.tree, scene.field, transparent, scene.surfaces,
                                                {1, 1, 1, 0, 0, 0}, false);
            compareTile(scene, reference, origin, tile, comparison);
        }
        EXPECT_EQ(comparison.differ, 0u) << comparison.first;
        EXPECT_LT(comparison.distance, 1e-5);
    }
}

TEST(SurfacesReference, AreTheSameOnEveryLayout)
{
    const Executor executor(1);
    for (const NamedLayout& layout : layouts())
        compare(layout, 10'000, 5, executor);
}

TEST(SurfacesReference, AreTheSameOnTenMillionRaysLong)
{
    const Executor executor;
    const auto all = layouts();
    for (const NamedLayout& layout : all)
        for (std::uint64_t seed = 11; seed < 15; ++seed)
            compare(layout, 10'000'000 / (4 * all.size()), seed, executor);
}

} // namespace
} // namespace brickwall
