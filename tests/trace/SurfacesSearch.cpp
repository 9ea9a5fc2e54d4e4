// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/simd/Target.h"
#include "brickwall/tests/model/Layouts.h"
#include "brickwall/tests/oracles/ReferenceReconstruction.h"
#include "brickwall/tests/trace/SurfacesTesting.h"

#include <gtest/gtest.h>

// Against the plainest search there is: B by its definition at many points of a ray, halving where B - c changes sign.
namespace brickwall {
namespace {

using namespace test;
using oracles::ReferenceReconstruction;

class PlainSearch
{
public:
    PlainSearch(const SurfaceScene& scene, const RayTile& tile, int i, const vec3i& origin)
        : twin_(scene.model, scene.model.fields[0])
    {
        setRay(tile, i, origin);
    }

    void setRay(const RayTile& tile, int i, const vec3i& origin)
    {
        for (int axis = 0; axis < 3; ++axis) {
            org_[axis] = double(tile.org[axis][i]) + 0.5 * origin[axis];
            dir_[axis] = tile.dir[axis][i];
        }
        tNear_ = tile.tNear[i];
        tFar_ = tile.tFar[i];
    }

    ReferenceReconstruction::Sample at(double t) const { return twin_.atVoxel(org_ + t * dir_); }

    /// Changes of sign between samples, and between the last sample and where the data end; where B jumps there is
    /// none.
    std::vector<double> crossings(double value, double step) const
    {
        std::vector<double> found;
        double lastT = tNear_;
        while (lastT < tFar_) {
            const double t = std::min(lastT + step, tFar_);
            const bool validBefore = at(lastT).valid, validHere = at(t).valid;
            if (validBefore || validHere) {
                const double a = validBefore ? lastT : edge(t, lastT), b = validHere ? t : edge(lastT, t);
                const bool aboveAtA = at(a).value > value;
                if (aboveAtA != (at(b).value > value))
                    bisect(value, a, b, aboveAtA, found);
            }
            lastT = t;
        }
        return found;
    }

private:
    /// The last place with a value on the way to one that has none.
    double edge(double valid, double invalid) const
    {
        for (int i = 0; i < 45; ++i) {
            const double t = 0.5 * (valid + invalid);
            (at(t).valid ? valid : invalid) = t;
        }
        return valid;
    }

    void bisect(double value, double a, double b, bool aboveAtA, std::vector<double>& found) const
    {
        for (int i = 0; i < 45; ++i) {
            const double t = 0.5 * (a + b);
            const auto here = at(t);
            if (!here.valid)
                return;
            ((here.value > value) == aboveAtA ? a : b) = t;
        }
        if (std::abs(at(a).value - at(b).value) < 1e-6)
            found.push_back(0.5 * (a + b));
    }

