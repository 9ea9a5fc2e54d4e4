// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Integrals along rays against closed forms, and against the same method written down plainly in double.
#include "brickwall/tests/oracles/ReferenceReconstruction.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace brickwall {
namespace {

using namespace test;

/// The length in a box of the ray of a pixel.
double lengthIn(const Box3d& box, const View& view, int x, int y)
{
    const vec3d dir = rayDirection(view, x, y);
    double t0 = 0.0, t1 = 1e30;
    for (int a = 0; a < 3; ++a) {
        const double n = (box.lower[a] - view.eye[a]) / dir[a], f = (box.upper[a] - view.eye[a]) / dir[a];
        t0 = std::max(t0, std::min(n, f));
        t1 = std::min(t1, std::max(n, f));
    }
    return std::max(0.0, t1 - t0) * glm::length(dir);
}

class ConstantBox : public testing::TestWithParam<int>
{
};

TEST_P(ConstantBox, HasTheOpacityOfItsThicknessHoweverItIsCut)
{
    const auto bricks = cubeOfBricks({3, -5, 7}, 16, GetParam());
    const Field field = fieldOf(bricks, [](const vec3d&) { return 0.5; });
    const float sigma = 0.08f;
    const Scene scene = sceneOf(bricks, field, extinctionRamp({0.0f, 1.0f}, sigma, sigma));
    const Box3d support{{2.5, -5.5, 6.5}, {19.5, 11.5, 23.5}};
    for (const vec3d eye : {vec3d(-20, 9, -14), vec3d(11, 3, 15), vec3d(11.5, 30, 15.5)}) {
        const View view = lookAt(eye, {11, 3, 15.25}, 21, 17);
        const Frame frame = renderOne(scene, view, settingsOf(0.7f, Shading::headlight));
        for (int y = 0; y < frame.height; ++y)
            for (int x = 0; x < frame.width; ++x) {
                const double alpha = 1.0 - std::exp(-sigma * lengthIn(support, view, x, y));
                for (int c = 0; c < 4; ++c)
                    ASSERT_NEAR(frame.color[frame.index(x, y)][c], alpha, 1e-5) << x << ' ' << y << ' ' << c;
            }
    }
}
INSTANTIATE_TEST_SUITE_P(Cuts, ConstantBox, testing::Values(16, 8, 4, 1));

TEST(RenderIntegral, ConstantAcrossThreeLevelsIsConstant)
{
    // Level 2, then 0, then 1 along x: the support reaches 2 voxels out on the left, 1 on the right.
    std::vector<Brick> bricks = {
        {{0, 0, 0}, {4, 4, 4}, 2, 0}, {{16, 0, 0}, {16, 16, 16}, 0, 0}, {{32, 0, 0}, {8, 8, 8}, 1, 0}};
    bricks = numbered(bricks);
    // 0.1 is no binary fraction, and the range ends there: a value that rounding pushes beyond is transparent.
    const Field field = fieldOf(bricks, [](const vec3d&) { return 0.1; });
    const Scene scene = sceneOf(bricks, field, extinctionRamp({0.0f, 0.1f}, 0.05f, 0.05f));
    const Frame frame = renderOne(scene, lookAt({-30, 8.2, 7.7}, {20, 8.2, 7.7}, 1, 1), settingsOf(0.5f));
    EXPECT_NEAR(frame.color[0].a, 1.0 - std::exp(-0.05 * (48 + 2 + 1)), 1e-5);
}

/// v = x, constant beyond the outermost cell centres.
struct Ramp
{
    std::vector<Brick> bricks = cubeOfBricks(vec3i(0), 16, 16);
    Field field = fieldOf(bricks, [](const vec3d& p) { return p.x; });
    View view = lookAt({-20, 8, 8}, {8, 8, 8}, 1, 1);

