// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// A volume in the scene whose frame rate is held.
#include "CubeScene.h"
#include "NodeViewer.h"
#include "TestDisplay.h"
#include "TestRigs.h"

#include <gtest/gtest.h>

#include <osg/Group>

#include <chrono>
#include <limits>
#include <optional>
#include <string>
#include <utility>

namespace brickwall::test {
namespace {

using Clock = std::chrono::steady_clock;

constexpr PixelRect whole{0, 0, NodeViewer::width, NodeViewer::height};
constexpr double fps = 60.0;

/// A cube with a wall through it, which no machine renders 60 times a second as accurately as it is wanted.
struct SlowCube
{
    explicit SlowCube(std::optional<double> heldFps)
    {
        SceneOptions options;
        options.tolerance = 1e-6;
        node->setOptions(options);
        node->setFps(heldFps);
        group->addChild(square({0.0f, 0.0f, 0.5f}, {0.9f, 0.3f, 0.1f, 1.0f}, 1.0f));
        group->addChild(node);
    }
    void turn(double angle) { node->setTransform(osg::Matrixd::rotate(angle, osg::Vec3d(0, 1, 0))); }
    bool isCoarse() const
    {
        const std::string text = node->frameTime();
        return !text.empty() && text.find("error up to 1e-06 (") == std::string::npos;
    }

    const osg::ref_ptr<VolumeNode> node = cubeNode();
    const osg::ref_ptr<osg::Group> group = new osg::Group;
};

/// Such a cube in a window, held at 60 frames per second and turned until its pictures are coarse.
class VolumeNodePaceCube : public ::testing::Test
{
protected:
    void SetUp() override
    {
        BRICKWALL_NEEDS_DISPLAY();
        cube.emplace(fps);
        shown.emplace(cube->group);
        EXPECT_EQ(cube->node->frameTime(), "");
        for (const auto start = Clock::now(); !cube->isCoarse() && Clock::now() - start < std::chrono::minutes(3);)
            for (int i = 0; i < 10; ++i) {
                cube->turn(angle += 0.01);
                shown->viewer.frame();
            }
        EXPECT_TRUE(cube->isCoarse()) << cube->node->frameTime();
    }
    /// As of another node with this transfer function and no frame rate, from the same place.
    void expectTheOptionsPicture(std::optional<TransferFunction> tf = {})
    {
        shown->settle(*cube->node);
        EXPECT_FALSE(cube->isCoarse());
        const osg::ref_ptr<osg::Image> held = shown->picture();
        SlowCube other({});
        other.node->setTransferFunction(std::move(tf));
        other.turn(angle);
        shown->viewer.setSceneData(other.group);
        shown->settle(*other.node);
        const osg::ref_ptr<osg::Image> wanted = shown->picture();
        expectPicture(*held, whole, [&](int x, int y) { return pixel(*wanted, x, y); });
    }

    std::optional<SlowCube> cube;
    std::optional<NodeViewer> shown;
    double angle = 0.0;
};

TEST_F(VolumeNodePaceCube, WhatMovesIsHeldAndWhatRestsIsRefinedUntilItIsAsTheOptionsSay)
{
    EXPECT_FALSE(cube->node->settled());
    shown->settle(*cube->node);
    EXPECT_NE(cube->node->frameTime().find("at rest"), std::string::npos) << cube->node->frameTime();
    expectTheOptionsPicture();
}

TEST_F(VolumeNodePaceCube, GivenUpItIsRenderedAsTheOptionsSayAtOnce)
{
    for (int i = 0; i < 3; ++i)
        shown->viewer.frame(); // the last movement has been asked for, and nothing else would ask again
    cube->node->setFps({});
    EXPECT_EQ(cube->node->frameTime(), "");
    expectTheOptionsPicture();
}

TEST_F(VolumeNodePaceCube, InAnotherLookIsHeldToo)
{
    Scene scene = cubeScene();
    scene.transferFunction.opacityScale = 0.3f;
    cube->node->setTransferFunction(scene.transferFunction);
    shown->viewer.frame();
    EXPECT_FALSE(cube->node->settled());
    expectTheOptionsPicture(scene.transferFunction);
}

TEST(VolumeNodePace, FramesPerSecondStayWithinTheirLimitsAndAreCopied)
{
    const osg::ref_ptr<VolumeNode> node = new VolumeNode;
    EXPECT_EQ(node->fps(), std::nullopt);
    node->setFps(1000.0);
    EXPECT_EQ(node->fps(), 60.0);
    node->setFps(std::numeric_limits<double>::quiet_NaN());
    EXPECT_EQ(node->fps(), 60.0);
    node->setFps(-1.0);
    EXPECT_EQ(node->fps(), 5.0);
    const osg::ref_ptr<VolumeNode> clone = osg::clone(node.get(), osg::CopyOp::DEEP_COPY_ALL);
    EXPECT_EQ(clone->fps(), 5.0);
}

} // namespace
} // namespace brickwall::test
