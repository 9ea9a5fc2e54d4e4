// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// A volume as a node in the scene of an OpenSceneGraph program.
#include "SmallWindow.h"

using namespace brickwall;

int main(int argc, char** argv)
{
    return runExample(argc, argv, {}, [](const Arguments& arguments) {
        SceneOptions options;
        options.data = arguments.data;
        Progress silent;
        osg::ref_ptr<VolumeNode> node = new VolumeNode;
        node->load(options, silent);
        runViewer(node, *node, arguments);
    });
}