    static double value(double x) { return std::clamp(x, 0.5, 15.5); }
    /// The optical depth of [-0.5, x] for extinction a v.
    static double depth(double a, double x)
    {
        const double inner = std::clamp(x, 0.5, 15.5);
        return a * (0.5 * std::min(x + 0.5, 1.0) + 0.5 * (inner * inner - 0.25) + 15.5 * std::max(0.0, x - 15.5));
    }
};

TEST(RenderIntegral, LinearExtinctionHasTheClosedFormsOpacity)
{
    const Ramp ramp;
    const Scene scene = sceneOf(ramp.bricks, ramp.field, extinctionRamp({0.0f, 16.0f}, 0.0f, 0.32f));
    const Frame frame = renderOne(scene, ramp.view, settingsOf(0.5f));
    EXPECT_NEAR(frame.color[0].a, 1.0 - std::exp(-Ramp::depth(0.02, 16.5)), 1e-5);
}

TEST(RenderIntegral, MidpointConvergesWithOrderTwo)
{
    const Ramp ramp;
    const Scene scene = sceneOf(ramp.bricks, ramp.field, extinctionRamp({0.0f, 16.0f}, 0.0f, 0.8f, false));
    double exact = 0.0;
    const double h = 1e-4;
    for (double x = -0.5 + h / 2; x < 16.5; x += h) {
        const double v = Ramp::value(x);
        exact += v / 16.0 * 0.05 * v * std::exp(-Ramp::depth(0.05, x)) * h;
    }
    // Many rays that differ in nothing but the offset of their sample planes.
    const View narrow = lookAt(ramp.view.eye, {8, 8, 8}, 16, 16, 1e-4);
    std::vector<double> errors;
    for (const float dt : {2.0f, 1.0f, 0.5f}) {
        double sum = 0.0;
        for (const vec4f& color : renderOne(scene, narrow, settingsOf(dt)).color)
            sum += std::pow(color.r - exact, 2);
        errors.push_back(std::sqrt(sum / 256));
    }
    for (std::size_t i = 0; i + 1 < errors.size(); ++i) {
        const double order = std::log2(errors[i] / errors[i + 1]);
        EXPECT_GT(order, 1.8) << errors[i] << ' ' << errors[i + 1];
        EXPECT_LT(order, 2.2);
    }
}

/// The same method for one ray in double: all regions intersected and sorted, B by its definition.
vec4d plainMarch(const oracles::ReferenceReconstruction& basis, const Scene& scene, const View& view, int x, int y,
                 double dt, bool shaded)
{
    const vec3d dir = glm::normalize(rayDirection(view, x, y));
    const Box3d bounds{0.5 * vec3d(scene.regions->bounds.lower), 0.5 * vec3d(scene.regions->bounds.upper)};
    // Sample planes are counted from the last whole voxel before the data.
    const double start = std::floor(glm::distance(view.eye, glm::clamp(view.eye, bounds.lower, bounds.upper)));
    struct Piece
    {
        double t0, t1, step;
    };
    std::vector<Piece> pieces;
    for (const Region& r : scene.regions->regions) {
        double t0 = 0.0, t1 = 1e30;
        for (int a = 0; a < 3; ++a) {
            const double n = (0.5 * r.lower[a] - view.eye[a]) / dir[a], f = (0.5 * r.upper[a] - view.eye[a]) / dir[a];
            t0 = std::max(t0, std::min(n, f));
            t1 = std::min(t1, std::max(n, f));
        }
        if (t0 < t1)
            pieces.push_back({t0 - start, t1 - start, dt * (1 << r.finestLevel)});
    }
    std::sort(pieces.begin(), pieces.end(), [](const Piece& a, const Piece& b) { return a.t0 < b.t0; });
    vec4d sum(0.0);
    for (const Piece& piece : pieces) {
        double last = piece.t0;
        for (double k = std::floor(last / piece.step) + 1.0; last < piece.t1; k += 1.0) {
            const double next = std::min(k * piece.step, piece.t1);
            const auto b = basis.atVoxel(view.eye + (start + 0.5 * (last + next)) * dir);
            if (b.valid) {
                const double a = 1.0 - std::exp(-extinctionAt(scene.transferFunction, b.value) * (next - last));
                const double g = glm::length(b.gradient);
                const double shade = shaded && g > 1e-9 ? std::abs(glm::dot(b.gradient, dir)) / g : 1.0;
                sum += (1.0 - sum.a) * a * vec4d(shade * colorAt(scene.transferFunction, b.value), 1.0);
            }
            last = next;
        }
    }
    return sum;
}

class PlainMarch : public testing::TestWithParam<std::tuple<unsigned, Shading>>
{
};

TEST_P(PlainMarch, InDoubleGivesTheSamePicture)
{
    const auto [seed, shading] = GetParam();
    const Model model = oracles::modelOf(threeLevels(seed), waves);
    const oracles::ReferenceReconstruction basis(model, model.fields[0]);
    const Scene scene = sceneOf(model.bricks, model.fields[0], colorful({-1.0f, 1.0f}));
    RenderSettings settings = settingsOf(0.5f, shading);
    settings.step.interleave = false;
    for (const vec3d eye : {vec3d(-25.3, 40.1, -30.7), vec3d(15.2, 17.3, 14.9), vec3d(70.1, 12.2, 3.3)}) {
        const View view = lookAt(eye, {16.1, 15.3, 18.2}, 13, 11, 60.0);
        const Frame frame = renderOne(scene, view, settings);
        for (int y = 0; y < frame.height; ++y)
            for (int x = 0; x < frame.width; ++x) {
                const vec4d exact = plainMarch(basis, scene, view, x, y, 0.5, shading == Shading::headlight);
                for (int c = 0; c < 4; ++c)
                    ASSERT_NEAR(frame.color[frame.index(x, y)][c], exact[c], 1e-4) << x << ' ' << y << ' ' << c;
            }
    }
}
INSTANTIATE_TEST_SUITE_P(Layouts, PlainMarch,
                         testing::Combine(testing::Values(1u, 2u, 3u),
                                          testing::Values(Shading::off, Shading::headlight)));

/// Rays parallel to axes, in faces and along edges of regions and bricks, and from eyes on them.
TEST(RenderIntegral, RaysInFacesOfRegionsSeeTheWholeThickness)
{
    const auto bricks = cubeOfBricks(vec3i(0), 16, 4);
    const Field field = fieldOf(bricks, [](const vec3d&) { return 1.0; });
    const Scene scene = sceneOf(bricks, field, extinctionRamp({0.0f, 1.0f}, 0.03f, 0.03f));
    for (int axis = 0; axis < 3; ++axis)
        for (const double sign : {-1.0, 1.0})
            for (const double along : {0.0, 4.0, 4.5, 7.5, 8.0, 0.25}) {
                vec3d eye(along);
                eye[axis] = 8.0 - sign * 30.0;
                const Frame outside = renderOne(scene, lookAlong(eye, axis, sign), settingsOf(0.5f));
                EXPECT_NEAR(outside.color[0].a, 1.0 - std::exp(-0.03 * 17), 1e-5) << axis << sign << along;
                eye[axis] = 4.5;
                const double rest = sign > 0 ? 16.5 - 4.5 : 4.5 + 0.5;
                const Frame inside = renderOne(scene, lookAlong(eye, axis, sign), settingsOf(0.5f));
                EXPECT_NEAR(inside.color[0].a, 1.0 - std::exp(-0.03 * rest), 1e-5) << axis << sign << along;
            }
}

} // namespace
} // namespace brickwall
