// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"

#include <glm/gtc/type_ptr.hpp>

#include <osg/Matrixd>

namespace brickwall {

/// The one door between GLM and OpenSceneGraph. GLM multiplies column vectors (M * v), OSG row vectors (v * M), and
/// each stores its matrices so that the 16 numbers in memory are those that OpenGL expects: they are copied as they
/// are. A product changes its order on the way: toOsg(P * V) == toOsg(V) * toOsg(P).
inline osg::Matrixd toOsg(const mat4d& m)
{
    return osg::Matrixd(glm::value_ptr(m));
}

inline mat4d toGlm(const osg::Matrixd& m)
{
    return glm::make_mat4(m.ptr());
}

} // namespace brickwall
