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

osg::ref_ptr<VolumeNode> loaded(const SceneOptions& options)
{
    Progress silent;
    osg::ref_ptr<VolumeNode> node = new VolumeNode;
    node->load(options, silent);
    return node;
}

/// A node of a file, shown at the origin, 3 in radius.
struct ShownNode
{
    explicit ShownNode(const SceneOptions& options) : node(loaded(options)), viewer(node)
    {
        const osg::BoundingSphere bounds = node->getBound();
        node->setTransform(osg::Matrixd::translate(-bounds.center()) *
                           osg::Matrixd::scale(osg::Vec3d(1, 1, 1) * (3.0 / bounds.radius())));
        viewer.settle(*node);
        data = node->dataStamp();
        look = node->lookStamp();
    }
    void expect(const Scene& scene, const RenderSettings& settings = {})
    {
        viewer.settle(*node);
        const Frame frame = renderOne(scene, viewer.view(node->transform()), settings);
        expectPicture(*viewer.picture(), whole,
                      [&](int x, int y) { return composed(frame, x, y, viewer.background()); });
    }

    const osg::ref_ptr<VolumeNode> node;
    NodeViewer viewer;
    unsigned data = 0, look = 0; ///< stamps at the start
};

TEST(VolumeNode, PlanesClipAndLightAreChangedWithoutReading)
{
    BRICKWALL_NEEDS_DISPLAY();
    SceneOptions options;
    options.data = "sample:wake:60k";
    ShownNode shown(options);
    const osg::ref_ptr<VolumeNode> node = shown.node;

    ClipRegion clip;
    clip.planes = {{{0, 0, -1}, -0.5}};
    clip.sphere = Sphere{{2.0, 0.0, 0.0}, 2.5};
    node->setPlanes({{{0, 0, 1}, 0.0}, {{1, 0, 0}, 1.0}}, 0.7);
    node->setClip(clip);
    node->setLight(Light{{0.2, 1.0, 0.5}, 0.3f});
    node->setSpecular({0.5f, 8.0f});
    node->setAmbientOcclusion(AmbientOcclusion{1.5, 4});
    EXPECT_EQ(node->lookStamp(), shown.look + 5);
    EXPECT_EQ(node->dataStamp(), shown.data);
    Progress silent;
    Scene scene = prepareScene(options, Executor(1), silent).scene;
    scene.planes = {{{{0, 0, 1}, 0.0}, 0.7f}, {{{1, 0, 0}, 1.0}, 0.7f}};
    scene.clip = clip;
    RenderSettings settings;
    settings.light = Light{{0.2, 1.0, 0.5}, 0.3f};
    settings.specular = {0.5f, 8.0f};
    settings.ambientOcclusion = AmbientOcclusion{1.5, 4};
    shown.expect(scene, settings);
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
    shown.expect(scene, settings);
}

TEST(VolumeNode, HasColoursOfAnotherFieldByAPropertyOrByItsTransferFunction)
{
    BRICKWALL_NEEDS_DISPLAY();
    SceneOptions options;
    options.data = "sample:wake:60k";
    options.iso = {0.7};
    options.volume = "off";
    ShownNode shown(options);
    const osg::ref_ptr<VolumeNode> node = shown.node;
    node->setColorField("pressure", {-0.4f, 0.4f});
    EXPECT_EQ(node->dataStamp(), shown.data + 1) << "another field is read";
    EXPECT_EQ(node->lookStamp(), shown.look + 1);
    options.colorField = "pressure";
    options.colorRange = {-0.4f, 0.4f};
    Progress silent;
    const Scene scene = prepareScene(options, Executor(1), silent).scene;
    ASSERT_TRUE(scene.colorField);
    shown.expect(scene);

    TransferFunction tf = scene.transferFunction;
    tf.colorField->range = {-0.2f, 0.1f};
    node->setTransferFunction(tf);
    EXPECT_EQ(node->dataStamp(), shown.data + 1) << "this field is there";
    Scene other = scene;
    other.transferFunction = tf;
    shown.expect(other);

    node->setTransferFunction({});
    node->setColorField("");
    node->setTransferFunction(tf);
    shown.expect(other);
    EXPECT_NE(errorOf([&] { node->setColorField("pressure", {1.0f, 1.0f}); }), "");
}

} // namespace
} // namespace brickwall::test
