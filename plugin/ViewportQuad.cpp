// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/ViewportQuad.h"

#include "brickwall/plugin/FreshArray.h"

namespace brickwall {
namespace {

constexpr unsigned cornerAttribute = 0;

constexpr const char* vertexSource = R"(#version 120
attribute vec2 corner;
varying vec2 texel;

void main()
{
    texel = 0.5 * corner + 0.5;
    gl_Position = vec4(corner, 0.0, 1.0);
}
)";

} // namespace

void shapeWithoutBounds(osg::Geometry& geometry)
{
    geometry.setUseDisplayList(false);
    geometry.setUseVertexBufferObjects(true);
    geometry.setComputeBoundingBoxCallback(new osg::Drawable::ComputeBoundingBoxCallback);
    geometry.setCullingActive(false);
    geometry.setDataVariance(osg::Object::DYNAMIC);
}

void shapeAsViewportQuad(osg::Geometry& geometry)
{
    const osg::ref_ptr<osg::Vec2Array> corners = makeFreshArray<osg::Vec2Array>();
    for (const osg::Vec2& corner : {osg::Vec2(-1, -1), osg::Vec2(1, -1), osg::Vec2(-1, 1), osg::Vec2(1, 1)})
        corners->push_back(corner);
    shapeWithoutBounds(geometry);
    geometry.setVertexAttribArray(cornerAttribute, corners);
    geometry.addPrimitiveSet(new osg::DrawArrays(GL_TRIANGLE_STRIP, 0, 4));
}

osg::ref_ptr<osg::Geometry> makeViewportQuad()
{
    osg::ref_ptr<osg::Geometry> quad = new osg::Geometry;
    shapeAsViewportQuad(*quad);
    return quad;
}

osg::ref_ptr<osg::Program> makeViewportProgram(const char* name, const char* fragmentSource)
{
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName(name);
    program->addShader(new osg::Shader(osg::Shader::VERTEX, vertexSource));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, fragmentSource));
    program->addBindAttribLocation("corner", cornerAttribute);
    return program;
}

} // namespace brickwall
