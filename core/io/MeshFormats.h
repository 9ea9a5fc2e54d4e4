// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Progress.h"
#include "brickwall/core/model/Model.h"

#include <string>
#include <vector>

namespace brickwall {

/// The formats behind readMesh, each in a file of its own. What they give may have triangles without an area and
/// vertices that are not finite; indices are those of vertices. They throw Error.

/// Wavefront OBJ, by tinyobjloader: a mesh for each material.
std::vector<TriangleMesh> readObj(const std::string& path);
/// PLY 1.0, text or binary in either byte order (Turk, "The PLY Polygon File Format", 1994): x, y, z of `vertex`, the
/// polygons of `face`; everything else is skipped.
TriangleMesh readPly(const std::string& path, Progress& progress);
/// STL, text or binary: binary if its length is that of as many triangles as it says.
TriangleMesh readStl(const std::string& path, Progress& progress);

/// Adds a polygon as a fan of triangles. Throws Error naming `place` for a vertex that is not among `vertices`.
void addPolygon(TriangleMesh& mesh, const std::vector<double>& corners, const std::string& place);

} // namespace brickwall
