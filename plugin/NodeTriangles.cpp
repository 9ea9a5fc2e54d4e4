// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/NodeTriangles.h"

#include "brickwall/plugin/OsgConversions.h"

#include <osg/Drawable>
#include <osg/NodeVisitor>
#include <osg/Transform>
#include <osg/TriangleFunctor>

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

TriangleMesh transformed(const TriangleMesh& mesh, const mat4d& m)
{
    TriangleMesh moved = mesh;
    for (vec3f& v : moved.vertices)
        v = vec3f(transformPoint(m, vec3d(v)));
    return moved;
}

} // namespace brickwall
