// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Progress.h"
#include "brickwall/core/model/Model.h"

#include <string>
#include <vector>

namespace brickwall {

/// Opaque triangles from a file, by its extension: Wavefront `.obj` with the diffuse colours (Kd) of its materials, PLY
/// and STL in their text and binary forms, ExaBrick's `.tris`. Polygons are cut into triangles; points and lines are
/// left out, as are triangles without an area, which are counted in a note. Coordinates stay what they are.
///
/// Throws Error for files of other kinds, files that cannot be read, broken ones, vertices that are not finite, and if
/// no triangle is left; Cancelled.
std::vector<TriangleMesh> readMesh(const std::string& path, Progress& progress);

} // namespace brickwall
