// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// What the methods of the literature compute exactly, and how much work they say that it was.
#include "brickwall/core/simd/Target.h"
#include "brickwall/tests/trace/MethodsScenes.h"

#include <gtest/gtest.h>

namespace brickwall {
namespace {

using namespace test;

constexpr TraceMethod methods[] = {traceFixed, traceMidpoint, traceBracket, tracePreintegrated};

/// S(b) - S(a) over b - a, in double.
double meanExtinction(const TransferIntegral& f, double a, double b)
{
    const auto integral = [&](double v) {
        const double inside = std::clamp(v, double(f.range.lo), double(f.range.hi));
        const int i = f.segmentOf(float(inside));
        const double x = inside - f.knots[i];
        const TransferIntegral::Segment& s = f.segments[i];
        return double(s.integral.w) + s.rest.w + x * (s.density.w + 0.5 * x * s.slope.w);
    };
    return (integral(b) - integral(a)) / (b - a);
}

std::vector<TransferFunction> whiteFunctions()
{
    TransferFunction ramp = extinctionRamp({0.0f, 1.0f}, 0.0f, 0.12f), steps = ramp, spikes = ramp, opaque = ramp;
    steps.opacity = {{0.2f, 0.0f}, {0.2f, 0.1f}, {0.3f, 0.02f}, {0.7f, 0.2f}, {0.7f, 0.0f}};
    spikes.opacity = {{0.2f, 0.0f}, {0.20005f, 99.0f},  {0.2001f, 0.0f},
                      {0.6f, 0.0f}, {0.60001f, 900.0f}, {0.60002f, 0.0f}};
    opaque.kind = TransferFunction::Kind::opacity;
    opaque.opacity = {{0.25f, 0.0f}, {0.3f, 1.0f}, {0.35f, 0.0f}};
    TransferFunction decades = ramp, xf = ramp, window = ramp;
    decades.range = {1e-5f, 1.0f};
    decades.scale = Scale::logarithmic;
    decades.opacity = {{0.0f, 0.2f}, {0.5f, 0.0f}, {0.9f, 0.3f}, {1.0f, 0.1f}};
    window.range = {0.3f, 0.4f};
    window.opacity = {{0.0f, 0.3f}, {1.0f, 0.1f}}; // opens and closes with a step
    xf.opacity.clear();
    for (int i = 0; i < 128; ++i)
        xf.opacity.push_back({float(i) / 127.0f, 0.1f * float(i * 37 % 11)});
    return {ramp, steps, spikes, opaque, decades, window, xf};
}

/// Rays that see the field run linearly, up, down and hardly at all.
struct LinearRays
{
    std::vector<Brick> bricks = cubeOfBricks(vec3i(0), 32, 16);
    RayTile tile;

