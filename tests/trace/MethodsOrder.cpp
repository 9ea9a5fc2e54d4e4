// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The orders of convergence of the methods of the literature, where theory gives one and where it is lost (Etiene,
/// Kirby, Silva, "A Study of Discretization Errors in Volume Rendering Integral Approximations", 2013).
#include "brickwall/tests/trace/MethodsScenes.h"

#include <gtest/gtest.h>

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace brickwall {
namespace {

using namespace test;

constexpr int rays = 64;

/// Oblique rays through a cube of 32 cells, all of them where the reconstruction is the cells' interpolant.
RayTile obliqueRays()
{
    std::mt19937 random(17);
    std::uniform_real_distribution<double> across(6.0, 26.0), offset(0.0, 1.0);
    RayTile tile;
    for (int i = 0; i < rays; ++i)
        addRay(tile, {1.0, across(random), across(random)}, {31.0, across(random), across(random)},
               float(offset(random)));
    return tile;
}

struct Method
{
    const char* name;
    TraceMethod trace;
};

constexpr Method fixed{"fixed", traceFixed}, midpoint{"midpoint", traceMidpoint}, bracket{"bracket", traceBracket},
    preintegrated{"preintegrated", tracePreintegrated};

/// The root of the mean squared error of all rays and components, per dt.
std::vector<double> errorsOf(const Method& method, const TracedData& data, const RayTile& tile,
                             const std::vector<vec4d>& exact, const std::vector<float>& steps)
{
    std::vector<double> errors;
    for (const float dt : steps) {
        TileResult result;
        method.trace(data.traced(), {dt, 1.0f, false}, tile, result);
        double sum = 0.0;
        for (int i = 0; i < tile.count; ++i) {
            const vec4d d = resultOf(result, i) - exact[std::size_t(i)];
            sum += glm::dot(d, d);
        }
        errors.push_back(std::sqrt(sum / (4.0 * tile.count)));
    }
    return errors;
}

/// The slope of log(error) over log(dt), by least squares.
double orderOf(const std::vector<float>& steps, const std::vector<double>& errors)
{
    double n = 0, x = 0, y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < steps.size(); ++i) {
        const double a = std::log(double(steps[i])), b = std::log(errors[i]);
        n += 1, x += a, y += b, xx += a * a, xy += a * b;
    }
    return (n * xy - x * y) / (n * xx - x * x);
}

/// Errors over a range of steps, and their order of convergence, which is also printed for the documentation.
struct Measured
{
    std::vector<double> errors;
    double order;

    Measured(const char* scene, const Method& method, const TracedData& data, const RayTile& tile,
             const std::vector<vec4d>& exact, const std::vector<float>& steps)
        : errors(errorsOf(method, data, tile, exact, steps)), order(orderOf(steps, errors))
    {
        testing::Test::RecordProperty(fmt::format("{}, {}", scene, method.name),
                                      fmt::format("order {:.2f}, errors {:.2e}", order, fmt::join(errors, " ")));
    }
};

void expectBetween(double lo, double order, double hi)
{
    EXPECT_GE(order, lo);
    EXPECT_LE(order, hi);
}

/// An affine field in one level.
struct Affine
{
    vec3d slope{0.021, 0.008, -0.005};
    std::vector<Brick> bricks = cubeOfBricks(vec3i(0), 32, 16);
    RayTile tile = obliqueRays();

    double value(const vec3d& p) const { return 0.15 + glm::dot(slope, p); }

    std::vector<vec4d> exact(const TransferFunction& tf) const
    {
        std::vector<vec4d> all;
        for (int i = 0; i < tile.count; ++i)
            all.push_back(integralAlong(
                tf, [&](double t) { return value(pointOn(tile, i, t)); }, tile.tFar[i]));
        return all;
    }
    TracedData traced(const TransferFunction& tf) const
    {
        return TracedData(
            bricks, [this](const vec3d& p) { return value(p); }, tf);
    }
};

/// Any field, of any levels: the exact result is that of very small steps, by pre-integration.
std::vector<vec4d> converged(const TracedData& data, const RayTile& tile)
{
    TileResult result;
    tracePreintegrated(data.traced(), {0.004f, 1.0f, false}, tile, result);
    std::vector<vec4d> all;
    for (int i = 0; i < tile.count; ++i)
        all.push_back(resultOf(result, i));
    return all;
}

TEST(MethodsOrder, IsTheTheoreticalOneWhereAllIsSmooth)
{
    const Affine field;
    const TransferFunction tf = extinctionRamp({0.0f, 1.0f}, 0.0f, 0.12f, false);
    const TracedData data = field.traced(tf);
    const auto exact = field.exact(tf);
    const std::vector<float> steps{4.0f, 2.0f, 1.0f, 0.5f};
    const auto of = [&](const Method& m) { return Measured("smooth", m, data, field.tile, exact, steps).order; };
    expectBetween(0.9, of(fixed), 1.1);
    expectBetween(1.9, of(midpoint), 2.1);
    expectBetween(1.9, of(bracket), 2.1);
    expectBetween(1.75, of(preintegrated), 2.1);
}

TEST(MethodsOrder, SurvivesKnotsOfTheTransferFunction)
{
    const Affine field;
    TransferFunction tf = extinctionRamp({0.0f, 1.0f}, 0.0f, 0.12f, false);
    tf.opacity = {{0.4f, 0.0f}, {0.55f, 0.3f}, {0.7f, 0.0f}};
    const TracedData data = field.traced(tf);
    const auto exact = field.exact(tf);
    const std::vector<float> steps{2.0f, 1.0f, 0.5f, 0.25f};
    const auto of = [&](const Method& m) { return Measured("knots", m, data, field.tile, exact, steps).order; };
    // A Riemann sum over what is 0 at both ends of a ray is the trapezoidal rule: one order more.
    expectBetween(1.8, of(fixed), 2.4);
    expectBetween(1.8, of(midpoint), 2.4);
    expectBetween(1.75, of(bracket), 2.2);
    expectBetween(1.75, of(preintegrated), 2.1);
}

TEST(MethodsOrder, IsLostAtStepsOfTheTransferFunction)
{
    const Affine field;
    TransferFunction tf = extinctionRamp({0.0f, 1.0f}, 0.0f, 0.12f, false);
    tf.opacity = {{0.4f, 0.0f}, {0.4f, 0.3f}, {0.7f, 0.3f}, {0.7f, 0.0f}};
    const TracedData data = field.traced(tf);
    const auto exact = field.exact(tf);
    const std::vector<float> steps{2.0f, 1.0f, 0.5f, 0.25f};
    const auto of = [&](const Method& m) { return Measured("steps", m, data, field.tile, exact, steps); };
    expectBetween(0.85, of(fixed).order, 1.3);
    const Measured middle = of(midpoint), searched = of(bracket);
    expectBetween(0.85, middle.order, 1.3);
    // The search finds an edge to 0.005 cells, whatever the step is: a small error, but one that stays.
    EXPECT_LT(searched.order, 1.2);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        EXPECT_LT(searched.errors[i], 1e-3);
        EXPECT_LT(searched.errors[i], 0.5 * middle.errors[i]);
    }
    expectBetween(1.75, of(preintegrated).order, 2.1);
}

