// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/trace/TraceTile.h"
#include "brickwall/core/trace/VisibleNodes.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <gtest/gtest.h>

namespace brickwall {
namespace {

using namespace test;

struct Walked
{
    std::vector<Brick> bricks = threeLevels(3);
    Field field = fieldOf(bricks, waves);
    Scene scene = sceneOf(bricks, field, colorful({-1.0f, 1.0f}));

    TraceScene traced() const
    {
        TraceScene s;
        s.regions = scene.regions.get();
        s.nodes = scene.regions->nodes;
        s.field = scene.field.get();
        return s;
    }
};

/// One ray, from a point in voxels, as long as `length`.
void setRay(RayTile& tile, int ray, const vec3d& org, const vec3d& dir, double length)
{
    const vec3d unit = glm::normalize(dir);
    for (int a = 0; a < 3; ++a) {
        tile.org[a][ray] = float(org[a]);
        tile.dir[a][ray] = float(unit[a]);
    }
    tile.tNear[ray] = 0.0f;
    tile.tFar[ray] = float(length);
    tile.worldStretch[ray] = 1.0f;
    tile.count = std::max(tile.count, ray + 1);
}

/// Where a ray from inside leaves the data: rays come clipped to it.
double exitOf(const RegionTree& tree, const vec3d& org, const vec3d& dir)
{
    const vec3d unit = glm::normalize(dir);
    double t1 = 1e30;
    for (int a = 0; a < 3; ++a)
        t1 = std::min(t1, (0.5 * (unit[a] > 0.0 ? tree.bounds.upper[a] : tree.bounds.lower[a]) - org[a]) / unit[a]);
    return t1;
}

/// How many regions a ray is in for longer than `least`.
std::uint64_t crossed(const RegionTree& tree, const vec3d& org, const vec3d& dir, double length, double least)
{
    const vec3d unit = glm::normalize(dir);
    std::uint64_t n = 0;
    for (const Region& r : tree.regions) {
        double t0 = 0.0, t1 = length;
        for (int a = 0; a < 3; ++a) {
            const double f = (0.5 * r.lower[a] - org[a]) / unit[a], g = (0.5 * r.upper[a] - org[a]) / unit[a];
            t0 = std::max(t0, std::min(f, g));
            t1 = std::min(t1, std::max(f, g));
        }
        n += t1 - t0 > least;
    }
    return n;
}

TEST(RegionWalk, VisitsTheRegionsThatRaysOfMixedDirectionsCross)
{
    const Walked data;
    std::mt19937 random(7);
    std::uniform_real_distribution<double> in(0.0, 32.0), any(-1.0, 1.0);
    RayTile tile;
    std::uint64_t atLeast = 0, atMost = 0;
    for (int i = 0; i < RayTile::capacity; ++i) {
        const vec3d org(in(random), in(random), in(random)), dir(any(random), any(random), any(random));
        const double length = exitOf(*data.scene.regions, org, dir);
        setRay(tile, i, org, dir, length);
        atLeast += crossed(*data.scene.regions, org, dir, length, 1e-4);
        atMost += crossed(*data.scene.regions, org, dir, length, -1e-4);
    }
    const std::uint64_t visited = countRegions(data.traced(), tile);
    EXPECT_GE(visited, atLeast);
    EXPECT_LE(visited, atMost);
    EXPECT_LT(double(atMost - atLeast), 0.02 * double(atLeast)); // or this would say nothing
}

TEST(RegionWalk, ARayDoesNotDependOnItsNeighbours)
{
    const Walked data;
    const Executor serial(1);
    const TransferTable table = tabulate(data.scene.transferFunction);
    TraceScene scene = data.traced();
    scene.table = &table;
    std::mt19937 random(11);
    std::uniform_real_distribution<double> in(0.0, 32.0), any(-1.0, 1.0);
    RayTile together;
    std::vector<std::pair<vec3d, vec3d>> rays;
    for (int i = 0; i < 37; ++i) { // some lanes of the last packet are not used
        rays.push_back({{in(random), in(random), in(random)}, {any(random), any(random), any(random)}});
        setRay(together, i, rays.back().first, rays.back().second, 80.0);
    }
    TileResult all;
    traceMidpoint(scene, {0.5f, 1.0f, true}, together, all);
    std::uint64_t samples = 0;
    for (int i = 0; i < 37; ++i) {
        RayTile alone;
        setRay(alone, 0, rays[i].first, rays[i].second, 80.0);
        TileResult one;
        traceMidpoint(scene, {0.5f, 1.0f, true}, alone, one);
        EXPECT_EQ(one.transmittance[0], all.transmittance[i]);
        EXPECT_EQ(one.weightedDistance[0], all.weightedDistance[i]);
        for (int c = 0; c < 3; ++c)
            EXPECT_EQ(one.color[c][0], all.color[c][i]);
        samples += one.counts.samples;
    }
    EXPECT_EQ(all.counts.samples, samples);
}

TEST(VisibleNodes, KeepTheTreeWhereThereIsSomethingToSee)
{
    const Walked data;
    const Executor serial(1);
    const RegionTree& tree = *data.scene.regions;
    const auto allNodes =
        visibleNodes(tree, regionBounds(*data.scene.field, integrate(extinctionRamp({-2, 2}, 1, 1)), serial), serial);
    ASSERT_EQ(allNodes.size(), tree.nodes.size());
    for (std::size_t i = 0; i < allNodes.size(); ++i) {
        EXPECT_EQ(allNodes[i].axis, tree.nodes[i].axis);
        EXPECT_EQ(allNodes[i].child, tree.nodes[i].child);
    }
    const auto noNodes =
        visibleNodes(tree, regionBounds(*data.scene.field, integrate(extinctionRamp({2, 3}, 1, 1)), serial), serial);
    EXPECT_EQ(noNodes[0].axis, 3u);
    EXPECT_EQ(noNodes[0].child, KdNode::emptyLeaf);
}

} // namespace
} // namespace brickwall
