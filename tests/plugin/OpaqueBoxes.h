// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "CubeScene.h"
#include "TestRigs.h"

#include "brickwall/core/shade/Srgb.h"

#include <osg/Geometry>

#include <cmath>
#include <memory>
#include <vector>

/// Opaque boxes in the scene of a volume, and what windows show of both.
namespace brickwall::test {

inline constexpr float grey = 0.7f; ///< of the geometry, as displayed

/// A turned box of about 1.4 x 1.2 x 1.
inline TriangleMesh boxAt(const vec3d& center)
{
    TriangleMesh mesh;
    const mat4d turned = glm::rotate(glm::translate(mat4d(1.0), center), 0.6, vec3d(0.3, 1.0, 0.2));
    for (int i = 0; i < 8; ++i) {
        const vec3d corner(i & 1 ? 0.7 : -0.7, i & 2 ? 0.6 : -0.6, i & 4 ? 0.5 : -0.5);
        mesh.vertices.push_back(vec3f(transformPoint(turned, corner)));
    }
    mesh.triangles = {{0, 1, 3}, {0, 3, 2}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                      {2, 3, 7}, {2, 7, 6}, {0, 2, 6}, {0, 6, 4}, {1, 3, 7}, {1, 7, 5}};
    return mesh;
}

inline osg::ref_ptr<osg::Geometry> drawn(const TriangleMesh& mesh)
{
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    for (const vec3f& v : mesh.vertices)
        vertices->push_back(osg::Vec3(v.x, v.y, v.z));
    osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    for (const auto& triangle : mesh.triangles)
        for (int i = 0; i < 3; ++i)
            triangles->push_back(unsigned(triangle[i]));
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array(osg::Array::BIND_OVERALL);
    colors->push_back({grey, grey, grey, 1.0f});
    geometry->setVertexArray(vertices);
    geometry->setColorArray(colors);
    geometry->addPrimitiveSet(triangles);
    geometry->getOrCreateStateSet()->setMode(GL_LIGHTING, osg::StateAttribute::OFF);
    return geometry;
}

/// What the renderer makes of a view with these triangles: the triangles alone, and what is before them.
struct Reference
{
    Frame mesh;  ///< opaque where a ray meets it
    Frame front; ///< the volume up to there
    Frame all;   ///< the whole picture, by the renderer alone

    Reference(const View& view, const std::vector<TriangleMesh>& meshes)
    {
        Scene scene = cubeScene();
        scene.triangles = std::make_shared<TriangleScene>(meshes);
        all = renderOne(scene, view, RenderSettings{});
        scene.transferFunction = extinctionRamp({-1.0f, 1.0f}, 0.0f, 0.0f);
        mesh = renderOne(scene, view, RenderSettings{});
        View ended = view;
        ended.sceneDepth = std::make_shared<SceneDepth>(SceneDepth{view.window, mesh.depth});
        front = renderOne(cubeScene(), ended, RenderSettings{});
    }

    bool isMesh(int x, int y) const { return mesh.color[mesh.index(x, y)].a > 0.0f; }
    vec4f frontOf(int x, int y) const { return front.color[front.index(x, y)]; }

    /// In a window cleared to `background`, in which grey geometry is drawn: MultiChannelDrawer's composition.
    Rgb inWindow(int x, int y, const vec3f& background) const
    {
        Rgb rgb = composed(front, x, y, background);
        const float through = 1.0f - frontOf(x, y).a;
        for (int i = 0; i < 3 && isMesh(x, y); ++i)
            rgb[i] += int(std::lround(255.0f * through * (grey - srgbFromLinear(background[i]))));
        return rgb;
    }

    /// The renderer's own way, which blends light: its picture, with geometry that shines in the grey of the window.
    Rgb ofLight(int x, int y, const vec3f& background) const
    {
        Frame pixel = all;
        const std::size_t i = all.index(x, y);
        if (isMesh(x, y)) {
            const vec3f shade = linearFromSrgb(grey) - vec3f(mesh.color[i]);
            pixel.color[i] += vec4f((1.0f - front.color[i].a) * shade, 0.0f);
        }
        return composed(pixel, x, y, background);
    }
};

} // namespace brickwall::test
