// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include <cmath>

/// The vector types of the core. GLM is column-major: `m * v` transforms a column vector, `m[c][r]` is column c, row r,
/// and the 16 numbers of a matrix in a file or in OpenGL are its columns one after the other.
namespace brickwall {

using vec3i = glm::ivec3;
using vec3f = glm::vec3;
using vec3d = glm::dvec3;
using vec4f = glm::vec4;
using vec4d = glm::dvec4;
using mat4d = glm::dmat4;

/// `m` applied to a point; the result is divided by w, which has to be non-zero.
inline vec3d transformPoint(const mat4d& m, const vec3d& p)
{
    const vec4d q = m * vec4d(p, 1.0);
    return vec3d(q) / q.w;
}

/// No component is a NaN or infinite; of float vectors, too.
inline bool isFinite(const vec3d& v)
{
    return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z);
}

/// The linear part of `m` applied to a direction.
inline vec3d transformVector(const mat4d& m, const vec3d& v)
{
    return vec3d(m * vec4d(v, 0.0));
}

/// How long `m` makes a unit vector: the cube root of the volume that it makes of a unit cube.
inline double stretchOf(const mat4d& m)
{
    return std::cbrt(std::abs(glm::determinant(glm::dmat3(m))));
}

} // namespace brickwall