TEST(MethodsOrder, IsNoneAsLongAsStepsAreLongerThanAShell)
{
    const Affine field;
    TransferFunction tf = extinctionRamp({0.0f, 1.0f}, 0.0f, 0.12f, false);
    tf.opacity = {{0.498f, 0.0f}, {0.5f, 6.0f}, {0.502f, 0.0f}}; // about 0.2 cells thick, 44 % opaque
    const TracedData data = field.traced(tf);
    const auto exact = field.exact(tf);
    const std::vector<float> coarse{4.0f, 2.0f, 1.0f, 0.5f}, fine{0.125f, 0.0625f, 0.03125f};
    const auto of = [&](const Method& m, const std::vector<float>& steps) {
        return Measured(&steps == &coarse ? "shell, coarse" : "shell, fine", m, data, field.tile, exact, steps);
    };
    const Measured middle = of(midpoint, coarse), searched = of(bracket, coarse),
                   integrated = of(preintegrated, coarse);
    EXPECT_LT(of(fixed, coarse).order, 0.2);
    EXPECT_LT(middle.order, 0.2);
    EXPECT_LT(searched.order, 0.5);
    for (std::size_t i = 0; i < coarse.size(); ++i) {
        EXPECT_GT(middle.errors[i], 0.1);
        EXPECT_LT(searched.errors[i], 0.8 * middle.errors[i]); // found, but there is one sample for all of it
        EXPECT_LT(integrated.errors[i], 1e-4);
    }
    EXPECT_GT(of(midpoint, fine).order, 1.5);
}

TEST(MethodsOrder, SurvivesTheKinksOfTrilinearInterpolation)
{
    const RayTile tile = obliqueRays();
    const TracedData data(
        cubeOfBricks(vec3i(0), 32, 16), [](const vec3d& p) { return waves(3.0 * p); },
        extinctionRamp({-1.2f, 1.2f}, 0.0f, 0.15f, false));
    const auto exact = converged(data, tile);
    const std::vector<float> steps{1.0f, 0.5f, 0.25f, 0.125f};
    const auto of = [&](const Method& m) { return Measured("kinks", m, data, tile, exact, steps).order; };
    expectBetween(0.9, of(fixed), 1.15);
    expectBetween(1.8, of(midpoint), 2.2);
    expectBetween(1.8, of(bracket), 2.2);
    expectBetween(1.8, of(preintegrated), 2.1);
}

TEST(MethodsOrder, IsLowAcrossLevelsUntilStepsAreShorterThanCells)
{
    const RayTile tile = obliqueRays();
    const TracedData data(
        threeLevels(3), [](const vec3d& p) { return waves(1.5 * p); },
        extinctionRamp({-1.2f, 1.2f}, 0.0f, 0.15f, false));
    const auto exact = converged(data, tile);
    const std::vector<float> coarse{4.0f, 2.0f, 1.0f}, fine{1.0f, 0.5f, 0.25f, 0.125f};
    const auto of = [&](const Method& m, const std::vector<float>& steps) {
        return Measured(&steps == &coarse ? "levels, coarse" : "levels, fine", m, data, tile, exact, steps).order;
    };
    expectBetween(0.9, of(fixed, fine), 1.15);
    for (const Method& m : {midpoint, bracket, preintegrated}) {
        expectBetween(0.8, of(m, coarse), 1.6);
        expectBetween(1.7, of(m, fine), 2.2);
    }
}

} // namespace
} // namespace brickwall
