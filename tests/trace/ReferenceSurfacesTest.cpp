// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/trace/ReferenceScene.h"

#include "brickwall/tests/oracles/ReferenceReconstruction.h"

#include <gtest/gtest.h>

#include <cmath>

// Where the reference integrator finds surfaces: each once, wherever it lies.
namespace brickwall {
namespace {

/// A function of 8 x 8 x 8 finest cells in bricks of 3 x 3 x 3, exact if it is linear along each axis.
ReferenceScene cubeOf(const std::function<double(const vec3d&)>& value)
{
    return ReferenceScene(oracles::modelOf(oracles::oneLevelBricks(vec3i(0), vec3i(8), vec3i(3), 0), value));
}

double rampValue(const vec3d& p)
{
    return p.x;
}

/// x y: 16 - u^2 along (4, 4) + u (1, -1).
double saddleValue(const vec3d& p)
{
    return p.x * p.y;
}

std::vector<ReferenceHit> hitsOf(const ReferenceScene& scene, float value, const ReferenceRay& ray)
{
    const std::vector<IsoSurface> surfaces{{value}};
    return scene.with(extinctionOver(0.0f, 1.0f, {{0.0f, 0.0f}}), surfaces).surfaceHits(ray);
}

TEST(ReferenceSurfaces, AreHitAtTheExactPlace)
{
    const ReferenceScene scene = cubeOf(rampValue);
    for (float value : {1.0f, 3.3f, 3.5f, 5.99f, 6.0f, 6.5f}) { // 3.5: at a cell's centre; 6: between bricks
        const ReferenceRay along = between({0.6, 4.5, 4.5}, {7.4, 4.5, 4.5});
        const auto hits = hitsOf(scene, value, along);
        ASSERT_EQ(hits.size(), 1u) << value;
        EXPECT_NEAR(hits[0].t, value - 0.6, 1e-13);
        EXPECT_NEAR(glm::length(hits[0].gradient - vec3d(1, 0, 0)), 0.0, 1e-13);
        const ReferenceRay oblique = between({7.4, 1.1, 1.2}, {0.6, 6.1, 5.2});
        const auto back = hitsOf(scene, value, oblique);
        ASSERT_EQ(back.size(), 1u) << value;
        EXPECT_NEAR(back[0].t, (value - 7.4) / oblique.dir.x, 1e-12);
    }
}

TEST(ReferenceSurfaces, AreHitOnceInTheCorner)
{
    const ReferenceScene scene = cubeOf([](const vec3d& p) { return p.x + p.y + p.z; });
    const ReferenceRay diagonal = between(vec3d(0.75), vec3d(7.25)); // passes planes along three axes at once
    for (float centre : {3.5f, 5.5f, 6.0f}) {
        const auto hits = hitsOf(scene, 3.0f * centre, diagonal);
        ASSERT_EQ(hits.size(), 1u) << centre;
        EXPECT_NEAR(hits[0].t, (centre - 0.75) * std::sqrt(3.0), 1e-12);
    }
}

TEST(ReferenceSurfaces, AreHitOnceAtTheEndsOfTheRay)
{
    const ReferenceScene scene = cubeOf(rampValue);
    EXPECT_EQ(hitsOf(scene, 2.0f, between({2.0, 4.5, 4.5}, {4.0, 4.5, 4.5})).size(), 1u);
    EXPECT_EQ(hitsOf(scene, 4.0f, between({2.0, 4.5, 4.5}, {4.0, 4.5, 4.5})).size(), 1u);
    EXPECT_EQ(hitsOf(scene, 4.01f, between({2.0, 4.5, 4.5}, {4.0, 4.5, 4.5})).size(), 0u);
}

TEST(ReferenceSurfaces, AreHitOnceByATangentRay)
{
    const ReferenceScene scene = cubeOf(saddleValue);
    for (double middle : {4.0, 4.5, 4.25}) { // inside a piece; at a corner of pieces; elsewhere
        const float value = float(middle * middle);
        const ReferenceRay ray = between({middle - 3.0, middle + 3.0, 4.1}, {middle + 3.0, middle - 3.0, 4.1});
        const auto touch = hitsOf(scene, value, ray);
        ASSERT_EQ(touch.size(), 1u) << middle;
        EXPECT_NEAR(touch[0].t, 3.0 * std::sqrt(2.0), 1e-6);
        EXPECT_EQ(hitsOf(scene, std::nextafter(value, 99.0f), ray).size(), 0u);
        const float inside = std::nextafter(value, 0.0f);
        const auto pair = hitsOf(scene, inside, ray);
        ASSERT_EQ(pair.size(), 2u);
        const double apart = 2.0 * std::sqrt(2.0 * (double(value) - inside));
        EXPECT_NEAR((pair[1].t - pair[0].t) / apart, 1.0, 1e-6);
    }
}

TEST(ReferenceSurfaces, AreHitOnceByTangentRaysOfAnyDirection)
{
    const ReferenceScene scene = cubeOf(saddleValue);
    oracles::Random random(6);
    for (int i = 0; i < 1000; ++i) {
        const vec3d p(3.0 + random.below(64) / 32.0, 3.0 + random.below(64) / 32.0, 4.0 + random.real());
        const vec3d normal = glm::normalize(vec3d(p.y, p.x, 0.0));
        const vec3d any(random.real() - 0.5, random.real() - 0.5, random.real() - 0.5);
        const vec3d across = any - glm::dot(any, normal) * normal;
        if (std::abs(across.x) < 0.1 * glm::length(across))
            continue; // nearly along the surface's straight line
        const vec3d step = 2.0 * glm::normalize(across);
        const auto hits = hitsOf(scene, float(p.x * p.y), between(p - step, p + 0.9 * step));
        ASSERT_EQ(hits.size(), 1u) << i;
        EXPECT_NEAR(hits[0].t, 2.0, 1e-5);
    }
}

TEST(ReferenceSurfaces, AreHitOnceWhereTheFieldHasAnEdge)
{
    const ReferenceScene scene = cubeOf([](const vec3d& p) { return std::abs(p.x - 4.5); });
    for (const ReferenceRay& ray :
         {between({1.0, 4.5, 4.5}, {7.0, 4.5, 4.5}), between({7.1, 2.2, 3.0}, {0.9, 5.1, 5.9})}) {
        const auto hits = hitsOf(scene, 0.0f, ray);
        ASSERT_EQ(hits.size(), 1u);
        EXPECT_NEAR(ray.org.x + hits[0].t * ray.dir.x, 4.5, 1e-12);
        EXPECT_EQ(hitsOf(scene, 0.001f, ray).size(), 2u);
        EXPECT_EQ(hitsOf(scene, -0.001f, ray).size(), 0u);
    }
}

TEST(ReferenceSurfaces, OfAPlateauAreHitOnceAtItsStart)
{
    const ReferenceScene scene = cubeOf([](const vec3d& p) { return std::clamp(p.x, 2.5, 5.5); });
    const auto hits = hitsOf(scene, 5.5f, between({1.0, 4.1, 4.1}, {7.0, 4.1, 4.1}));
    ASSERT_EQ(hits.size(), 1u);
    EXPECT_NEAR(hits[0].t, 4.5, 1e-12);
    EXPECT_EQ(hitsOf(scene, 5.5f, between({6.0, 1.0, 1.0}, {7.0, 7.0, 7.0})).size(), 1u);
}

TEST(ReferenceSurfaces, AreHitOnceWhereLevelsMeet)
{
    // As in GivesTheLogarithmsWhereLevelsMeet with a = 0, b = 5: B is 5 (2 x - 3) / x up to 2.5, where the fine cells'
    // D becomes 1, then 10 / (5 - x) up to 3, where the coarse cell's support ends, and 0 before and 5 behind.
    const ReferenceScene scene(oracles::modelOf({{vec3i(0), vec3i(1), 1, 0}, {vec3i(2, 0, 0), vec3i(2), 0, 0}},
                                                [](const vec3d& p) { return p.x < 2.0 ? 0.0 : 5.0; }));
    const ReferenceRay ray = between({-2.0, 1.0, 1.0}, {6.0, 1.0, 1.0});
    for (const auto& [value, x] :
         {std::pair{4.0f, 2.5}, {2.5f, 2.0}, {4.5f, 5.0 - 10.0 / 4.5}, {0.0f, -1.0}, {5.0f, 3.0}}) {
        const auto hits = hitsOf(scene, value, ray);
        ASSERT_EQ(hits.size(), 1u) << value;
        EXPECT_NEAR(hits[0].t - 2.0, x, 1e-12) << value;
    }
}

TEST(ReferenceSurfaces, AreNotSeenInHolesNorAcrossThem)
{
    // Two supports that touch in x = 3, where nothing is left of either: B jumps from 1 to 2 there.
    const ReferenceScene scene(oracles::modelOf({{vec3i(0), vec3i(2), 0, 0}, {vec3i(3, 0, 0), vec3i(2), 0, 0}},
                                                [](const vec3d& p) { return p.x < 2.5 ? 1.0 : 2.0; }));
    EXPECT_EQ(hitsOf(scene, 1.5f, between({-1, 1, 1}, {7, 1, 1})).size(), 0u);
    EXPECT_EQ(hitsOf(scene, 0.0f, between({-1, 1, 1}, {7, 1, 1})).size(), 0u); // N = 0 at the faces is no B = 0
    EXPECT_EQ(hitsOf(scene, 0.0f, between({-2, -3, -2.5}, {7, 6, 5})).size(), 0u);
}

/// How often the definition changes sides along the ray, looked at every 1/200 voxel; holes reset it.
int crossings(const oracles::ReferenceReconstruction& twin, float value, const ReferenceRay& ray)
{
    int count = 0, last = 0;
    for (double t = 0.0025; t < ray.tFar; t += 0.005) {
        const auto sample = twin.atVoxel(ray.org + t * ray.dir);
        const int side = !sample.valid ? 0 : sample.value > value ? 1 : -1;
        count += last * side < 0;
        last = side;
    }
    return count;
}

TEST(ReferenceSurfaces, AreThoseOfTheDefinitionOnAnyLayout)
{
    int found = 0, stepped = 0;
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const ReferenceScene scene(randomModel(seed));
        const oracles::ReferenceReconstruction twin(scene.model, scene.model.fields[0]);
        oracles::Random random(seed);
        for (int i = 0; i < 20; ++i) {
            const ReferenceRay ray = randomRay(scene.regions, random);
            const auto hits = hitsOf(scene, 0.125f, ray);
            double last = -1.0;
            for (const ReferenceHit& hit : hits) {
                const auto sample = twin.atVoxel(ray.org + hit.t * ray.dir);
                EXPECT_NEAR(sample.value, 0.125, 1e-11);
                if (sample.kinkDistance > 1e-9) {
                    EXPECT_NEAR(glm::length(sample.gradient - hit.gradient), 0.0, 1e-8);
                }
                EXPECT_GT(hit.t, last);
                last = hit.t;
            }
            const int coarse = crossings(twin, 0.125f, ray);
            EXPECT_GE(int(hits.size()), coarse) << "seed " << seed << " ray " << i;
            found += int(hits.size());
            stepped += coarse;
        }
    }
    EXPECT_GT(stepped, 500);
    EXPECT_LE(found - stepped, stepped / 50); // what steps of 1/200 cannot see are nearly tangent rays
}

TEST(ReferenceSurfaces, AreTheSameFromBothSides)
{
    const std::vector<IsoSurface> surfaces{{0.125f}, {0.13f}, {-0.5f}};
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        const ReferenceScene scene(randomModel(seed));
        const ReferenceIntegrator integrator = scene.with(extinctionOver(0.0f, 1.0f, {{0.0f, 0.0f}}), surfaces);
        oracles::Random random(seed);
        for (int i = 0; i < 200; ++i) {
            ReferenceRay ray = randomRay(scene.regions, random);
            if (i % 2)
                ray = snapped(ray, i / 2 % 3);
            const ReferenceRay back = backwards(ray);
            const auto there = integrator.surfaceHits(ray), returned = integrator.surfaceHits(back);
            ASSERT_EQ(there.size(), returned.size()) << "seed " << seed << " ray " << i;
            for (std::size_t k = 0; k < there.size(); ++k) {
                const ReferenceHit &a = there[k], &b = returned[there.size() - 1 - k];
                EXPECT_EQ(a.surface, b.surface);
                EXPECT_NEAR(a.t, ray.tFar - b.t, 1e-8);
            }
        }
    }
}

