// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Views that carry the depth of a scene that is drawn elsewhere: rays end there.
#include "brickwall/core/base/Error.h"
#include "brickwall/tests/render/RenderScenes.h"
#include "brickwall/tests/render/ViewScreens.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace brickwall {
namespace {

using namespace test;

/// A cube of 16 voxels; what can be seen of it reaches half a voxel further.
const Box3d support{vec3d(-0.5), vec3d(16.5)};

/// dot(normal, p) = offset.
struct Plane
{
    vec3d normal{0.0};
    double offset = 0.0;

    /// Along a ray; infinite if it never comes there.
    double meets(const vec3d& from, const vec3d& along) const
    {
        const double t = (offset - glm::dot(normal, from)) / glm::dot(normal, along);
        return t > 0.0 ? t : std::numeric_limits<double>::infinity();
    }
};

/// Where the ray enters and leaves the cube.
std::pair<double, double> cubeOf(const vec3d& from, const vec3d& along)
{
    double t0 = 0.0, t1 = std::numeric_limits<double>::infinity();
    for (int a = 0; a < 3; ++a) {
        const double n = (support.lower[a] - from[a]) / along[a], f = (support.upper[a] - from[a]) / along[a];
        t0 = std::max(t0, std::min(n, f));
        t1 = std::min(t1, std::max(n, f));
    }
    return {t0, t1};
}

View withDepth(View view, std::vector<float> depth)
{
    view.sceneDepth = std::make_shared<SceneDepth>(SceneDepth{view.window, std::move(depth)});
    return view;
}

/// As a depth buffer of floats has it.
View withPlane(const View& view, const Plane& plane)
{
    std::vector<float> depth;
    for (int y = 0; y < view.window.height; ++y)
        for (int x = 0; x < view.window.width; ++x) {
            const vec3d along = rayDirection(view, x, y);
            const double t = plane.meets(view.eye, along);
            const vec3d ndc = std::isfinite(t) ? transformPoint(view.clipFromWorld, view.eye + t * along) : vec3d(1.0);
            depth.push_back(float(std::clamp(0.5 * ndc.z + 0.5, 0.0, 1.0)));
        }
    return withDepth(view, std::move(depth));
}

/// Frontal, strongly off-axis, and off-axis by the matrices of a host, 20 to 40 voxels from the cube's centre.
std::vector<View> views()
{
    const vec3d center(8.0);
    const Corners screen = cornersOf(center, glm::rotate(mat4d(1.0), 0.4, vec3d(0.3, 1.0, 0.1)), 24.0, 20.0);
    const vec3d right = glm::normalize(screen.lowerRight - screen.lowerLeft);
    const vec3d up = glm::normalize(screen.upperRight - screen.lowerRight), ahead = glm::cross(up, right);
    const vec3d aside = center - 20.0 * ahead + 11.0 * right - 7.0 * up;
    const auto modelview = modelviewOfScreen(aside, screen.lowerLeft, screen.lowerRight, screen.upperRight);
    const auto projection = projectionOfScreen(aside, screen.lowerLeft, screen.lowerRight, screen.upperRight, 4.0,
                                               std::numeric_limits<double>::infinity());
    return {viewOf(screen, center - 40.0 * ahead, 21, 17, 5.0, 100.0), viewOf(screen, aside, 21, 17, 4.0, 90.0),
            viewOfMatrices("host", modelview, projection, 21, 17)};
}

class SceneDepthOf : public testing::TestWithParam<Method>
{
protected:
    static RenderSettings settings()
    {
        RenderSettings settings = settingsOf(0.25f);
        settings.method = GetParam();
        settings.bounded.tolerance = 2e-6f;
        return settings;
    }
};

TEST_P(SceneDepthOf, APlaneInAConstantBoxLeavesTheOpacityOfWhatIsBeforeIt)
{
    const double sigma = 0.08;
    const auto bricks = cubeOfBricks(vec3i(0), 16, 8);
    const Scene scene = sceneOf(bricks, fieldOf(bricks, [](const vec3d&) { return 0.5; }),
                                extinctionRamp({0.0f, 1.0f}, float(sigma), float(sigma)));
    // A Riemann sum is off by up to a step, at the scene as at the far side of the box.
    const double tolerance = GetParam() == Method::fixed ? sigma * settings().step.dt : 1e-5;
    int cut = 0, untouched = 0, hidden = 0;
    for (const View& bare : views())
        for (const Plane& plane : {Plane{{0.2, 0.1, 1.0}, 8.0}, Plane{{1.0, -0.3, 0.2}, 3.0}}) {
            const View view = withPlane(bare, plane);
            const Frame frame = renderOne(scene, view, settings());
            for (int y = 0; y < frame.height; ++y)
                for (int x = 0; x < frame.width; ++x) {
                    const vec3d along = rayDirection(view, x, y);
                    const auto [t0, t1] = cubeOf(view.eye, along);
                    const double end = plane.meets(view.eye, along);
                    const double length = std::max(0.0, std::min(t1, end) - t0) * glm::length(along);
                    const std::size_t i = frame.index(x, y);
                    ASSERT_NEAR(frame.color[i].a, 1.0 - std::exp(-sigma * length), tolerance) << x << ' ' << y;
                    ASSERT_EQ(frame.depth[i] == 1.0f, frame.color[i].a == 0.0f) << x << ' ' << y;
                    if (frame.color[i].a > 0.0f) {
                        ASSERT_LE(frame.depth[i], view.sceneDepth->depth[i]) << x << ' ' << y;
                    }
                    if (t0 < t1)
                        ++(end <= t0 ? hidden : end >= t1 ? untouched : cut);
                }
        }
    EXPECT_GT(std::min({cut, untouched, hidden}), 50) << "the planes are in no place that would test all cases";
}

/// Data of three levels in [0, 32]^3, translucent and opaque isosurfaces, and a mesh.
Scene crowded(bool withMesh)
{
    const auto bricks = threeLevels(5);
    Scene scene = sceneOf(bricks, fieldOf(bricks, waves), colorful({-1.0f, 1.0f}));
    scene.surfaces = {{-0.3f, {1, 0.5f, 0}, 0.4f}, {0.6f, {0, 0.4f, 1}, 1.0f}};
    const std::vector<TriangleMesh> mesh{
        {{{3, 4, 11}, {29, 2, 17}, {13, 31, 24}, {6, 5, 29}}, {{0, 1, 2}, {0, 2, 3}, {1, 2, 3}}}};
    if (withMesh)
        scene.triangles = std::make_shared<TriangleScene>(mesh);
    return scene;
}

View crowdedView()
{
    const Corners screen = cornersOf({16, 16, 16}, glm::rotate(mat4d(1.0), -0.5, vec3d(0.2, 1.0, 0.3)), 40.0, 34.0);
    const vec3d across = screen.lowerRight - screen.lowerLeft, up = screen.upperRight - screen.lowerRight;
    const vec3d towards = glm::normalize(glm::cross(across, up));
    return viewOf(screen, vec3d(16.0) + 40.0 * towards + 0.3 * across, 40, 34, 8.0, 100.0);
}

TEST_P(SceneDepthOf, NothingThereChangesNoBit)
{
    const Scene scene = crowded(true);
    const View view = crowdedView();
    const std::size_t pixels = std::size_t(view.window.width) * view.window.height;
    const Frame without = renderOne(scene, view, settings());
    for (const float nothing : {1.0f, std::numeric_limits<float>::quiet_NaN()}) {
        const Frame with = renderOne(scene, withDepth(view, std::vector<float>(pixels, nothing)), settings());
        EXPECT_EQ(with.color, without.color);
        EXPECT_EQ(with.depth, without.depth);
    }
}

TEST_P(SceneDepthOf, TheDepthOfAMeshAndItsColourBehindGiveThePictureOfTheMesh)
{
    const View view = crowdedView();
    const Frame want = renderOne(crowded(true), view, settings());
    Scene meshAlone = crowded(true);
    meshAlone.surfaces.clear();
    meshAlone.transferFunction = extinctionRamp({-1.0f, 1.0f}, 0.0f, 0.0f);
    const Frame mesh = renderOne(meshAlone, view, settings());
    const Frame found = renderOne(crowded(false), withDepth(view, mesh.depth), settings());
    int onMesh = 0, through = 0;
    for (std::size_t i = 0; i < found.color.size(); ++i) {
        const vec4f over = found.color[i] + (1.0f - found.color[i].a) * mesh.color[i];
        for (int c = 0; c < 4; ++c)
            ASSERT_NEAR(over[c], want.color[i][c], 1e-5) << i << ' ' << c;
        onMesh += mesh.color[i].a > 0.0f;
        through += mesh.color[i].a > 0.0f && found.color[i].a > 0.05f && found.color[i].a < 0.95f;
    }
    EXPECT_GT(onMesh, 200);
    EXPECT_GT(through, 100) << "the mesh is hardly seen through anything";
}

INSTANTIATE_TEST_SUITE_P(Methods, SceneDepthOf,
                         testing::Values(Method::bounded, Method::fixed, Method::midpoint, Method::bracket,
                                         Method::preintegrated, Method::reference),
                         [](const auto& info) { return methodNames[std::size_t(info.param)]; });

TEST(SceneDepth, TakesMeshesAndSurfacesAwayThatLieBehindIt)
{
    const auto bricks = cubeOfBricks(vec3i(0), 16, 8);
    Scene scene =
        sceneOf(bricks, fieldOf(bricks, [](const vec3d& p) { return p.x; }), extinctionRamp({0.0f, 16.0f}, 0.0f, 0.0f));
    scene.surfaces = {{5.0f, {1, 0, 0}, 0.5f}};
    const std::vector<TriangleMesh> meshes{{{{10, -50, -50}, {10, 50, -50}, {10, 0, 90}}, {{0, 1, 2}}}};
    scene.triangles = std::make_shared<TriangleScene>(meshes);
    const View view = lookAlong({-4, 7.25, 8.5}, 0, 1.0);
    const auto at = [&](double x) { return renderOne(scene, withPlane(view, {{1, 0, 0}, x}), settingsOf(0.5f)); };
    EXPECT_EQ(at(4.0).color[0], vec4f(0.0f));
    EXPECT_EQ(at(4.0).depth[0], 1.0f);
    EXPECT_NEAR(at(7.0).color[0].a, 0.5, 1e-6);
    EXPECT_NEAR(at(12.0).color[0].a, 1.0, 1e-6);
}

TEST(SceneDepth, OfTheWholeScreenServesItsTiles)
{
    const Scene scene = crowded(false);
    const View view = withPlane(crowdedView(), {{0.1, 0.2, 1.0}, 18.0});
    const Frame whole = renderOne(scene, view, settingsOf(0.5f));
    const View tile = tileOf(view, {13, 7, 18, 20});
    const Frame part = renderOne(scene, tile, settingsOf(0.5f));
    for (int y = 0; y < part.height; ++y)
        for (int x = 0; x < part.width; ++x) {
            ASSERT_EQ(part.color[part.index(x, y)], whole.color[whole.index(x + 13, y + 7)]);
            ASSERT_EQ(part.depth[part.index(x, y)], whole.depth[whole.index(x + 13, y + 7)]);
        }
}

TEST(SceneDepth, ThatDoesNotCoverTheViewIsRefused)
{
    const Scene scene = crowded(false);
    const View view = crowdedView();
    EXPECT_THROW(renderOne(scene, withDepth(view, std::vector<float>(40 * 33, 0.5f)), settingsOf(0.5f)), Error);
    const auto small = SceneDepth{{0, 0, 39, 34}, std::vector<float>(39 * 34, 0.5f)};
    View uncovered = view;
    uncovered.sceneDepth = std::make_shared<SceneDepth>(small);
    EXPECT_THROW(renderOne(scene, uncovered, settingsOf(0.5f)), Error);
}

} // namespace
} // namespace brickwall
