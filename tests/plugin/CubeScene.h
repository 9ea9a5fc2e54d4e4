// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/plugin/VolumeNode.h"
#include "brickwall/tests/render/RenderScenes.h"

#include <glm/gtc/matrix_transform.hpp>

namespace brickwall::test {

/// A cube of 4 x 4 x 4 about the origin.
inline Scene cubeScene()
{
    const auto bricks = threeLevels(3);
    const mat4d worldFromVoxel = glm::translate(mat4d(1.0), vec3d(-2.0)) * glm::scale(mat4d(1.0), vec3d(4.0 / 32.0));
    return sceneOf(bricks, fieldOf(bricks, waves), colorful({-1.0f, 1.0f}), worldFromVoxel);
}

inline osg::ref_ptr<VolumeNode> cubeNode()
{
    osg::ref_ptr<VolumeNode> node = new VolumeNode;
    node->show(cubeScene());
    return node;
}

} // namespace brickwall::test