TEST(ReferenceSurfaces, AreCompositedInOrderWithTheVolume)
{
    const ReferenceScene scene = cubeOf(rampValue);
    const std::vector<IsoSurface> surfaces{{5.0f, {0, 0, 1}, 1.0f}, {3.0f, {0, 1, 0}, 0.25f}, {6.0f, {1, 1, 1}, 1.0f}};
    TransferFunction tf = extinctionOver(0.0f, 8.0f, {{0.0f, 0.5f}});
    tf.colors = {{0.0f, {1, 0, 0}}};
    const ReferenceIntegrator integrator = scene.with(tf, surfaces);
    const ReferenceRay ray = between({1, 4.1, 4.1}, {7, 4.1, 4.1});
    const double through = std::exp(-1.0); // of two voxels
    const ReferenceResult r = integrator.integrate(ray);
    EXPECT_NEAR(r.color.x, (1.0 - through) + through * 0.75 * (1.0 - through), 1e-13);
    EXPECT_NEAR(r.color.y, through * 0.25, 1e-13);
    EXPECT_NEAR(r.color.z, through * 0.75 * through, 1e-13);
    EXPECT_EQ(r.transmittance, 0.0);
    const double volume = 2.0 - 4.0 * through; // the integral of t / 2 e^(-t/2) from 0 to 2
    const double second = volume + 2.0 * (1.0 - through);
    EXPECT_NEAR(r.weightedDistance, volume + through * (0.25 * 2.0 + 0.75 * (second + through * 4.0)), 1e-12);

    const auto hits = integrator.surfaceHits(ray);
    ASSERT_EQ(hits.size(), 3u); // also behind what is opaque
    EXPECT_EQ(hits[0].surface, 1);
    EXPECT_EQ(hits[1].surface, 0);
    EXPECT_EQ(hits[2].surface, 2);
}

TEST(ReferenceSurfaces, AreShadedByTheAngle)
{
    const ReferenceScene scene = cubeOf(rampValue);
    const std::vector<IsoSurface> surfaces{{5.0f, vec3f(0.5f), 1.0f}};
    const ReferenceIntegrator integrator(scene.regions, scene.field, extinctionOver(0.0f, 8.0f, {{0.0f, 0.0f}}),
                                         surfaces, plainMetric, true);
    const ReferenceRay ray = between({1.0, 2.0, 2.0}, {7.0, 5.0, 4.0});
    EXPECT_NEAR(integrator.integrate(ray).color.y, 0.5 * ray.dir.x, 1e-12);
}

} // namespace
} // namespace brickwall
