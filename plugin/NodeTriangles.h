// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/model/Model.h"

#include <osg/Geometry>
#include <osg/Node>

#include <vector>

namespace brickwall {

/// The triangles of everything under a node that is drawn (masks, switches and levels of detail as they are now), in
/// the coordinates around it, a mesh per drawable. Triangles without an area, or with a
/// vertex that is no number, are left out; lines and points have none.
std::vector<TriangleMesh> trianglesOf(osg::Node& scene);

/// To be drawn by OpenSceneGraph, in the mesh's own coordinates: with its colour as displayed, and normals that are
/// smooth but for edges of more than 60 degrees.
osg::ref_ptr<osg::Geometry> geometryOf(const TriangleMesh& mesh);

/// Moved by `m`.
TriangleMesh transformed(const TriangleMesh& mesh, const mat4d& m);

} // namespace brickwall