    ReferenceReconstruction twin_;
    vec3d org_, dir_;
    double tNear_, tFar_;
};

/// Every crossing of the plain search is among the hits; hits that it stepped over come in pairs closer than a step,
/// and B has the value there.
void expectHits(const PlainSearch& plain, const IsoSurface& surface, int number, std::span<const SurfaceHit> hits)
{
    constexpr double step = 0.01;
    std::vector<double> found;
    for (const SurfaceHit& hit : hits)
        if (hit.surface == number) {
            found.push_back(hit.t);
            const auto there = plain.at(hit.t);
            ASSERT_TRUE(!there.valid || std::abs(there.value - surface.value) < 1e-9) << there.value;
        }
    const std::vector<double> wanted = plain.crossings(surface.value, step);
    std::size_t next = 0;
    for (const double t : wanted) {
        while (next + 1 < found.size() && found[next] < t - 1e-6 && found[next + 1] - found[next] < 2.0 * step)
            next += 2;
        ASSERT_LT(next, found.size()) << "lost one at " << t;
        ASSERT_NEAR(found[next], t, 1e-6);
        ++next;
    }
    for (; next < found.size(); next += 2)
        ASSERT_TRUE(next + 1 < found.size() && found[next + 1] - found[next] < 2.0 * step)
            << "false at " << found[next];
}

TEST(SurfacesSearch, AgreesWithThePlainOne)
{
    std::uint64_t hits = 0;
    for (const NamedLayout& layout : layouts()) {
        if (layout.name == "coordinate limit" || layout.name == "coarsest levels")
            continue; // too far for steps
        SCOPED_TRACE(layout.name);
        Model model = oracles::modelOf(layout.bricks, [](const vec3d&) { return 0.0; });
        model.fields[0] = oracles::randomField(model.bricks, 21);
        const SurfaceScene scene(std::move(model), {0.125f, -0.3f}, 1e-9f);
        RayTile tile;
        const vec3i origin = RandomRays(scene, 8).fill(tile);
        SurfaceHits found;
        scene.find(origin, tile, found);
        PlainSearch plain(scene, tile, 0, origin);
        for (int i = 0; i < 100; ++i) {
            SCOPED_TRACE(i);
            plain.setRay(tile, i, origin);
            const auto its = std::span(found.hits).subspan(found.first[i], found.first[i + 1] - found.first[i]);
            hits += its.size();
            for (int s = 0; s < 2; ++s)
                expectHits(plain, scene.surfaces[s], s, its);
        }
    }
    EXPECT_GT(hits, 3000u);
}

/// A layout with everything: jumps of levels and holes.
SurfaceScene jumpsAndHoles()
{
    Model model = oracles::modelOf(oracles::randomLayout({.seed = 5, .refined = 0.6, .jump = 1.0, .hole = 0.1}),
                                   [](const vec3d&) { return 0.0; });
    model.fields[0] = oracles::randomField(model.bricks, 4);
    SurfaceScene scene(std::move(model), {0.1f, -0.2f}, 0.3f);
    scene.headlight = true;
    return scene;
}

TEST(SurfacesSearch, DoesNotDependOnNeighbours)
{
    const SurfaceScene scene = jumpsAndHoles();
    RayTile tile;
    const vec3i origin = RandomRays(scene, 3).fill(tile);
    SurfaceHits all, one;
    scene.find(origin, tile, all);
    EXPECT_GT(all.hits.size(), 500u);
    for (int i = 0; i < tile.count; ++i) {
        RayTile alone = tile;
        alone.count = 1;
        for (int axis = 0; axis < 3; ++axis) {
            alone.org[axis][0] = tile.org[axis][i];
            alone.dir[axis][0] = tile.dir[axis][i];
        }
        alone.tNear[0] = tile.tNear[i];
        alone.tFar[0] = tile.tFar[i];
        scene.find(origin, alone, one);
        ASSERT_EQ(one.hits.size(), all.first[i + 1] - all.first[i]);
        for (std::size_t k = 0; k < one.hits.size(); ++k) {
            EXPECT_EQ(one.hits[k].t, all.hits[all.first[i] + k].t);
            EXPECT_EQ(one.hits[k].shade, all.hits[all.first[i] + k].shade);
            EXPECT_EQ(one.hits[k].surface, all.hits[all.first[i] + k].surface);
        }
    }
}

TEST(SurfacesSearch, FindsTheSameOnEveryInstructionSet)
{
    const SurfaceScene scene = jumpsAndHoles();
    RayTile tile;
    const vec3i origin = RandomRays(scene, 6).fill(tile);
    SurfaceHits widest, other;
    scene.find(origin, tile, widest);
    for (const auto& target : laneTargets()) {
        chooseLaneTarget(target);
        scene.find(origin, tile, other);
        ASSERT_EQ(other.first, widest.first) << target;
        for (std::size_t k = 0; k < other.hits.size(); ++k)
            EXPECT_NEAR(other.hits[k].t, widest.hits[k].t, 1e-12) << target;
    }
    chooseLaneTarget("");
}

} // namespace
} // namespace brickwall
