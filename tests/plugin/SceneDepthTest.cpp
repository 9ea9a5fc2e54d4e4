// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Opaque geometry of the scene before, in and behind a volume, against the same triangles in the renderer.
#include "NodeViewer.h"
#include "OpaqueBoxes.h"
#include "TestDisplay.h"
#include "TestRigs.h"

#include <gtest/gtest.h>

#include <osg/DisplaySettings>
#include <osg/Geometry>
#include <osg/Multisample>
#include <osg/Texture2D>

#include <atomic>
#include <cmath>

namespace brickwall::test {
namespace {

constexpr PixelRect whole{0, 0, NodeViewer::width, NodeViewer::height};

struct SceneWithBoxes
{
    osg::ref_ptr<VolumeNode> node = cubeNode();
    osg::ref_ptr<osg::Group> root = new osg::Group;

    explicit SceneWithBoxes(const std::vector<TriangleMesh>& meshes)
    {
        root->addChild(node); // before the geometry: order in the graph does not matter
        for (const TriangleMesh& mesh : meshes)
            root->addChild(drawn(mesh));
    }
};

/// Until frames that show something newer would have come.
void settle(NodeViewer& viewer, const VolumeNode& node)
{
    for (int i = 0; i < 5; ++i)
        viewer.viewer.frame();
    viewer.settle(node);
}

/// In front of the cube, inside of it, half in it, and behind.
const std::vector<vec3d> places{{0.3, -0.2, 3.2}, {0.4, 0.3, 0.2}, {1.9, 0.5, 0.8}, {-0.6, 0.1, -3.5}};

TEST(SceneDepthOfNode, GeometryBeforeInAndBehindTheVolumeIsWhereTheRendererHasIt)
{
    BRICKWALL_NEEDS_DISPLAY();
    int hidden = 0, within = 0, farthestFromLight = 0;
    for (const vec3d& place : places) {
        const std::vector<TriangleMesh> box{boxAt(place)};
        const SceneWithBoxes scene(box);
        NodeViewer shown(scene.root);
        settle(shown, *scene.node);
        const Reference reference(shown.view(), box);
        const osg::ref_ptr<osg::Image> picture = shown.picture();
        expectPicture(*picture, whole, [&](int x, int y) { return reference.inWindow(x, y, shown.background()); });
        for (int y = 0; y < NodeViewer::height; ++y)
            for (int x = 0; x < NodeViewer::width; ++x) {
                const float opacity = reference.frontOf(x, y).a;
                hidden += reference.isMesh(x, y) && opacity == 0.0f;
                within += reference.isMesh(x, y) && opacity > 0.1f && opacity < 0.9f;
                const Rgb found = pixel(*picture, x, y), light = reference.ofLight(x, y, shown.background());
                for (int i = 0; i < 3; ++i)
                    farthestFromLight = std::max(farthestFromLight, std::abs(found[i] - light[i]));
            }
    }
    EXPECT_GT(hidden, 100);
    EXPECT_GT(within, 100);
    // A window blends displayed values where the renderer blends light; nothing else is different.
    RecordProperty("farthestFromLight", farthestFromLight);
    EXPECT_LT(farthestFromLight, 50);
}

// One depth per pixel cannot say that a thing is in the middle of what is seen through it.
TEST(SceneDepthOfNode, WithoutItGeometryInsideIsBeforeAllOfAPixelOrBehind)
{
    BRICKWALL_NEEDS_DISPLAY();
    const std::vector<TriangleMesh> box{boxAt(places[1])};
    const SceneWithBoxes scene(box);
    scene.node->setSceneDepth(false);
    NodeViewer shown(scene.root);
    settle(shown, *scene.node);
    const Reference reference(shown.view(), box);
    const osg::ref_ptr<osg::Image> picture = shown.picture();
    int wrong = 0;
    for (int y = 0; y < NodeViewer::height; ++y)
        for (int x = 0; x < NodeViewer::width; ++x)
            wrong += std::abs(pixel(*picture, x, y)[0] - reference.inWindow(x, y, shown.background())[0]) > 10;
    EXPECT_GT(wrong, 20);
    scene.node->setSceneDepth(true);
    settle(shown, *scene.node);
    expectPicture(*shown.picture(), whole, [&](int x, int y) { return reference.inWindow(x, y, shown.background()); });
}

TEST(SceneDepthOfNode, EachEyeOfACameraHasItsOwn)
{
    BRICKWALL_NEEDS_DISPLAY();
    const std::vector<TriangleMesh> box{boxAt(places[1])};
    const SceneWithBoxes scene(box);
    NodeViewer shown(scene.root, osg::DisplaySettings::HORIZONTAL_SPLIT);
    settle(shown, *scene.node);
    constexpr int half = NodeViewer::width / 2;
    const Reference left(shown.eyeView(-1, half, NodeViewer::height), box);
    const Reference right(shown.eyeView(1, half, NodeViewer::height), box);
    EXPECT_GT(difference(left.front, right.front), 0.1);
    expectPicture(*shown.picture(), whole,
                  [&](int x, int y) { return (x < half ? left : right).inWindow(x % half, y, shown.background()); });
}

TEST(SceneDepthOfNode, UnderEveryThreadingModel)
{
    BRICKWALL_NEEDS_DISPLAY();
    const std::vector<TriangleMesh> box{boxAt(places[1])};
    for (const auto threads :
         {osgViewer::ViewerBase::DrawThreadPerContext, osgViewer::ViewerBase::CullDrawThreadPerContext,
          osgViewer::ViewerBase::CullThreadPerCameraDrawThreadPerContext}) {
        const SceneWithBoxes scene(box);
        NodeViewer shown(scene.root, -1, threads);
        settle(shown, *scene.node);
        const Reference reference(shown.view(), box);
        expectPicture(*shown.picture(), whole,
                      [&](int x, int y) { return reference.inWindow(x, y, shown.background()); });
    }
}

/// Counts what is asked for, and keeps what the latest view had of the scene.
struct Listener
{
    std::atomic<int> calls = 0;
    std::shared_ptr<const SceneDepth> depth;