    LinearRays()
    {
        addRay(tile, {1, 6, 7}, {31, 8, 5});
        addRay(tile, {31, 6, 7}, {1, 26, 9});
        addRay(tile, {9, 6, 1}, {9.001, 9, 28});
        for (int i = 0; i < 61; ++i)
            addRay(tile, {1.0 + 0.3 * i, 5, 3}, {1.05 + 0.31 * i + 0.002 * i * i, 11, 29.0 - 0.2 * i},
                   0.01f * float(i));
    }
    static double value(const vec3d& p) { return 0.03125 * p.x; }
};

TEST(MethodsExact, PreintegratedIsExactForWhateverIsLinearInEveryInstructionSet)
{
    LinearRays rays;
    for (const TransferFunction& tf : whiteFunctions()) {
        const TracedData data(rays.bricks, LinearRays::value, tf);
        for (const std::string& target : laneTargets())
            for (const float dt : {0.7f, 5.0f, 1e9f}) {
                chooseLaneTarget(target);
                TileResult result;
                tracePreintegrated(data.traced(), {dt, 1.0f, false}, rays.tile, result);
                for (int i = 0; i < rays.tile.count; ++i) {
                    const double a = LinearRays::value(pointOn(rays.tile, i, 0.0));
                    const double b = LinearRays::value(pointOn(rays.tile, i, rays.tile.tFar[i]));
                    // Rounding of the values at both ends moves what a steep function shows of its edge.
                    const double length = rays.tile.tFar[i], mean = meanExtinction(data.integral, a, b);
                    const double steep = data.integral.largestExtinction(tf.range) * length / std::abs(b - a) * 2e-7;
                    EXPECT_NEAR(result.transmittance[i], std::exp(-mean * length), 3e-6 + steep)
                        << target << " dt " << dt << " ray " << i;
                    EXPECT_NEAR(result.color[0][i], 1.0 - result.transmittance[i], 2e-6);
                }
            }
    }
    chooseLaneTarget("");
}

TEST(MethodsExact, AllAreExactInAConstantField)
{
    RayTile tile;
    addRay(tile, {2, 2, 2}, {2, 2, 29});
    addRay(tile, {3, 4, 5}, {29, 28, 26});
    tile.tFar[0] = 27.0f;
    tile.tFar[1] = 36.0f;
    const TracedData data(
        threeLevels(3), [](const vec3d&) { return 0.5; }, extinctionRamp({0, 1}, 0.02f, 0.06f));
    for (const TraceMethod method : methods)
        for (const float dt : {0.5f, 3.0f}) { // divide the rays' lengths, so that `fixed` has no rest
            TileResult result;
            method(data.traced(), {dt, 1.0f, false}, tile, result);
            EXPECT_NEAR(result.transmittance[0], std::exp(-0.04 * 27.0), 2e-6);
            EXPECT_NEAR(result.transmittance[1], std::exp(-0.04 * 36.0), 2e-6);
            EXPECT_NEAR(result.color[1][1], 1.0 - result.transmittance[1], 2e-6);
        }
}

TEST(MethodsExact, ARayDoesNotDependOnItsNeighbours)
{
    const TracedData data(threeLevels(3), waves, colorful({-0.4f, 0.7f}));
    std::mt19937 random(11);
    std::uniform_real_distribution<double> in(0.0, 32.0);
    RayTile together;
    std::vector<std::pair<vec3d, vec3d>> ends;
    for (int i = 0; i < 37; ++i) {
        ends.push_back({{in(random), in(random), in(random)}, {in(random), in(random), in(random)}});
        addRay(together, ends.back().first, ends.back().second);
    }
    for (const TraceMethod method : methods) {
        TileResult all;
        method(data.traced(), {0.8f, 0.998f, true}, together, all);
        std::uint64_t samples = 0, fetches = 0;
        for (int i = 0; i < 37; ++i) {
            RayTile alone;
            addRay(alone, ends[std::size_t(i)].first, ends[std::size_t(i)].second);
            TileResult one;
            method(data.traced(), {0.8f, 0.998f, true}, alone, one);
            EXPECT_EQ(resultOf(one, 0), resultOf(all, i));
            EXPECT_EQ(one.weightedDistance[0], all.weightedDistance[i]);
            samples += one.counts.samples;
            fetches += one.counts.fetches;
        }
        EXPECT_EQ(all.counts.samples, samples);
        EXPECT_EQ(all.counts.fetches, fetches);
        EXPECT_GT(fetches, samples); // there are regions of several bricks
    }
}

TEST(MethodsExact, FixedSamplesEveryPlaneOnce)
{
    const TracedData data(threeLevels(3), waves, extinctionRamp({-2, 2}, 0, 0.01f));
    RayTile tile;
    addRay(tile, {1, 2, 3}, {30, 29, 31}, 0.25f);
    tile.tFar[0] = 40.0f;
    for (const float dt : {0.125f, 0.5f, 2.0f, 16.0f}) { // planes are exact floats
        TileResult result;
        traceFixed(data.traced(), {dt, 1.0f, false}, tile, result);
        EXPECT_EQ(result.counts.samples, std::uint64_t(std::ceil(40.0f / dt - 0.25f))) << dt;
    }
}

TEST(MethodsExact, PreintegratedTakesOneSampleMorePerRegionThanMidpoint)
{
    const TracedData data(threeLevels(3), waves, extinctionRamp({-2, 2}, 0, 0.01f));
    RayTile tile;
    addRay(tile, {1, 2, 3}, {30, 29, 31}, 0.25f);
    TileResult a, b;
    traceMidpoint(data.traced(), {0.5f, 1.0f, false}, tile, a);
    tracePreintegrated(data.traced(), {0.5f, 1.0f, false}, tile, b);
    EXPECT_EQ(b.counts.regionsVisited, a.counts.regionsVisited);
    EXPECT_EQ(b.counts.samples, a.counts.samples + a.counts.regionsVisited);
}

TEST(MethodsExact, BracketFindsAShellThatMidpointMisses)
{
    LinearRays rays;
    TransferFunction tf = extinctionRamp({0.0f, 1.0f}, 0.0f, 0.0f);
    tf.opacity = {{0.28025f, 0.0f}, {0.28025f, 20.0f}, {0.28225f, 20.0f}, {0.28225f, 0.0f}};
    const TracedData data(rays.bricks, LinearRays::value, tf);
    RayTile tile;
    addRay(tile, {1, 6, 7}, {31, 6, 7}); // through it at x = 9, 0.064 cells thick
    TileResult stepped, searched;
    traceMidpoint(data.traced(), {4.0f, 1.0f, false}, tile, stepped);
    traceBracket(data.traced(), {4.0f, 1.0f, false}, tile, searched);
    EXPECT_EQ(stepped.transmittance[0], 1.0f);
    EXPECT_NEAR(searched.transmittance[0], std::exp(-20.0 * 0.064), 0.05); // edges to 0.005 cells
}

TEST(MethodsExact, EndWhereFloatsAreFurtherApartThanSteps)
{
    LinearRays rays;
    const TracedData data(rays.bricks, LinearRays::value, extinctionRamp({0, 1}, 0.1f, 0.1f));
    RayTile tile;
    addRay(tile, {-4e6, 6, 7}, {8, 6, 7});
    tile.tNear[0] = 4e6f + 2.0f;
    tile.tFar[0] = 4e6f + 6.0f;
    for (const TraceMethod method : methods) {
        TileResult result;
        method(data.traced(), {0.01f, 1.0f, false}, tile, result);
        EXPECT_LE(result.counts.samples, 200u);
    }
}

} // namespace
} // namespace brickwall
