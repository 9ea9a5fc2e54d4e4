// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "CubeScene.h"
#include "NodeViewer.h"
#include "TestDisplay.h"
#include "TestRigs.h"

#include "brickwall/tests/common/ErrorOf.h"

#include <gtest/gtest.h>

#include <osg/DisplaySettings>
#include <osg/MatrixTransform>

#include <atomic>
#include <thread>

namespace brickwall::test {
namespace {

constexpr PixelRect whole{0, 0, NodeViewer::width, NodeViewer::height};

/// Counts what is asked for; every frame is opaque and green at half the depth range.
struct Counter
{
    std::atomic<int> calls = 0;
    std::atomic<int> views = 0; ///< of the latest call

    FrameMaker maker()
    {
        return [this](std::span<const View> wanted, Progress&) {
            std::vector<Frame> frames;
            for (const View& view : wanted)
                frames.push_back(patternFrame(view, 0));
            views = int(wanted.size());
            ++calls;
            return frames;
        };
    }
};

const Box3d unitBox{vec3d(-1.0), vec3d(1.0)};

osg::ref_ptr<VolumeNode> nodeOf(Counter& counter)
{
    osg::ref_ptr<VolumeNode> node = new VolumeNode;
    node->show(counter.maker(), unitBox);
    return node;
}

TEST(VolumeNode, ShowsWhatTheRendererMakesForTheCamerasMatrices)
{
    BRICKWALL_NEEDS_DISPLAY();
    for (const auto threads : {osgViewer::ViewerBase::SingleThreaded, osgViewer::ViewerBase::DrawThreadPerContext,
                               osgViewer::ViewerBase::CullDrawThreadPerContext,
                               osgViewer::ViewerBase::CullThreadPerCameraDrawThreadPerContext}) {
        const osg::ref_ptr<VolumeNode> node = cubeNode();
        NodeViewer shown(node, -1, threads);
        shown.settle(*node);
        const Frame frame = renderOne(cubeScene(), shown.view(), RenderSettings{});
        ASSERT_GT(frame.color[frame.index(32, 24)].a, 0.2f);
        expectPicture(*shown.picture(), whole, [&](int x, int y) { return composed(frame, x, y, shown.background()); });
    }
}

TEST(VolumeNode, StandsWhereItsTransformsSay)
{
    BRICKWALL_NEEDS_DISPLAY();
    const osg::Matrixd own = osg::Matrixd::rotate(0.4, osg::Vec3d(0, 1, 0));
    const osg::Matrixd above = osg::Matrixd::scale(0.5, 0.5, 0.5) * osg::Matrixd::translate(1, 0.5, 0);
    const osg::ref_ptr<VolumeNode> node = cubeNode();
    node->setTransform(own);
    osg::ref_ptr<osg::MatrixTransform> placed = new osg::MatrixTransform(above);
    placed->addChild(node);
    EXPECT_NEAR(placed->getBound().center().x(), 1.0, 1e-6);
    NodeViewer shown(placed);
    shown.settle(*node);
    const Frame frame = renderOne(cubeScene(), shown.view(own * above), RenderSettings{});
    expectPicture(*shown.picture(), whole, [&](int x, int y) { return composed(frame, x, y, shown.background()); });
}

TEST(VolumeNode, FramesGoOnWhileARenderingTakesSeconds)
{
    BRICKWALL_NEEDS_DISPLAY();
    std::atomic<bool> released = false, started = false;
    osg::ref_ptr<VolumeNode> node = new VolumeNode;
    node->show(
        [&](std::span<const View> views, Progress& progress) {
            started = true;
            while (!released) {
                progress.check();
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
            }
            std::vector<Frame> frames;
            for (const View& view : views)
                frames.push_back(patternFrame(view, 0));
            return frames;
        },
        unitBox);
    for (const auto threads : {osgViewer::ViewerBase::SingleThreaded, osgViewer::ViewerBase::DrawThreadPerContext}) {
        released = started = false;
        NodeViewer shown(node, -1, threads);
        // If a traversal waited for the renderer, it would wait forever.
        for (int i = 0; i < 100 || !started; ++i)
            shown.viewer.frame();
        EXPECT_FALSE(node->settled());
        released = true;
        shown.settle(*node);
    }
}

TEST(VolumeNode, RendersNothingWhileNothingChanges)
{
    BRICKWALL_NEEDS_DISPLAY();
    Counter counter;
    const osg::ref_ptr<VolumeNode> node = nodeOf(counter);
    NodeViewer shown(node);
    shown.settle(*node);
    // Once more at most, since near and far were not known in the very first frame.
    for (int i = 0; i < 5; ++i)
        shown.viewer.frame();
    shown.settle(*node);
    const int calls = counter.calls;
    EXPECT_LE(calls, 2);
    for (int i = 0; i < 100; ++i)
        shown.viewer.frame();
    EXPECT_EQ(counter.calls, calls);
    shown.viewer.getCamera()->setViewMatrix(shown.viewer.getCamera()->getViewMatrix() *
                                            osg::Matrixd::translate(0.1, 0, 0));
    shown.viewer.frame();
    shown.settle(*node);
    EXPECT_GT(counter.calls, calls);
}

TEST(VolumeNode, HasAViewForEveryPlaceInTheGraphAndEveryCamera)
{
    BRICKWALL_NEEDS_DISPLAY();
    Counter counter;
    const osg::ref_ptr<VolumeNode> node = nodeOf(counter);
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    for (const double x : {-2.0, 2.0}) {
        osg::ref_ptr<osg::MatrixTransform> place = new osg::MatrixTransform(osg::Matrixd::translate(x, 0, 0));
        place->addChild(node);
        scene->addChild(place);
    }
    NodeViewer shown(scene);
    shown.settle(*node);
    EXPECT_EQ(counter.views, 2);

    osg::ref_ptr<osg::Camera> second = new osg::Camera;
    second->setGraphicsContext(shown.viewer.getCamera()->getGraphicsContext());
    second->setViewport(0, 0, 20, 20);
    second->setRenderOrder(osg::Camera::POST_RENDER);
    shown.viewer.addSlave(second);
    for (int i = 0; i < 5; ++i)
        shown.viewer.frame();
    shown.settle(*node);
    EXPECT_EQ(counter.views, 4);

    second->setCullMask(0);
    for (int i = 0; i < 20; ++i)
        shown.viewer.frame();
    shown.settle(*node);
    EXPECT_EQ(counter.views, 2) << "poses that no camera sees any more are forgotten";
}

// SceneView draws both eyes through one camera, with matrices of its own for each.
TEST(VolumeNode, TellsTheEyesOfOneCameraApart)
{
    BRICKWALL_NEEDS_DISPLAY();
    const osg::ref_ptr<VolumeNode> node = cubeNode();
    NodeViewer shown(node, osg::DisplaySettings::HORIZONTAL_SPLIT);
    shown.settle(*node);
    for (int i = 0; i < 5; ++i)
        shown.viewer.frame();
    shown.settle(*node);
    constexpr int half = NodeViewer::width / 2;
    const Frame left = renderOne(cubeScene(), shown.eyeView(-1, half, NodeViewer::height), RenderSettings{});
    const Frame right = renderOne(cubeScene(), shown.eyeView(1, half, NodeViewer::height), RenderSettings{});
    EXPECT_GT(difference(left, right), 0.1);
    expectPicture(*shown.picture(), whole,
                  [&](int x, int y) { return composed(x < half ? left : right, x % half, y, shown.background()); });
}

// Each viewer counts its frames from 0: a camera of an older one must not be taken for one that was just seen.
TEST(VolumeNode, ForgetsTheCamerasOfAViewerThatIsGone)
{
    BRICKWALL_NEEDS_DISPLAY();
    Counter counter;
    const osg::ref_ptr<VolumeNode> node = nodeOf(counter);
    for (int round = 0; round < 2; ++round) {
        NodeViewer shown(node);
        for (int i = 0; i < 50; ++i)
            shown.viewer.frame();
        shown.settle(*node);
        EXPECT_EQ(counter.views, 1);
    }
}

TEST(VolumeNode, NewDataInAnotherPlaceDoNotShowThePictureOfTheOldOne)
{
    BRICKWALL_NEEDS_DISPLAY();
    Counter counter;
    const osg::ref_ptr<VolumeNode> node = nodeOf(counter);
    osg::ref_ptr<osg::Group> scene = new osg::Group;
    scene->addChild(node);
    NodeViewer shown(scene);
    shown.settle(*node);
    scene->removeChild(node);
    for (int i = 0; i < 3; ++i)
        shown.viewer.frame();
    expectPicture(*shown.picture(), whole, [](int, int) { return Rgb{51, 51, 102}; });
    osg::ref_ptr<osg::MatrixTransform> place = new osg::MatrixTransform(osg::Matrixd::translate(1, 0, 0));
    place->addChild(node);
    scene->addChild(place);
    for (int i = 0; i < 20; ++i)
        shown.viewer.frame();
    shown.settle(*node);
    EXPECT_EQ(counter.views, 1);
}

TEST(VolumeNode, OpaqueGeometryInFrontHidesItAndBehindIsSeenThroughIt)
{
    BRICKWALL_NEEDS_DISPLAY();
    for (const float z : {3.0f, -3.0f}) {
        const osg::ref_ptr<VolumeNode> node = cubeNode();
        osg::ref_ptr<osg::Group> scene = new osg::Group;
        scene->addChild(node);
        scene->addChild(square({0, 0, z}, {1, 0, 0, 1}));
        NodeViewer shown(scene);
        shown.settle(*node);
        for (int i = 0; i < 5; ++i)
            shown.viewer.frame();
        shown.settle(*node);
        const Rgb middle = pixel(*shown.picture(), 32, 24);
        if (z > 0.0f) {
            EXPECT_EQ(middle, (Rgb{255, 0, 0}));
        } else {
            const Frame frame = renderOne(cubeScene(), shown.view(), RenderSettings{});
            const vec4f color = frame.color[frame.index(32, 24)];
            const Rgb overBlue = composed(frame, 32, 24, shown.background());
            // Another background: what shines through is red instead of the blue.
            for (int i = 0; i < 3; ++i) {
                const double blue = i == 2 ? 102.0 : 51.0, red = i == 0 ? 255.0 : 0.0;
                EXPECT_NEAR(middle[i], overBlue[i] + (1.0 - color.a) * (red - blue), 2.5) << i;
            }
        }
    }
}

TEST(VolumeNode, ACloneSharesTheDataAndHasPropertiesOfItsOwn)
{
    BRICKWALL_NEEDS_DISPLAY();
    const osg::ref_ptr<VolumeNode> node = cubeNode();
    node->setTransform(osg::Matrixd::translate(5, 0, 0));
    const osg::ref_ptr<VolumeNode> clone = osg::clone(node.get(), osg::CopyOp::DEEP_COPY_ALL);
    EXPECT_EQ(clone->transform(), node->transform());
    EXPECT_EQ(clone->getBound().center(), node->getBound().center());
    clone->setTransform(osg::Matrixd());
    EXPECT_FALSE(node->transform().isIdentity());
    NodeViewer shown(clone);
    shown.settle(*clone);
    const Frame frame = renderOne(cubeScene(), shown.view(), RenderSettings{});
    expectPicture(*shown.picture(), whole, [&](int x, int y) { return composed(frame, x, y, shown.background()); });
}

TEST(VolumeNode, WithoutDataItHasNoBoundsAndShowsNothing)
{
    BRICKWALL_NEEDS_DISPLAY();
    const osg::ref_ptr<VolumeNode> node = new VolumeNode;
    EXPECT_FALSE(node->getBound().valid());
    SceneOptions absent;
    absent.data = "/no/such/file.exa";
    Progress silent;
    EXPECT_NE(errorOf([&] { node->load(absent, silent); }), "");
    NodeViewer shown(node);
    expectPicture(*shown.picture(), whole, [](int, int) { return Rgb{51, 51, 102}; });
}

} // namespace
} // namespace brickwall::test
