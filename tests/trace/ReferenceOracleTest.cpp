// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/trace/ReferenceScene.h"

#include "brickwall/tests/oracles/ReferenceReconstruction.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include <glm/gtc/matrix_transform.hpp>

// The reference integrator against the definition of the reconstruction, summed up by brute force.
namespace brickwall {
namespace {

/// The same integral by many midpoints, between all planes at multiples of half a voxel: all centres and faces of
/// supports lie on these.
class BruteForce
{
public:
    BruteForce(const Model& model, const TransferFunction& tf, bool headlight)
        : model_(model), tf_(tf), headlight_(headlight), twin_(model, model.fields[0])
    {
    }

    ReferenceResult integrate(const ReferenceRay& ray) const
    {
        ReferenceResult result{vec3d(0.0), 1.0, 0.0};
        const std::vector<double> cuts = cutsOf(ray);
        for (std::size_t i = 1; i < cuts.size(); ++i) {
            const int steps = 4 + int((cuts[i] - cuts[i - 1]) * 2000.0);
            const double h = (cuts[i] - cuts[i - 1]) / steps;
            for (int k = 0; k < steps; ++k)
                addStep(ray, cuts[i - 1] + (k + 0.5) * h, h, result);
        }
        return result;
    }

private:
    static std::vector<double> cutsOf(const ReferenceRay& ray)
    {
        std::vector<double> cuts{ray.tNear, ray.tFar};
        for (int axis = 0; axis < 3; ++axis) {
            const double a = ray.org[axis], b = ray.org[axis] + ray.tFar * ray.dir[axis];
            for (double k = std::ceil(2.0 * std::min(a, b)); k <= 2.0 * std::max(a, b); ++k)
                if (ray.dir[axis] != 0.0)
                    cuts.push_back(std::clamp((0.5 * k - ray.org[axis]) / ray.dir[axis], ray.tNear, ray.tFar));
        }
        std::sort(cuts.begin(), cuts.end());
        return cuts;
    }

    void addStep(const ReferenceRay& ray, double t, double h, ReferenceResult& result) const
    {
        const vec3d voxel = ray.org + t * ray.dir;
        const auto sample = headlight_ ? twin_.at(transformPoint(model_.worldFromVoxel, voxel)) : twin_.atVoxel(voxel);
        if (!sample.valid)
            return;
        double shade = 1.0;
        if (headlight_ && glm::length(sample.gradient) > 1e-9)
            shade = std::abs(glm::dot(glm::normalize(sample.gradient),
                                      glm::normalize(transformVector(model_.worldFromVoxel, ray.dir))));
        const double absorbed = -std::expm1(-extinctionAt(tf_, sample.value) * h);
        result.color += result.transmittance * absorbed * shade * colorAt(tf_, sample.value);
        result.weightedDistance += result.transmittance * absorbed * t;
        result.transmittance *= 1.0 - absorbed;
    }

    const Model& model_;
    const TransferFunction& tf_;
    bool headlight_;
    oracles::ReferenceReconstruction twin_;
};

TransferFunction bumpy(TransferFunction::Kind kind)
{
    TransferFunction tf;
    tf.range = {-0.9f, 0.8f};
    tf.colors = {{0.0f, {1.0f, 0.0f, 0.2f}}, {0.3f, {0.0f, 1.0f, 0.0f}}, {1.0f, {0.3f, 0.0f, 1.0f}}};
    tf.opacity = {{0.0f, 0.0f}, {0.2f, 0.0f}, {0.4f, 0.5f}, {0.6f, 0.1f}, {1.0f, 0.0f}};
    tf.kind = kind;
    return tf;
}

void expectNear(const ReferenceResult& a, const ReferenceResult& b, double tolerance)
{
    EXPECT_NEAR(a.transmittance, b.transmittance, tolerance);
    for (int c = 0; c < 3; ++c)
        EXPECT_NEAR(a.color[c], b.color[c], tolerance);
    EXPECT_NEAR(a.weightedDistance, b.weightedDistance, 30.0 * tolerance);
}

TEST(ReferenceOracle, IntegratesTheDefinitionOnAnyLayout)
{
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        const ReferenceScene scene(randomModel(seed));
        const TransferFunction tf =
            bumpy(seed % 2 ? TransferFunction::Kind::opacity : TransferFunction::Kind::extinction);
        const BruteForce bruteForce(scene.model, tf, false);
        const ReferenceIntegrator integrator = scene.with(tf);
        oracles::Random random(seed);
        for (int i = 0; i < 3; ++i) {
            const ReferenceRay ray = randomRay(scene.regions, random);
            SCOPED_TRACE(testing::Message() << "seed " << seed << " ray " << i);
            expectNear(integrator.integrate(ray), bruteForce.integrate(ray), 1e-7);
        }
    }
}

TEST(ReferenceOracle, ShadesByTheWorldsGradient)
{
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
        Model model = randomModel(seed);
        // Stretched after the rotation: in the world, cells are sheared.
        model.worldFromVoxel = glm::rotate(
            glm::scale(glm::translate(mat4d(1.0), vec3d(5, 6, -7)), vec3d(0.5, 2.0, 1.25)), 0.7, vec3d(1, 2, 3));
        const ReferenceScene scene(std::move(model));
        const TransferFunction tf = bumpy(TransferFunction::Kind::extinction);
        const double width = stretchOf(scene.model.worldFromVoxel);
        const glm::dmat3 inverse = width * glm::inverse(glm::dmat3(scene.model.worldFromVoxel));
        const glm::dmat3 g = inverse * glm::transpose(inverse);
        const ReferenceIntegrator integrator(scene.regions, scene.field, tf, {},
                                             {g[0][0], g[1][1], g[2][2], g[0][1], g[0][2], g[1][2]}, true);
        const BruteForce bruteForce(scene.model, tf, true);
        oracles::Random random(seed);
        for (int i = 0; i < 2; ++i) {
            ReferenceRay ray = randomRay(scene.regions, random);
            ray.worldStretch = glm::length(transformVector(scene.model.worldFromVoxel, ray.dir)) / width;
            expectNear(integrator.integrate(ray), bruteForce.integrate(ray), 5e-7);
        }
    }
}

