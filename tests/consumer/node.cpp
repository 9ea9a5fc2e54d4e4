// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include <brickwall/plugin/VolumeNode.h>

#include <cstdio>

using namespace brickwall;

/// A volume in a scene graph; needs no display. Exits with 0 if it is where its data are.
int main()
{
    SceneOptions options;
    options.data = "sample:wake:100k";
    Progress silent;
    const osg::ref_ptr<VolumeNode> node = new VolumeNode;
    node->load(options, silent);
    const osg::BoundingBox box = node->boundingBox();
    std::printf("a volume of radius %g\n", double(box.radius()));
    return box.valid() && box.contains(osg::Vec3(0.0f, 0.0f, 0.0f)) ? 0 : 1;
}
