// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Opaque geometry of the scene that the renderer knows: it ends rays and casts shadows.
#include "NodeViewer.h"
#include "OpaqueBoxes.h"
#include "TestDisplay.h"

#include "brickwall/core/shade/Srgb.h"
#include "brickwall/plugin/NodeTriangles.h"
#include "brickwall/plugin/OsgConversions.h"

#include <gtest/gtest.h>

#include <osg/MatrixTransform>
#include <osg/ShapeDrawable>
#include <osg/Switch>

#include <algorithm>
#include <cmath>
#include <limits>

namespace brickwall::test {
namespace {

const vec3d inside(0.4, 0.3, 0.2), before(0.3, 0.5, 3.2);
const Light sun{{0.2, 0.4, 1.0}, 0.2f};

/// A volume, and a box under a transform, which the renderer knows.
struct SceneWithOccluder
{
    osg::ref_ptr<VolumeNode> node = cubeNode();
    osg::ref_ptr<osg::Group> root = new osg::Group;
    osg::ref_ptr<osg::MatrixTransform> place = new osg::MatrixTransform;

    explicit SceneWithOccluder(const vec3d& at = inside)
    {
        place->setMatrix(osg::Matrixd::translate(at.x, at.y, at.z));
        place->addChild(drawn(boxAt(vec3d(0.0))));
        root->addChild(node);
        root->addChild(place);
        node->setSceneDepth(false);
        node->setOccluders(place);
    }
};

/// What the window shows: the renderer's picture with these occluders over the boxes that OSG draws.
Reference expected(const View& view, const std::optional<Light>& light = {}, const vec3d& at = inside)
{
    const std::vector<TriangleMesh> box{boxAt(at)};
    Reference reference(view, box);
    Scene scene = cubeScene();
    scene.occluders = std::make_shared<TriangleScene>(box);
    RenderSettings settings;
    settings.light = light;
    reference.front = renderOne(scene, view, settings);
    return reference;
}

void expectWindow(NodeViewer& shown, const VolumeNode& node, const Reference& reference)
{
    shown.settle(node);
    const PixelRect whole{0, 0, NodeViewer::width, NodeViewer::height};
    expectPicture(*shown.picture(), whole, [&](int x, int y) { return reference.inWindow(x, y, shown.background()); });
}

TEST(Occluders, EndRaysWhereTheyAreWithoutReadingDepth)
{
    BRICKWALL_NEEDS_DISPLAY();
    const SceneWithOccluder scene;
    NodeViewer shown(scene.root);
    expectWindow(shown, *scene.node, expected(shown.view()));
}

TEST(Occluders, CastShadowsInTheLight)
{
    BRICKWALL_NEEDS_DISPLAY();
    const SceneWithOccluder scene(before);
    scene.node->setLight(sun);
    NodeViewer shown(scene.root);
    const Reference reference = expected(shown.view(), sun, before);
    expectWindow(shown, *scene.node, reference);

    RenderSettings settings;
    settings.light = sun;
    const Frame without = renderOne(cubeScene(), shown.view(), settings);
    int darker = 0;
    for (int y = 0; y < NodeViewer::height; ++y)
        for (int x = 0; x < NodeViewer::width; ++x)
            darker +=
                !reference.isMesh(x, y) && reference.frontOf(x, y).g < 0.9f * without.color[without.index(x, y)].g;
    EXPECT_GT(darker, 50) << "hardly anything lies in the shadow";
}

TEST(Occluders, StayWhereTheyAreWhenTheVolumeMoves)
{
    BRICKWALL_NEEDS_DISPLAY();
    const SceneWithOccluder scene;
    const osg::Matrixd nodeFromModel = osg::Matrixd::scale(1.2, 1.2, 1.2) * osg::Matrixd::translate(-0.5, 0.2, 0.0);
    scene.node->setTransform(nodeFromModel);
    NodeViewer shown(scene.root);
    Reference reference = expected(shown.view());
    Scene moved = cubeScene();
    const std::vector<TriangleMesh> box{transformed(boxAt(inside), toGlm(osg::Matrixd::inverse(nodeFromModel)))};
    moved.occluders = std::make_shared<TriangleScene>(box);
    reference.front = renderOne(moved, shown.view(nodeFromModel), RenderSettings{});
    expectWindow(shown, *scene.node, reference);
}

TEST(Occluders, CanBeTakenAway)
{
    BRICKWALL_NEEDS_DISPLAY();
    const SceneWithOccluder scene;
    scene.node->setOccluders(nullptr);
    scene.root->removeChild(scene.place);
    NodeViewer shown(scene.root);
    shown.settle(*scene.node);
    const Frame frame = renderOne(cubeScene(), shown.view(), RenderSettings{});
    const PixelRect whole{0, 0, NodeViewer::width, NodeViewer::height};
    expectPicture(*shown.picture(), whole, [&](int x, int y) { return composed(frame, x, y, shown.background()); });
}

TEST(TrianglesOfNode, WithoutAnAreaOrWithANaNAreLeftOut)
{
    TriangleMesh bad = boxAt(inside);
    bad.vertices[3].y = std::numeric_limits<float>::quiet_NaN();
    bad.triangles = {{0, 1, 3}, {0, 1, 1}, {0, 1, 2}};
    const std::vector<TriangleMesh> meshes = trianglesOf(*drawn(bad));
    ASSERT_EQ(meshes.size(), 1u);
    EXPECT_EQ(meshes[0].triangles.size(), 1u);
}

TEST(GeometryOfTriangles, HasTheTrianglesTheColourAsDisplayedAndSmoothNormals)
{
    TriangleMesh cube = boxAt(inside);
    cube.color = {0.2f, 0.5f, 1.0f};
    const osg::ref_ptr<osg::Geometry> geometry = geometryOf(cube);
    const std::vector<TriangleMesh> back = trianglesOf(*geometry);
    ASSERT_EQ(back.size(), 1u);
    EXPECT_EQ(back[0].triangles.size(), cube.triangles.size());
    Box3d want, found;
    for (const vec3f& v : cube.vertices)
        want.extend(vec3d(v));
    for (const vec3f& v : back[0].vertices)
        found.extend(vec3d(v));
    EXPECT_EQ(found, want);
    const osg::Vec4& color = static_cast<const osg::Vec4Array&>(*geometry->getColorArray())[0];
    EXPECT_NEAR(color.g(), srgbFromLinear(0.5f), 1e-6);
    // A box has edges: the normals at a triangle's corners are that of its plane.
    const auto& vertices = static_cast<const osg::Vec3Array&>(*geometry->getVertexArray());
    const auto& normals = static_cast<const osg::Vec3Array&>(*geometry->getNormalArray());
    const osg::PrimitiveSet& corners = *geometry->getPrimitiveSet(0);
    ASSERT_EQ(corners.getNumIndices(), 3 * cube.triangles.size());
    for (unsigned i = 0; i < corners.getNumIndices(); i += 3) {
        const osg::Vec3& a = vertices[corners.index(i)];
        osg::Vec3 normal = (vertices[corners.index(i + 1)] - a) ^ (vertices[corners.index(i + 2)] - a);
        normal.normalize();
        for (unsigned corner = 0; corner < 3; ++corner)
            EXPECT_GT(normals[corners.index(i + corner)] * normal, 0.99999f) << i;
    }
}

TEST(TrianglesOfNode, AreThoseThatAreDrawnInTheCoordinatesAroundIt)
{
    osg::ref_ptr<osg::MatrixTransform> outer = new osg::MatrixTransform(osg::Matrixd::translate(1, 0, 0));
    osg::ref_ptr<osg::MatrixTransform> inner = new osg::MatrixTransform(osg::Matrixd::scale(2, 2, 2));
    osg::ref_ptr<osg::Switch> off = new osg::Switch;
    off->addChild(drawn(boxAt(vec3d(50.0))), false);
    inner->addChild(new osg::ShapeDrawable(new osg::Box(osg::Vec3(0, 1, 0), 1.0f)));
    outer->addChild(inner);
    outer->addChild(off);
    outer->addChild(cubeNode()); // draws no triangles of its own
    const std::vector<TriangleMesh> meshes = trianglesOf(*outer);
    ASSERT_EQ(meshes.size(), 1u);
    EXPECT_EQ(meshes[0].triangles.size(), 12u);
    Box3d bounds;
    for (const vec3f& v : meshes[0].vertices)
        bounds.extend(vec3d(v));
    EXPECT_EQ(bounds, (Box3d{vec3d(0, 1, -1), vec3d(2, 3, 1)}));
}

} // namespace
} // namespace brickwall::test
