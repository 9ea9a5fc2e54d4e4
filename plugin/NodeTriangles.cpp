// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/NodeTriangles.h"

#include "brickwall/core/shade/Srgb.h"
#include "brickwall/plugin/OsgConversions.h"

#include <osg/Drawable>
#include <osg/NodeVisitor>
#include <osg/Transform>
#include <osg/TriangleFunctor>
#include <osgUtil/SmoothingVisitor>

#include <numbers>
#include <utility>

namespace brickwall {
namespace {

/// What OSG calls for each triangle of a drawable.
struct Collector
{
    TriangleMesh mesh;
    osg::Matrixd around; ///< from the drawable's coordinates

    void operator()(const osg::Vec3& a, const osg::Vec3& b, const osg::Vec3& c)
    {
        if (!(((b - a) ^ (c - a)).length2() > 0.0f))
            return;
        const int first = int(mesh.vertices.size());
        for (const osg::Vec3& v : {a, b, c}) {
            const osg::Vec3d p = osg::Vec3d(v) * around;
            mesh.vertices.push_back(vec3f(p.x(), p.y(), p.z()));
        }
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
};

class TriangleVisitor : public osg::NodeVisitor
{
public:
    TriangleVisitor() : osg::NodeVisitor(TRAVERSE_ACTIVE_CHILDREN) {}

    using osg::NodeVisitor::apply;

    void apply(osg::Transform& transform) override
    {
        const osg::Matrixd before = around_;
        transform.computeLocalToWorldMatrix(around_, this);
        traverse(transform);
        around_ = before;
    }

    void apply(osg::Drawable& drawable) override
    {
        osg::TriangleFunctor<Collector> collector;
        collector.around = around_;
        drawable.accept(collector);
        if (!collector.mesh.triangles.empty())
            meshes.push_back(std::move(collector.mesh));
    }

    std::vector<TriangleMesh> meshes;

private:
    osg::Matrixd around_;
};

} // namespace

std::vector<TriangleMesh> trianglesOf(osg::Node& scene)
{
    TriangleVisitor visitor;
    scene.accept(visitor);
    return std::move(visitor.meshes);
}

osg::ref_ptr<osg::Geometry> geometryOf(const TriangleMesh& mesh)
{
    osg::ref_ptr<osg::Vec3Array> vertices = new osg::Vec3Array;
    for (const vec3f& v : mesh.vertices)
        vertices->push_back(osg::Vec3(v.x, v.y, v.z));
    osg::ref_ptr<osg::DrawElementsUInt> triangles = new osg::DrawElementsUInt(GL_TRIANGLES);
    for (const vec3i& t : mesh.triangles)
        for (int corner = 0; corner < 3; ++corner)
            triangles->push_back(GLuint(t[corner]));
    osg::Vec4 color(0.0f, 0.0f, 0.0f, 1.0f);
    for (int c = 0; c < 3; ++c)
        color[c] = srgbFromLinear(mesh.color[c]);
    osg::ref_ptr<osg::Vec4Array> colors = new osg::Vec4Array(osg::Array::BIND_OVERALL);
    colors->push_back(color);
    osg::ref_ptr<osg::Geometry> geometry = new osg::Geometry;
    geometry->setVertexArray(vertices);
    geometry->setColorArray(colors);
    geometry->addPrimitiveSet(triangles);
    constexpr double crease = std::numbers::pi / 3.0;
    osgUtil::SmoothingVisitor::smooth(*geometry, crease);
    return geometry;
}

TriangleMesh transformed(const TriangleMesh& mesh, const mat4d& m)
{
    TriangleMesh moved = mesh;
    for (vec3f& v : moved.vertices)
        v = vec3f(transformPoint(m, vec3d(v)));
    return moved;
}

} // namespace brickwall
