// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/scene/SceneSetup.h"
#include "brickwall/core/shade/Srgb.h"
#include "brickwall/tests/common/ErrorOf.h"
#include "brickwall/tests/common/ScratchFolder.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include <fstream>
#include <numbers>

namespace brickwall::test {
namespace {

std::string objFile()
{
    const std::string path = (scratchFolder() / "t.obj").string();
    std::ofstream(path) << "v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n";
    return path;
}

TEST(SceneMeshes, AreScaledMovedAndPainted)
{
    SceneOptions options;
    options.meshes = {objFile()};
    options.meshScale = 0.5;
    options.meshOffset = {10.0, 20.0, 30.0};
    options.meshColor = {1.0, 0.5, 0.0};
    Progress silent;
    const auto meshes = readMeshes(options, silent);
    ASSERT_EQ(meshes.size(), 1u);
    EXPECT_EQ(meshes[0].vertices, (std::vector<vec3f>{{10, 20, 30}, {11, 20, 30}, {10, 21, 30}}));
    EXPECT_EQ(meshes[0].color, vec3f(1.0f, linearFromSrgb(0.5f), 0.0f));
}

TEST(SceneMeshes, EndRaysInTheirColour)
{
    SceneOptions options;
    options.data = "sample:wake:60k";
    options.volume = "off";
    options.meshes = {objFile()};
    options.meshOffset = {3.0, 0.0, 0.0};
    options.meshColor = {1.0, 0.0, 0.0};
    Progress silent;
    const Executor serial(1);
    const PreparedScene prepared = prepareScene(options, serial, silent);
    const View view = viewOfCamera("v", {3.5, 0.5, 8.0}, {3.5, 0.5, 0.0}, {0, 1, 0}, 10.0, 1, 1, 0.1, 100.0);
    const Frame frame = Renderer(prepared.scene, serial).render({&view, 1}, {}, silent).front();
    EXPECT_EQ(frame.color[0], vec4f(1, 0, 0, 1)) << "seen along its normal";
}

TEST(SceneMeshes, TheBallOfTheExamplesIsRound)
{
    SceneOptions options;
    options.meshes = {BRICKWALL_SOURCE_DIR "/examples/ball.obj"};
    Progress silent;
    const auto meshes = readMeshes(options, silent);
    ASSERT_EQ(meshes.size(), 1u);
    double volume = 0.0;
    for (const vec3i& t : meshes[0].triangles) {
        const vec3d a(meshes[0].vertices[t.x]), b(meshes[0].vertices[t.y]), c(meshes[0].vertices[t.z]);
        volume += glm::dot(a, glm::cross(b, c)) / 6.0;
        EXPECT_NEAR(glm::length(a), 0.5, 1e-5);
    }
    EXPECT_NEAR(volume, std::numbers::pi / 6.0, 0.005) << "closed, and all triangles turn the same way";
}

TEST(SceneMeshes, ThatCannotBeReadEndThePreparation)
{
    SceneOptions options;
    options.data = "sample:wake:60k";
    options.meshes = {"/no/such/body.stl"};
    Progress silent;
    EXPECT_NE(errorOf([&] { prepareScene(options, Executor(1), silent); }).find("body.stl"), std::string::npos);
}

} // namespace
} // namespace brickwall::test
