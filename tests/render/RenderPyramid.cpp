// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Far away, averaged data (core/model/Pyramid.h) in place of the data themselves.
#include "RenderScenes.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/core/model/Pyramid.h"

#include <glm/trigonometric.hpp>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

namespace brickwall::test {
namespace {

/// With all the members that there are.
Scene withPyramid(const std::vector<Brick>& bricks, const VoxelFunction& value, const TransferFunction& tf,
                  const mat4d& worldFromVoxel = mat4d(1.0))
{
    const Executor serial(1);
    Progress silent;
    const Model model = oracles::modelOf(bricks, value, worldFromVoxel);
    Scene scene = sceneOf(bricks, model.fields.front(), tf, worldFromVoxel);
    for (const PyramidMember& member : buildPyramid(model, {.leastCells = 8}, serial, silent))
        scene.pyramid.push_back({member.level, member.regions, member.fields.front()});
    return scene;
}

/// A smooth ball in the middle of a cube of 32 world units, on `width` cells per axis; nothing is seen at the faces.
Scene ballOn(int width)
{
    const double cell = 32.0 / width;
    mat4d worldFromVoxel(cell);
    worldFromVoxel[3] = vec4d(-16.0, -16.0, -16.0, 1.0);
    const auto ball = [=](const vec3d& voxel) {
        const vec3d p = voxel * cell - 16.0;
        return std::exp(-0.02 * glm::dot(p, p));
    };
    TransferFunction tf = extinctionRamp({0.02f, 1.0f}, 0.0f, static_cast<float>(0.15 * cell), false);
    return withPyramid(cubeOfBricks(vec3i(0), width, 16), ball, tf, worldFromVoxel);
}

View from(double distance, int pixels = 24)
{
    return lookAt(distance * glm::normalize(vec3d(0.3, 0.2, 1.0)), vec3d(0.0), pixels, pixels);
}

ViewStatistics statisticsOf(const Scene& scene, const View& view, const RenderSettings& settings,
                            Frame* frame = nullptr)
{
    const Executor serial(1);
    Progress silent;
    std::vector<ViewStatistics> statistics;
    auto frames = Renderer(scene, serial).render({&view, 1}, settings, silent, &statistics);
    if (frame)
        *frame = std::move(frames.front());
    return statistics.front();
}

RenderSettings withLod(RenderSettings settings, float cellPixels)
{
    settings.lod.cellPixels = cellPixels;
    return settings;
}

RenderSettings boundedSettings()
{
    RenderSettings settings;
    settings.shading = Shading::off;
    return settings;
}

TEST(RenderPyramid, WithoutLodItIsNotThere)
{
    const Scene scene = ballOn(32);
    Scene plain = scene;
    plain.pyramid.clear();
    ASSERT_FALSE(scene.pyramid.empty());
    EXPECT_EQ(
        difference(renderOne(scene, from(100.0), settingsOf(0.5f)), renderOne(plain, from(100.0), settingsOf(0.5f))),
        0.0);
    EXPECT_EQ(statisticsOf(scene, from(100.0), settingsOf(0.5f)).memberSamples.size(), 1u);
}

/// From 200 units a pixel is 6 units wide, twelve cells of the finer data: 32 and 128 cells per axis are seen as 8.
TEST(RenderPyramid, AFarViewOfDataWithTwoMoreLevelsCostsTheSame)
{
    const Scene coarse = ballOn(32), fine = ballOn(128);
    for (const RenderSettings& settings : {settingsOf(0.5f), boundedSettings()}) {
        const auto cost = [&](const Scene& scene, float lod) {
            return double(statisticsOf(scene, from(200.0), withLod(settings, lod)).counts.fetches);
        };
        EXPECT_LE(cost(fine, 1.0f), 1.3 * cost(coarse, 1.0f));
        if (settings.method == Method::midpoint) {
            EXPECT_GE(cost(fine, 0.0f), 2.0 * cost(coarse, 0.0f));
        } else { // it was four times as much: see below
            EXPECT_LE(cost(coarse, 1.0f), 1.3 * cost(fine, 1.0f));
        }
    }
}

/// The first step along a ray was half a voxel, whatever cells the ray began in: short steps in wide cells, and as
/// one length of step serves for a region, many of them.
TEST(RenderPyramid, CellsOfAnyLevelCostTheSame)
{
    const double cell = 0.25;
    mat4d worldFromVoxel(cell);
    worldFromVoxel[3] = vec4d(-16.0, -16.0, -16.0, 1.0);
    const auto ball = [=](const vec3d& voxel) {
        const vec3d p = voxel * cell - 16.0;
        return std::exp(-0.02 * glm::dot(p, p));
    };
    const TransferFunction tf = extinctionRamp({0.02f, 1.0f}, 0.0f, static_cast<float>(0.15 * cell), false);
    const Scene plain = ballOn(32);
    const Scene ofLevel2 = withPyramid(cubeOfBricks(vec3i(0), 128, 16, 2), ball, tf, worldFromVoxel);
    for (const float lod : {0.0f, 1.0f}) {
        const auto fetches = [&](const Scene& scene) {
            return double(statisticsOf(scene, from(200.0), withLod(boundedSettings(), lod)).counts.fetches);
        };
        EXPECT_NEAR(fetches(ofLevel2) / fetches(plain), 1.0, 0.02) << lod;
    }
}

TEST(RenderPyramid, MembersAreUsedWhereTheirCellsAreAboutAsWideAsWanted)
{
    const Scene scene = ballOn(64);
    const double pixelPerDistance = 2.0 * std::tan(glm::radians(20.0)) / 24, reach = std::sqrt(3.0) * 16.0;
    const int coarsest = scene.pyramid.back().level;
    for (const float lod : {0.25f, 1.0f, 3.0f})
        for (double distance = 30.0; distance < 500.0; distance *= 1.3) {
            const auto samples = statisticsOf(scene, from(distance), withLod(settingsOf(1.0f), lod)).memberSamples;
            for (int level = 0; level < int(samples.size()); ++level) {
                if (samples[std::size_t(level)] == 0)
                    continue;
                const double width = 0.5 * (1 << level) / pixelPerDistance; // in pixels, at distance 1
                const double narrowest = width / (distance + reach), widest = width / (distance - reach);
                EXPECT_TRUE(level == 0 || narrowest < 1.7 * lod) << lod << " " << distance << " " << level;
                EXPECT_TRUE(level == coarsest || widest > 0.59 * lod) << lod << " " << distance << " " << level;
            }
        }
}

TEST(RenderPyramid, EveryMethodGivesTheConstantAndTheAffineFieldWhateverMembersAreUsed)
{
    const oracles::AffineField affine{0.1, {0.004, 0.006, 0.01}};
    const Scene scene = withPyramid(cubeOfBricks(vec3i(0), 32, 8), affine, extinctionRamp({0.0f, 1.0f}, 0.01f, 0.08f));
    const View view = lookAt({20.0, 12.0, 170.0}, {16.0, 16.0, 16.0}, 8, 8, 6.0); // rays that miss the sides
    for (const Method method : {Method::bounded, Method::midpoint, Method::preintegrated, Method::bracket}) {
        RenderSettings settings = settingsOf(0.25f);
        settings.method = method;
        Frame far, near;
        const auto used = statisticsOf(scene, view, withLod(settings, 1.0f), &far).memberSamples;
        statisticsOf(scene, view, settings, &near);
        EXPECT_GT(used.size(), 1u);
        // The first and the last half of a cell, where the data end, are constant: wider ones give another integral.
        EXPECT_LT(difference(far, near), 0.01) << int(method);
    }
}

TEST(RenderPyramid, TheReferenceLooksAtTheDataThemselves)
{
    const Scene scene = ballOn(16);
    RenderSettings settings = boundedSettings();
    settings.method = Method::reference;
    EXPECT_EQ(difference(renderOne(scene, from(300.0, 6), withLod(settings, 1.0f)),
                         renderOne(scene, from(300.0, 6), settings)),
              0.0);
}

TEST(RenderPyramid, TheBoundIsThatOfTheDataUsed)
{
    Scene scene = ballOn(64);
    scene.pyramid.resize(1); // from 60 units all of the data are beyond the distance where it is used alone
    RenderSettings settings = withLod(boundedSettings(), 1.0f);
    settings.bounded.tolerance = 1e-3f;
    Scene member = scene;
    member.regions = scene.pyramid[0].regions;
    member.field = scene.pyramid[0].field;
    member.pyramid.clear();
    RenderSettings reference = boundedSettings();
    reference.method = Method::reference;
    const View view = from(60.0, 16);
    Frame frame;
    const ViewStatistics statistics = statisticsOf(scene, view, settings, &frame);
    ASSERT_EQ(statistics.memberSamples.size(), 2u);
    ASSERT_EQ(statistics.memberSamples[0], 0u);
    EXPECT_LE(difference(frame, renderOne(member, view, reference)), 1e-3);
    EXPECT_LE(statistics.largestBound, 1e-3f);
}

/// Members change one after the other on the way, each at its own place along every ray.
TEST(RenderPyramid, FlyingInNothingPops)
{
    const Scene scene = ballOn(64);
    const RenderSettings settings = boundedSettings();
    const double allowed = 2.0 * settings.bounded.tolerance;
    Frame before, beforeOfData;
    std::size_t members = 0;
    for (double distance = 300.0; distance > 60.0; distance *= 0.99) {
        Frame frame;
        members = std::max(
            members, statisticsOf(scene, from(distance, 16), withLod(settings, 1.0f), &frame).memberSamples.size());
        const Frame ofData = renderOne(scene, from(distance, 16), settings);
        if (!before.color.empty()) {
            const double moved = difference(ofData, beforeOfData);
            EXPECT_LE(difference(frame, before), allowed + moved) << distance;
        }
        before = frame;
        beforeOfData = ofData;
    }
    EXPECT_GE(members, 4u);
}

TEST(RenderPyramid, MembersOutOfOrderAndLodsThatAreNoNumberAreRefused)
{
    const Executor serial(1);
    Scene scene = ballOn(32);
    EXPECT_THROW(statisticsOf(scene, from(100.0), withLod(boundedSettings(), -1.0f)), Error);
    EXPECT_THROW(statisticsOf(scene, from(100.0), withLod(boundedSettings(), INFINITY)), Error);
    std::swap(scene.pyramid[0], scene.pyramid[1]);
    EXPECT_THROW(Renderer(scene, serial), Error);
}

} // namespace
} // namespace brickwall::test
