// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/tests/trace/ReferenceScene.h"

#include "brickwall/tests/oracles/ReferenceIntegral.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

// The reference integrator against closed forms, to nearly all digits.
namespace brickwall {
namespace {

/// v = x on 8 x 8 x 8 finest cells: exact between the outermost centres, 0.5 to 7.5.
Model rampModel()
{
    return oracles::modelOf(oracles::oneLevelBricks(vec3i(0), vec3i(8), vec3i(3), 0),
                            [](const vec3d& p) { return p.x; });
}

TEST(ReferenceIntegrator, GivesTheOpacityOfAConstantBox)
{
    for (int level : {0, 2}) {
        const Model model = oracles::modelOf(oracles::oneLevelBricks(vec3i(-3, 1, 2), vec3i(4, 5, 3), vec3i(2), level),
                                             [](const vec3d&) { return 0.25; });
        const ReferenceScene scene(model);
        TransferFunction tf = extinctionOver(0.0f, 1.0f, {{0.0f, 0.5f}});
        tf.colors = {{0.0f, {0.25f, 0.5f, 1.0f}}};
        const ReferenceIntegrator integrator = scene.with(tf);
        oracles::Random random(1);
        for (int i = 0; i < 20; ++i) {
            const ReferenceRay ray = randomRay(scene.regions, random);
            const double opacity = oracles::constantOpacity(0.5, ray.tFar);
            const ReferenceResult r = integrator.integrate(ray);
            EXPECT_NEAR(r.transmittance, 1.0 - opacity, 1e-13);
            EXPECT_NEAR(r.color.x, 0.25 * opacity, 1e-13);
            EXPECT_NEAR(r.color.y, 0.5 * opacity, 1e-13);
            EXPECT_NEAR(r.weightedDistance, 2.0 * opacity - ray.tFar * (1.0 - opacity), 1e-11);
        }
    }
}

TEST(ReferenceIntegrator, GivesTheOpacityOfAConstantBoxAtTheEndsOfTheRangeAndNextToTheFaces)
{
    const Model model =
        oracles::modelOf(oracles::oneLevelBricks(vec3i(0), vec3i(4), vec3i(3), 1), [](const vec3d&) { return 0.25; });
    const ReferenceScene scene(model); // supports from -1 to 9
    for (const Range range : {Range{0.0f, 0.25f}, Range{0.25f, 1.0f}}) {
        const ReferenceIntegrator integrator = scene.with(extinctionOver(range.lo, range.hi, {{0.0f, 0.5f}}));
        for (int axis = 0; axis < 3; ++axis)
            for (double beside : {-0.999999, 3.0, 8.999999}) {
                vec3d a(beside), b(beside);
                a[axis] = -7.0;
                b[axis] = 99.0;
                EXPECT_NEAR(std::log(integrator.integrate(between(a, b)).transmittance), -5.0, 1e-12);
                EXPECT_NEAR(std::log(integrator.integrate(between(b, a)).transmittance), -5.0, 1e-12);
            }
    }
}

TEST(ReferenceIntegrator, GivesTheQuadraticDepthOfALinearExtinction)
{
    const ReferenceScene scene(rampModel());
    const ReferenceIntegrator integrator = scene.with(extinctionOver(0.0f, 8.0f, {{0.0f, 0.0f}, {1.0f, 2.0f}}));
    for (const ReferenceRay& ray :
         {between({0.5, 3.3, 3.3}, {7.5, 3.3, 3.3}), between({7.0, 1.0, 2.0}, {1.0, 6.0, 4.0})}) {
        const double x0 = ray.org.x, x1 = ray.org.x + ray.dir.x * ray.tFar;
        const double depth = 0.25 * 0.5 * (x0 + x1) * ray.tFar;
        const ReferenceResult r = integrator.integrate(ray);
        EXPECT_NEAR(std::log(r.transmittance), -depth, 1e-12);
        EXPECT_NEAR(r.color.x, -std::expm1(-depth), 1e-13);
    }
}

/// The integral over u in [u0, u1] of u K u exp(-K (u^2 - u0^2) / 2).
double linearColorTimesLinearExtinction(double K, double u0, double u1)
{
    const auto through = [&](double u) { return std::exp(-0.5 * K * (u * u - u0 * u0)); };
    const double root = std::sqrt(0.5 * K);
    const double gauss = std::sqrt(std::numbers::pi) / (2.0 * root) * (std::erf(root * u1) - std::erf(root * u0));
    return u0 - u1 * through(u1) + std::exp(0.5 * K * u0 * u0) * gauss;
}

TEST(ReferenceIntegrator, GivesTheErrorFunctionOfALinearColour)
{
    const ReferenceScene scene(rampModel());
    TransferFunction tf = extinctionOver(0.0f, 8.0f, {{0.0f, 0.0f}, {1.0f, 6.0f}});
    tf.colors = {{0.0f, vec3f(0.0f)}, {1.0f, {1.0f, 0.5f, 0.0f}}};
    const ReferenceResult r = scene.with(tf).integrate(between({1.0, 3.0, 4.2}, {7.0, 3.0, 4.2}));
    // u = x / 8, sigma dx = 6 u 8 du
    const double expected = linearColorTimesLinearExtinction(48.0, 1.0 / 8.0, 7.0 / 8.0);
    EXPECT_NEAR(r.color.x, expected, 1e-12);
    EXPECT_NEAR(r.color.y, 0.5 * expected, 1e-12);
    EXPECT_EQ(r.color.z, 0.0);
}

TEST(ReferenceIntegrator, SeesAKnotInsideAPiece)
{
    // A tent of half width 0.1 around 3.1, which no cell centre is near.
    const ReferenceScene scene(rampModel());
    const float t = 3.1f / 8.0f, w = 0.1f / 8.0f;
    const TransferFunction tf = extinctionOver(0.0f, 8.0f, {{t - w, 0.0f}, {t, 20.0f}, {t + w, 0.0f}});
    const double depth =
        0.5 * 20.0 * 8.0 * (double(tf.opacity[2].t) - tf.opacity[0].t); // of the tent, seen along x at speed 1
    const ReferenceIntegrator integrator = scene.with(tf);
    EXPECT_NEAR(std::log(integrator.integrate(between({1, 4.1, 4.1}, {7, 4.1, 4.1})).transmittance), -depth, 1e-11);
    const ReferenceRay oblique = between({7.0, 1.0, 1.0}, {1.0, 6.0, 5.0});
    EXPECT_NEAR(std::log(integrator.integrate(oblique).transmittance), -depth / -oblique.dir.x, 1e-11);
}

TEST(ReferenceIntegrator, SeesASpikeOfAMillionthOfTheRange)
{
    const ReferenceScene scene(rampModel());
    const float t = 0.40625f, w = 0x1p-20f;
    const TransferFunction tf = extinctionOver(0.0f, 8.0f, {{t - w, 0.0f}, {t, 1e5f}, {t + w, 0.0f}});
    const ReferenceResult r = scene.with(tf).integrate(between({1, 4.1, 4.1}, {7, 4.1, 4.1}));
    EXPECT_NEAR(std::log(r.transmittance), -1e5 * 8.0 * 0x1p-20, 1e-8);
    EXPECT_NEAR(r.weightedDistance / (1.0 - r.transmittance), 2.25, 1e-5);
}

TEST(ReferenceIntegrator, SeesAStepOfTheTransferFunctionInsideAPiece)
{
    const ReferenceScene scene(rampModel());
    TransferFunction tf = extinctionOver(0.0f, 8.0f, {{0.0f, 0.2f}, {0.4f, 0.2f}, {0.4f, 1.5f}, {1.0f, 1.5f}});
    tf.colors = {{0.0f, {1, 0, 0}}, {0.4f, {1, 0, 0}}, {0.4f, {0, 1, 0}}, {1.0f, {0, 1, 0}}};
    const double step = 8.0 * double(0.4f);
    const double before = std::exp(-double(0.2f) * (step - 1.0)), behind = std::exp(-1.5 * (7.0 - step));
    const ReferenceResult r = scene.with(tf).integrate(between({1, 4.1, 4.1}, {7, 4.1, 4.1}));
    EXPECT_NEAR(r.color.x, 1.0 - before, 1e-13);
    EXPECT_NEAR(r.color.y, before * (1.0 - behind), 1e-13);
    EXPECT_NEAR(r.transmittance, before * behind, 1e-13);
}

/// One cell of level 1 at x in [0, 2] with value a beside 2 x 2 x 2 finest cells at x in [2, 4] with value b.
Model twoLevels(double a, double b)
{
    return oracles::modelOf({{vec3i(0), vec3i(1), 1, 0}, {vec3i(2, 0, 0), vec3i(2), 0, 0}},
                            [=](const vec3d& p) { return p.x < 2.0 ? a : b; });
}

TEST(ReferenceIntegrator, GivesTheLogarithmsWhereLevelsMeet)
{
    // On the axis y = z = 1: D of the coarse cell is 1 - |x - 1| / 2, of the fine ones a ramp from 1.5 to 2.5 and 1
    // up to 3.5, hence B = (a (3 - x) + b (2 x - 3)) / x, then (a (3 - x) + 2 b) / (5 - x).
    const double a = 0.25, b = 2.0, k = 0.5;
    const ReferenceScene scene(twoLevels(a, b));
    const ReferenceIntegrator integrator = scene.with(extinctionOver(0.0f, 4.0f, {{0.0f, 0.0f}, {1.0f, 2.0f}}));
    const double coarse = 2.5 * a, fine = 1.5 * b;
    const double first = 3.0 * (a - b) * std::log(2.5 / 1.5) + (2.0 * b - a);
    const double second = 0.5 * a + 2.0 * (b - a) * std::log(2.5 / 2.0);
    const auto depth = [&](double x0, double x1) {
        return -std::log(integrator.integrate(between({x0, 1.0, 1.0}, {x1, 1.0, 1.0})).transmittance);
    };
    EXPECT_NEAR(depth(-1.0, 1.5), k * coarse, 1e-12);
    EXPECT_NEAR(depth(1.5, 2.5), k * first, 1e-12);
    EXPECT_NEAR(depth(2.5, 3.0), k * second, 1e-12);
    EXPECT_NEAR(depth(3.0, 4.5), k * fine, 1e-12);
    EXPECT_NEAR(depth(-5.0, 9.0), k * (coarse + first + second + fine), 1e-12);
    EXPECT_NEAR(depth(9.0, -5.0), k * (coarse + first + second + fine), 1e-12);
}

TEST(ReferenceIntegrator, EmitsWithoutAbsorbingWhereThereIsNextToNothing)
{
    const ReferenceScene scene(rampModel());
    TransferFunction tf = extinctionOver(0.0f, 8.0f, {{0.0f, 1e-24f}});
    tf.colors = {{0.0f, vec3f(0.0f)}, {1.0f, vec3f(1.0f)}};
    const ReferenceResult r = scene.with(tf).integrate(between({1, 4.1, 4.1}, {7, 4.1, 4.1}));
    EXPECT_EQ(r.transmittance, 1.0);
    EXPECT_NEAR(r.color.x / double(1e-24f), 3.0, 1e-11); // the integral of x / 8
}

TEST(ReferenceIntegrator, KeepsTheCapOfFullOpacity)
{
    const ReferenceScene scene(rampModel());
    TransferFunction tf = extinctionOver(0.0f, 8.0f, {{0.0f, 0.0f}, {0.5f, 1.0f}, {1.0f, 1.0f}});
    tf.kind = TransferFunction::Kind::opacity;
    const ReferenceIntegrator integrator = scene.with(tf);
    const double sigma = -std::log1p(-double(TransferFunction::opacityCap));
    const ReferenceResult inside = integrator.integrate(between({5, 4.1, 4.1}, {5.5, 4.1, 4.1}));
    EXPECT_NEAR(inside.transmittance, std::exp(-0.5 * sigma), 1e-14);
    // The ramp a = x / 4 up to the cap: the integral of -ln(1 - x/4) is 4 ((1 - a) ln(1 - a) + a).
    const double a = double(TransferFunction::opacityCap);
    const auto antiderivative = [](double q) { return 4.0 * ((1.0 - q) * std::log1p(-q) + q); };
    const double ramp = antiderivative(a) - antiderivative(0.5), capped = sigma * (4.2 - 4.0 * a);
    const ReferenceResult across = integrator.integrate(between({2, 4.1, 4.1}, {4.2, 4.1, 4.1}));
    EXPECT_NEAR(std::log(across.transmittance), -ramp - capped, 1e-10);
    EXPECT_NEAR(across.color.x, 1.0 - across.transmittance, 1e-12);
}

TEST(ReferenceIntegrator, EndsAtTheFrontOfWhatIsOpaque)
{
    const ReferenceScene scene(rampModel());
    TransferFunction tf = extinctionOver(0.0f, 8.0f, {{0.0f, 0.0f}, {0.4f, 0.0f}, {0.4f, 1e24f}, {1.0f, 1e24f}});
    tf.colors = {{0.4f, {1, 0, 0}}, {0.41f, {0, 1, 0}}};
    const ReferenceResult r = scene.with(tf).integrate(between({1, 4.1, 4.1}, {7, 4.1, 4.1}));
    EXPECT_EQ(r.transmittance, 0.0);
    EXPECT_NEAR(r.color.x, 1.0, 1e-10);
    EXPECT_NEAR(r.color.y, 0.0, 1e-10);
    EXPECT_NEAR(r.weightedDistance, 8.0 * double(0.4f) - 1.0, 1e-10);
}

// Once the gradient was all rounding there, of N and D that vanish together in the support's face.
TEST(ReferenceIntegrator, ShadesWhatIsOpaqueFromTheVeryFace)
{
    const ReferenceScene scene(
        oracles::modelOf(oracles::oneLevelBricks(vec3i(0), vec3i(8), vec3i(3), 0), [](const vec3d& p) { return p.y; }));
    const ReferenceIntegrator integrator(scene.regions, scene.field, extinctionOver(0.0f, 8.0f, {{0.0f, 1e24f}}), {},
                                         plainMetric, true);
    const ReferenceRay ray = between({-1.0, 2.0, 3.0}, {7.0, 6.0, 4.0});
    EXPECT_NEAR(integrator.integrate(ray).color.x, ray.dir.y, 1e-12);
}

TEST(ReferenceIntegrator, FollowsALogarithmicScale)
{
    const ReferenceScene scene(rampModel());
    TransferFunction tf = extinctionOver(0.5f, 8.0f, {{0.0f, 0.0f}, {1.0f, 3.0f}});
    tf.scale = Scale::logarithmic;
    const auto antiderivative = [](double x) { return x * std::log(x / 0.5) - x; };
    const double depth = 3.0 / std::log(16.0) * (antiderivative(7.0) - antiderivative(1.0));
    EXPECT_NEAR(std::log(scene.with(tf).integrate(between({1, 4.1, 4.1}, {7, 4.1, 4.1})).transmittance), -depth, 1e-11);
    // A knot at the geometric middle, 2: from there on nothing.
    tf.opacity = {{0.0f, 0.0f}, {0.5f, 1.5f}, {0.5f, 0.0f}};
    const double half = 3.0 / std::log(16.0) * (antiderivative(2.0) - antiderivative(1.0));
    EXPECT_NEAR(std::log(scene.with(tf).integrate(between({1, 4.1, 4.1}, {7, 4.1, 4.1})).transmittance), -half, 1e-11);
}

TEST(ReferenceIntegrator, IsEmptyInHoles)
{
    const Model model = oracles::modelOf({{vec3i(0), vec3i(2), 0, 0}, {vec3i(8, 0, 0), vec3i(2), 0, 0}},
                                         [](const vec3d&) { return 1.0; });
    const ReferenceScene scene(model);
    const ReferenceIntegrator integrator = scene.with(extinctionOver(0.0f, 2.0f, {{0.0f, 1.0f}}));
    EXPECT_NEAR(std::log(integrator.integrate(between({-9, 1, 1}, {19, 1, 1})).transmittance), -6.0, 1e-12);
    EXPECT_EQ(integrator.integrate(between({2.5, 1, 1}, {7.5, 1, 1})).transmittance, 1.0);
    EXPECT_EQ(integrator.integrate(between({2.5, -9, 1}, {2.5, 9, 1})).transmittance, 1.0); // in the support's face
}

TEST(ReferenceIntegrator, SeesTheSameInAPlaneThroughCentresAndBesideIt)
{
    const ReferenceScene scene(randomModel(5));
    const ReferenceIntegrator integrator =
        scene.with(extinctionOver(-1.0f, 1.0f, {{0.0f, 0.0f}, {0.5f, 0.4f}, {1.0f, 0.0f}}));
    for (const vec3d& a : {vec3d(-3, 4.5, 6.5), vec3d(-3, 8.0, 7.3), vec3d(-3, 8.0, 8.0), vec3d(-3, 5.0, 11.0)}) {
        const ReferenceResult on = integrator.integrate(between(a, a + vec3d(40, 0, 0)));
        const vec3d shift(0.0, 1e-11, -1e-11);
        const ReferenceResult beside = integrator.integrate(between(a + shift, a + vec3d(40, 0, 0) + shift));
        EXPECT_LT(on.transmittance, 0.9);
        EXPECT_NEAR(on.transmittance, beside.transmittance, 1e-9);
        EXPECT_NEAR(on.weightedDistance, beside.weightedDistance, 1e-8);
    }
}

TEST(ReferenceIntegrator, SeesTheSameFarFromTheOrigin)
{
    const vec3i far(10'000'000, -10'000'000, 9'999'996);
    std::vector<Brick> bricks = oracles::nestedLevels(2, 4, 4), moved = bricks;
    for (Brick& b : moved)
        b.lower += far;
    const auto value = [](const vec3d& p) { return std::sin(0.7 * p.x) + std::cos(p.y * 0.9 + 0.3 * p.z); };
    const ReferenceScene here(oracles::modelOf(bricks, value));
    const ReferenceScene there(oracles::modelOf(moved, [&](const vec3d& p) { return value(p - vec3d(far)); }));
    const TransferFunction tf = extinctionOver(-2.0f, 2.0f, {{0.4f, 0.0f}, {0.5f, 1.0f}, {0.6f, 0.0f}});
    oracles::Random random(3);
    for (int i = 0; i < 5; ++i) {
        ReferenceRay ray = randomRay(here.regions, random);
        const ReferenceResult a = here.with(tf).integrate(ray);
        ray.org += vec3d(far);
        const ReferenceResult b = there.with(tf).integrate(ray);
        EXPECT_NEAR(a.color.x, b.color.x, 1e-7);
        EXPECT_NEAR(a.weightedDistance, b.weightedDistance, 1e-5);
    }
}

TEST(ReferenceIntegrator, TakesTheRaysOfATileAsTheyAre)
{
    const ReferenceScene scene(randomModel(2));
    const ReferenceIntegrator integrator = scene.with(extinctionOver(-1.0f, 1.0f, {{0.0f, 0.0f}, {1.0f, 0.3f}}));
    const vec3i origin(7, -4, 3);
    RayTile tile;
    tile.count = 3;
    oracles::Random random(8);
    std::array<ReferenceRay, 3> rays;
    for (int i = 0; i < 2; ++i) {
        const ReferenceRay ray = rays[i] = randomRay(scene.regions, random);
        for (int axis = 0; axis < 3; ++axis) {
            tile.org[axis][i] = float(ray.org[axis] - 0.5 * origin[axis]);
            tile.dir[axis][i] = float(ray.dir[axis]);
            rays[i].org[axis] = tile.org[axis][i] + 0.5 * origin[axis];
            rays[i].dir[axis] = tile.dir[axis][i];
        }
        rays[i].tFar = tile.tFar[i] = float(ray.tFar);
        tile.worldStretch[i] = 1.0f;
    }
    TileResult result;
    result.transmittance[1] = 0.5f;
    result.color[2][1] = 0.25f;
    traceReference(integrator, origin, tile, result);
    const ReferenceResult a = integrator.integrate(rays[0]), b = integrator.integrate(rays[1]);
    EXPECT_FLOAT_EQ(result.color[0][0], float(a.color.x));
    EXPECT_FLOAT_EQ(result.transmittance[0], float(a.transmittance));
    EXPECT_FLOAT_EQ(result.weightedDistance[0], float(a.weightedDistance));
    EXPECT_FLOAT_EQ(result.color[2][1], float(0.25 + 0.5 * b.color.z));
    EXPECT_FLOAT_EQ(result.transmittance[1], float(0.5 * b.transmittance));
    EXPECT_EQ(result.transmittance[2], 1.0f); // it meets nothing
}

} // namespace
} // namespace brickwall
