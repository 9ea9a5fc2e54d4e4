// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// The properties of a volume in the scene.
#include "CubeScene.h"
#include "NodeViewer.h"
#include "TestDisplay.h"
#include "TestRigs.h"

#include "brickwall/tests/common/ErrorOf.h"

#include <gtest/gtest.h>

namespace brickwall::test {
namespace {

constexpr PixelRect whole{0, 0, NodeViewer::width, NodeViewer::height};

TEST(VolumeNode, ChangesOfPropertiesAreCountedAndShown)
{
    BRICKWALL_NEEDS_DISPLAY();
    const osg::ref_ptr<VolumeNode> node = cubeNode();
    NodeViewer shown(node);
    shown.settle(*node);
    const unsigned look = node->lookStamp(), data = node->dataStamp();
    Scene scene = cubeScene();
    scene.transferFunction.opacityScale = 0.3f;
    node->setTransferFunction(scene.transferFunction);
    node->setShading(Shading::off);
    EXPECT_EQ(node->lookStamp(), look + 2);
    EXPECT_EQ(node->dataStamp(), data);
    shown.viewer.frame();
    EXPECT_FALSE(node->settled());
    shown.settle(*node);
    RenderSettings settings;
    settings.shading = Shading::off;
    const Frame frame = renderOne(scene, shown.view(), settings);
    expectPicture(*shown.picture(), whole, [&](int x, int y) { return composed(frame, x, y, shown.background()); });
    EXPECT_NE(errorOf([&] { node->setTolerance(0.0); }), "");
    EXPECT_EQ(node->lookStamp(), look + 2);
}

/// Moves what was loaded to the origin, 3 in radius.
osg::Matrixd centred(VolumeNode& node)
{
    const osg::BoundingSphere bounds = node.getBound();
    const osg::Matrixd nodeFromModel =
        osg::Matrixd::translate(-bounds.center()) * osg::Matrixd::scale(osg::Vec3d(1, 1, 1) * (3.0 / bounds.radius()));
    node.setTransform(nodeFromModel);
    return nodeFromModel;
}

TEST(VolumeNode, PlanesClipAndLightAreChangedWithoutReading)
{
    BRICKWALL_NEEDS_DISPLAY();
    SceneOptions options;
    options.data = "sample:wake:60k";
    Progress silent;
    const osg::ref_ptr<VolumeNode> node = new VolumeNode;
    node->load(options, silent);
    const osg::Matrixd nodeFromModel = centred(*node);
    NodeViewer shown(node);
    shown.settle(*node);
    const unsigned data = node->dataStamp(), look = node->lookStamp();

    ClipRegion clip;
    clip.planes = {{{0, 0, -1}, -0.5}};
    clip.sphere = Sphere{{2.0, 0.0, 0.0}, 2.5};
    node->setPlanes({{{0, 0, 1}, 0.0}, {{1, 0, 0}, 1.0}}, 0.7);
    node->setClip(clip);
    node->setLight(Light{{0.2, 1.0, 0.5}, 0.3f});
    node->setSpecular({0.5f, 8.0f});
    node->setAmbientOcclusion(AmbientOcclusion{1.5, 4});
    EXPECT_EQ(node->lookStamp(), look + 5);
    EXPECT_EQ(node->dataStamp(), data);
    Scene scene = prepareScene(options, Executor(1), silent).scene;
    scene.planes = {{{{0, 0, 1}, 0.0}, 0.7f}, {{{1, 0, 0}, 1.0}, 0.7f}};
    scene.clip = clip;
    RenderSettings settings;
    settings.light = Light{{0.2, 1.0, 0.5}, 0.3f};
    settings.specular = {0.5f, 8.0f};
    settings.ambientOcclusion = AmbientOcclusion{1.5, 4};
    const auto expectShown = [&] {
        shown.settle(*node);
        const Frame frame = renderOne(scene, shown.view(nodeFromModel), settings);
        expectPicture(*shown.picture(), whole, [&](int x, int y) { return composed(frame, x, y, shown.background()); });
    };
    expectShown();
    node->setPlanes({});
    node->setClip({});
    node->setLight({});
    node->setSpecular({});
    node->setAmbientOcclusion({});
    scene.planes.clear();
    scene.clip = {};
    settings.light.reset();
    settings.specular = {};
    settings.ambientOcclusion.reset();
    expectShown();
}

TEST(VolumeNode, HasColoursOfAnotherFieldByAPropertyOrByItsTransferFunction)
{
    BRICKWALL_NEEDS_DISPLAY();
    SceneOptions options;
    options.data = "sample:wake:60k";
    options.iso = {0.7};
    options.volume = "off";
    Progress silent;
    const osg::ref_ptr<VolumeNode> node = new VolumeNode;
    node->load(options, silent);
    const osg::Matrixd nodeFromModel = centred(*node);
    NodeViewer shown(node);
    shown.settle(*node);
    const unsigned data = node->dataStamp(), look = node->lookStamp();
    const auto expectShown = [&](const Scene& scene) {
        shown.settle(*node);
        const Frame frame = renderOne(scene, shown.view(nodeFromModel), {});
        expectPicture(*shown.picture(), whole, [&](int x, int y) { return composed(frame, x, y, shown.background()); });
    };
    node->setColorField("pressure", {-0.4f, 0.4f});
    EXPECT_EQ(node->dataStamp(), data + 1) << "another field is read";
    EXPECT_EQ(node->lookStamp(), look + 1);
    options.colorField = "pressure";
    options.colorRange = {-0.4f, 0.4f};
    const Scene scene = prepareScene(options, Executor(1), silent).scene;
    ASSERT_TRUE(scene.colorField);
    expectShown(scene);

    TransferFunction tf = scene.transferFunction;
    tf.colorField->range = {-0.2f, 0.1f};
    node->setTransferFunction(tf);
    EXPECT_EQ(node->dataStamp(), data + 1) << "this field is there";
    Scene other = scene;
    other.transferFunction = tf;
    expectShown(other);

    node->setTransferFunction({});
    node->setColorField("");
    node->setTransferFunction(tf);
    expectShown(other);
    EXPECT_NE(errorOf([&] { node->setColorField("pressure", {1.0f, 1.0f}); }), "");
}

} // namespace
} // namespace brickwall::test