    osg::ref_ptr<VolumeNode> node()
    {
        osg::ref_ptr<VolumeNode> node = new VolumeNode;
        const auto listen = [this](std::span<const View> views, Progress&) {
            std::vector<Frame> frames;
            for (const View& view : views)
                frames.push_back(patternFrame(view, 0));
            depth = views.front().sceneDepth;
            ++calls;
            return frames;
        };
        node->show(listen, Box3d{vec3d(-3.0), vec3d(3.0)});
        return node;
    }
};

TEST(SceneDepthOfNode, WhatMovesBeforeARestingCameraIsFollowedAndRestIsIdle)
{
    BRICKWALL_NEEDS_DISPLAY();
    Listener listener;
    const osg::ref_ptr<VolumeNode> node = listener.node();
    const osg::ref_ptr<osg::Geometry> box = drawn(boxAt({0, 0, 0}));
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(node);
    root->addChild(box);
    NodeViewer shown(root);
    settle(shown, *node);
    ASSERT_TRUE(listener.depth);
    float before = 1.0f;
    for (int step = 0; step < 3; ++step) {
        const int calls = listener.calls;
        for (int i = 0; i < 100; ++i)
            shown.viewer.frame();
        EXPECT_EQ(listener.calls, calls) << "nothing has changed";
        EXPECT_TRUE(node->settled());
        const float middle = listener.depth->depth[std::size_t(NodeViewer::height / 2) * NodeViewer::width + 32];
        EXPECT_LT(middle, before) << "the box has come nearer";
        before = middle;
        box->setVertexArray(drawn(boxAt({0, 0, 0.2 * (step + 1)}))->getVertexArray());
        box->dirtyBound();
        for (int i = 0; i < 3; ++i)
            shown.viewer.frame();
        shown.settle(*node);
        EXPECT_EQ(listener.calls, calls + 1) << "one picture for one move";
    }
}

TEST(SceneDepthOfNode, AnEmptySceneIsNoDepthAtAll)
{
    BRICKWALL_NEEDS_DISPLAY();
    Listener listener;
    const osg::ref_ptr<VolumeNode> node = listener.node();
    NodeViewer shown(node);
    settle(shown, *node);
    EXPECT_FALSE(listener.depth);
}

/// Whether what is drawn has several samples per pixel.
struct SamplesSeen : osg::Drawable::DrawCallback
{
    mutable std::atomic<int> buffers = 0;

    void drawImplementation(osg::RenderInfo& info, const osg::Drawable* drawable) const override
    {
        GLint found = 0;
        glGetIntegerv(GL_SAMPLE_BUFFERS_ARB, &found);
        buffers = found;
        drawable->drawImplementation(info);
    }
};

TEST(SceneDepthOfNode, AFramebufferWithSeveralSamplesIsShownWithoutIt)
{
    BRICKWALL_NEEDS_DISPLAY();
    Listener listener;
    const osg::ref_ptr<VolumeNode> node = listener.node();
    osg::ref_ptr<osg::Group> root = new osg::Group;
    root->addChild(node);
    const osg::ref_ptr<osg::Geometry> box = drawn(boxAt({0, 0, 0}));
    const osg::ref_ptr<SamplesSeen> samples = new SamplesSeen;
    box->setDrawCallback(samples);
    root->addChild(box);
    NodeViewer shown(root);
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setTextureSize(NodeViewer::width, NodeViewer::height);
    texture->setInternalFormat(GL_RGBA);
    osg::Camera& camera = *shown.viewer.getCamera();
    camera.setRenderTargetImplementation(osg::Camera::FRAME_BUFFER_OBJECT);
    camera.attach(osg::Camera::COLOR_BUFFER, texture, 0, 0, false, 4, 4);
    settle(shown, *node);
    EXPECT_GT(listener.calls, 0);
    if (samples->buffers == 0)
        GTEST_SKIP() << "this OpenGL has no framebuffers with several samples";
    EXPECT_FALSE(listener.depth);
}

} // namespace
} // namespace brickwall::test
