// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Geometry>
#include <osg/Program>

namespace brickwall {

/// Vertices that only their program places: without a bounding box, never culled, without a say in near and far.
/// DYNAMIC, see MultiChannelDrawer.
void shapeWithoutBounds(osg::Geometry& geometry);

/// A rectangle over the whole viewport, whatever the matrices are, for programs of makeViewportProgram; without bounds.
osg::ref_ptr<osg::Geometry> makeViewportQuad();
void shapeAsViewportQuad(osg::Geometry& geometry);

/// A program (GLSL 1.20) that hands its fragment shader `varying vec2 texel`, (0, 0) at the viewport's lower left
/// corner, (1, 1) at its upper right one.
osg::ref_ptr<osg::Program> makeViewportProgram(const char* name, const char* fragmentSource);

} // namespace brickwall