TEST(ReferenceOracle, PutsOneRayTogetherFromItsParts)
{
    const ReferenceScene scene(randomModel(4));
    const ReferenceIntegrator integrator = scene.with(bumpy(TransferFunction::Kind::extinction));
    oracles::Random random(4);
    for (int i = 0; i < 20; ++i) {
        const ReferenceRay whole = randomRay(scene.regions, random);
        ReferenceRay a = whole, b = whole;
        a.tFar = b.tNear = random.real() * whole.tFar;
        const ReferenceResult ra = integrator.integrate(a), rb = integrator.integrate(b);
        expectNear({ra.color + ra.transmittance * rb.color, ra.transmittance * rb.transmittance,
                    ra.weightedDistance + ra.transmittance * rb.weightedDistance},
                   integrator.integrate(whole), 1e-10);
    }
}

/// The largest difference of transmittance between rays and the same rays backwards.
double differenceBackwards(const ReferenceScene& scene, const TransferFunction& tf)
{
    const ReferenceIntegrator integrator = scene.with(tf);
    oracles::Random random(12);
    double largest = 0.0;
    for (int i = 0; i < 40; ++i) {
        ReferenceRay ray = randomRay(scene.regions, random);
        if (i % 2)
            ray = snapped(ray, i / 2 % 3);
        const ReferenceRay back = backwards(ray);
        const double there = integrator.integrate(ray).transmittance;
        largest = std::max(largest, std::abs(there - integrator.integrate(back).transmittance));
    }
    return largest;
}

// Once missed a crossing of the spike: just before a ray left the last support, where N and D vanish together, their
// rounding made up an extremum of B.
TEST(ReferenceOracle, SeesNarrowSpikesFromBothSides)
{
    TransferFunction tf = bumpy(TransferFunction::Kind::opacity);
    tf.opacity = {{0.5f, 0.0f}, {0.5f + 1e-7f, 1.0f}, {0.5f + 2e-7f, 0.0f}};
    for (std::uint64_t seed = 11; seed <= 16; ++seed)
        EXPECT_LT(differenceBackwards(ReferenceScene(randomModel(seed)), tf), 1e-12) << seed;
}

// Between cells of 0 and 1, B is 0.5 along many an axis; once its last bit chose the side of a step there.
TEST(ReferenceOracle, SeesTheSameSideOfAStepThatTheFieldIsOn)
{
    TransferFunction tf = bumpy(TransferFunction::Kind::opacity);
    tf.range = {0.0f, 1.0f};
    tf.opacity = {{0.0f, 0.0f}, {0.5f, 0.0f}, {0.5f, 0.3f}, {1.0f, 1.0f}};
    for (std::uint64_t seed = 11; seed <= 16; ++seed) {
        Model model = randomModel(seed);
        for (float& v : model.fields[0].values)
            v = v > 0.0f ? 1.0f : 0.0f;
        model.fields[0].range = {0.0f, 1.0f};
        EXPECT_LT(differenceBackwards(ReferenceScene(std::move(model)), tf), 1e-12) << seed;
    }
}

} // namespace
} // namespace brickwall
