// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Volume, surfaces and planes in the colours of another field.
#include "brickwall/core/base/Error.h"
#include "brickwall/tests/oracles/ReferenceReconstruction.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <gtest/gtest.h>

#include <cmath>
#include <utility>

namespace brickwall {
namespace {

using namespace test;

constexpr double sigma = 0.1;

/// `field` is what is seen, `other` says in which colour.
Scene twoFields(const std::vector<Brick>& bricks, const VoxelFunction& field, const VoxelFunction& other,
                const TransferFunction& tf)
{
    Scene scene = sceneOf(bricks, fieldOf(bricks, field), tf);
    Progress silent;
    scene.colorField =
        std::make_shared<PaddedField>(padField(fieldOf(bricks, other), bricks, *scene.regions, Executor(1), silent));
    return scene;
}

/// Even fog over [-1/2, 16.5]; the colour rises with x, from black at 2 to red at 14.
Scene fogThatReddens()
{
    TransferFunction tf = extinctionRamp({0.0f, 1.0f}, float(sigma), float(sigma), false);
    tf.colorField = ColorField{"x", {2.0f, 14.0f}};
    return twoFields(
        cubeOfBricks(vec3i(0), 16, 8), [](const vec3d&) { return 0.5; }, [](const vec3d& p) { return p.x; }, tf);
}

/// What a ray along x collects of that: integrals of (x - 2) / 12 e^(-sigma x) from 2 to 14, then of e^(-sigma x).
double redOfFog()
{
    const auto through = [](double x) { return std::exp(-sigma * (x + 0.5)); };
    const double rising = (through(2) - through(14)) / (12.0 * sigma) - through(14);
    return rising + through(14) - through(16.5);
}

RenderSettings settingsFor(Method method, double tolerance, Shading shading = Shading::off)
{
    RenderSettings settings = settingsOf(0.25f, shading);
    settings.method = method;
    settings.bounded.tolerance = static_cast<float>(tolerance);
    return settings;
}

class ColoredByField : public testing::TestWithParam<int>
{
};

TEST_P(ColoredByField, ColorsFogAsItsClosedFormDoes)
{
    const auto method = static_cast<Method>(GetParam());
    const Frame frame = renderOne(fogThatReddens(), lookAlong({-4, 7.25, 8.5}, 0, 1.0), settingsFor(method, 1e-4));
    const double most = method == Method::fixed ? 0.02 : 1e-4;
    EXPECT_NEAR(frame.color[0].r, redOfFog(), method == Method::reference ? 1e-7 : most);
    EXPECT_NEAR(frame.color[0].g, 0.0, 1e-7);
    EXPECT_NEAR(frame.color[0].a, 1.0 - std::exp(-17.0 * sigma), most);
}

/// Two different fields on three levels, in colours that have knots, and a step.
Scene wavesInColors(unsigned seed, bool stepped)
{
    TransferFunction tf = colorful({-1.0f, 1.0f});
    tf.colors = {{0.0f, {1.0f, 0.2f, 0.1f}}, {0.4f, {0.1f, 0.9f, 0.3f}}, {1.0f, {0.2f, 0.1f, 1.0f}}};
    if (stepped)
        tf.colors = {{0.3f, {1.0f, 0.0f, 0.1f}}, {0.6f, {0.1f, 0.9f, 0.3f}}, {0.6f, {0.2f, 0.1f, 1.0f}}};
    tf.colorField = ColorField{"other", {-0.6f, 0.8f}};
    const auto other = [](const vec3d& p) { return waves({p.z + 3.0, 1.3 * p.x, p.y - 7.0}); };
    return twoFields(threeLevels(seed), waves, other, tf);
}

double differenceFromReference(const Scene& scene, RenderSettings settings)
{
    const View view = lookAt({50, 40, 55}, {16, 15, 17}, 16, 16);
    const Frame frame = renderOne(scene, view, settings);
    settings.method = Method::reference;
    return difference(frame, renderOne(scene, view, settings));
}

TEST_P(ColoredByField, OnSeveralLevelsConvergesToTheReference)
{
    const auto method = static_cast<Method>(GetParam());
    RenderSettings settings = settingsFor(method, 1e-3);
    settings.step.dt = 0.05f;
    settings.step.interleave = false;
    EXPECT_LT(differenceFromReference(wavesInColors(3, false), settings), method == Method::fixed ? 0.03 : 1e-3);
}

INSTANTIATE_TEST_SUITE_P(Methods, ColoredByField, testing::Range(0, int(methodNames.size())),
                         [](const auto& info) { return methodNames[std::size_t(info.param)]; });

TEST(ColorFields, BoundedKeepsItsToleranceWithEveryColour)
{
    for (const Shading shading : {Shading::off, Shading::headlight})
        for (const bool stepped : {false, true})
            for (const double tolerance : {0.1, 0.03, 1.0 / 255.0, 1e-3})
                for (unsigned seed = 1; seed <= 2; ++seed)
                    EXPECT_LE(differenceFromReference(wavesInColors(seed, stepped),
                                                      settingsFor(Method::bounded, tolerance, shading)),
                              tolerance)
                        << "seed " << seed << (stepped ? ", a step" : "") << ", tolerance " << tolerance;
}

TEST(ColorFields, BoundedKeepsItsToleranceWhereThinShellsChangeTheirColour)
{
    for (const double tolerance : {0.03, 1.0 / 255.0, 1e-3})
        for (const unsigned seed : {4u, 5u}) {
            Scene scene = wavesInColors(seed, false);
            scene.transferFunction.opacity = {{0.45f, 0.0f}, {0.5f, 8.0f}, {0.51f, 8.0f}, {0.52f, 0.0f},
                                              {0.7f, 0.0f},  {0.7f, 2.0f}, {0.72f, 0.0f}};
            EXPECT_LE(differenceFromReference(scene, settingsFor(Method::bounded, tolerance)), tolerance)
                << "seed " << seed;
        }
}

TEST(ColorFields, ThatIsTheFieldItselfChangesNothing)
{
    Scene scene = sceneOf(threeLevels(7), fieldOf(threeLevels(7), waves), colorful({-1.0f, 1.0f}));
    scene.surfaces = {{0.2f, vec3f(1.0f), 0.5f, true}};
    scene.colorField = scene.field;
    Scene same = scene;
    same.transferFunction.colorField = ColorField{"same", {-1.0f, 1.0f}};
    scene.surfaces[0].color = vec3f(colorAt(scene.transferFunction, 0.2f));
    const View view = lookAt({50, 40, 55}, {16, 15, 17}, 24, 24);
    for (const Method method : {Method::reference, Method::midpoint, Method::bracket})
        EXPECT_LT(difference(renderOne(scene, view, settingsFor(method, 1.0)),
                             renderOne(same, view, settingsFor(method, 1.0))),
                  2e-6)
            << methodNames[std::size_t(method)];
    const RenderSettings bounded = settingsFor(Method::bounded, 1e-4);
    EXPECT_LT(difference(renderOne(scene, view, bounded), renderOne(same, view, bounded)), 2e-4);
}

/// The colour of the first surface that pixels show, by the definition of the reconstruction at their depth.
TEST(ColorFields, ColorsSurfacesByItsValueAtTheHit)
{
    Scene scene = wavesInColors(11, false);
    scene.transferFunction.opacityScale = 0.0f;
    scene.surfaces = {{0.15f, vec3f(1.0f), 1.0f, true}};
    const std::vector<Brick> bricks = threeLevels(11);
    const Model model = oracles::modelOf(bricks, [](const vec3d& p) {
        return waves({p.z + 3.0, 1.3 * p.x, p.y - 7.0});
    });
    const oracles::ReferenceReconstruction other(model, model.fields.front());
    const View view = lookAt({50, 40, 55}, {16, 15, 17}, 32, 32);
    const Frame frame = renderOne(scene, view, settingsFor(Method::bounded, 1.0));
    const mat4d worldFromClip = glm::inverse(view.clipFromWorld);
    int hits = 0;
    double most = 0.0;
    for (int y = 0; y < 32; ++y)
        for (int x = 0; x < 32; ++x) {
            const std::size_t i = frame.index(x, y);
            if (frame.color[i].a != 1.0f)
                continue;
            ++hits;
            const vec3d clip((x + 0.5) / 16.0 - 1.0, (y + 0.5) / 16.0 - 1.0, 2.0 * frame.depth[i] - 1.0);
            const vec3d at = transformPoint(worldFromClip, clip);
            const vec3d color = colorAt(scene.transferFunction, other.atVoxel(at).value);
            for (int c = 0; c < 3; ++c)
                most = std::max(most, std::abs(color[c] - frame.color[i][c]));
        }
    EXPECT_GT(hits, 100);
    EXPECT_LT(most, 2e-3) << "a depth of 32 bits is right to some thousandths of a cell";
    const Frame reference = renderOne(scene, view, settingsFor(Method::reference, 1.0));
    EXPECT_LT(difference(frame, reference), 2e-5) << "whose own surfaces have colours of their own making";
}

TEST(ColorFields, ColorsPlanesByItsValue)
{
    Scene scene = fogThatReddens();
    scene.transferFunction.opacityScale = 0.0f;
    scene.planes = {{{{1, 0, 0}, 8.0}, 1.0f}};
    const Frame frame = renderOne(scene, lookAlong({-4, 7.25, 8.5}, 0, 1.0), settingsFor(Method::bounded, 1e-3));
    EXPECT_NEAR(frame.color[0].r, 0.5, 1e-6);
}

TEST(ColorFields, HasTheColourOfItsEndsBeyondItsRange)
{
    Scene scene = fogThatReddens();
    scene.transferFunction.colorField->range = {-8.0f, -4.0f};
    for (std::size_t m = 0; m < methodNames.size(); ++m) {
        const Frame frame =
            renderOne(scene, lookAlong({-4, 7.25, 8.5}, 0, 1.0), settingsFor(static_cast<Method>(m), 1e-4));
        EXPECT_NEAR(frame.color[0].r, frame.color[0].a, 1e-6) << methodNames[m];
        EXPECT_GT(frame.color[0].a, 0.7) << methodNames[m];
    }
}

TEST(ColorFields, ThatTheSceneDoesNotHaveIsRefusedAndNothingHasChanged)
{
    Scene scene = fogThatReddens();
    const TransferFunction colored = scene.transferFunction;
    scene.transferFunction.colorField.reset();
    scene.colorField.reset();
    const Executor serial(1);
    Renderer renderer(scene, serial);
    EXPECT_THROW(renderer.setTransferFunction(colored), Error);
    EXPECT_FALSE(renderer.scene().transferFunction.colorField);
    scene.colorField = std::make_shared<PaddedField>();
    EXPECT_THROW(Renderer(scene, serial), Error) << "of other regions";
}

} // namespace
} // namespace brickwall
