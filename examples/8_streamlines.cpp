// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// Streamlines of the data as geometry of the scene, inside the volume.
#include "SmallWindow.h"

#include <brickwall/core/io/DataSet.h>
#include <brickwall/core/scene/StreamlineTubes.h>
#include <brickwall/plugin/NodeTriangles.h>

using namespace brickwall;

int main(int argc, char** argv)
{
    return runExample(argc, argv, {}, [](const Arguments& arguments) {
        SceneOptions options;
        options.data = arguments.data;
        Progress silent;
        osg::ref_ptr<VolumeNode> node = new VolumeNode;
        node->load(options, silent);

        osg::ref_ptr<osg::Group> scene = new osg::Group;
        scene->addChild(node);
        options.streamlines = {"40"}; // seeds, all over the data
        const Executor executor(options.threads);
        for (TriangleMesh& tubes : streamlineTubes(options, *openData(options), executor, silent)) {
            tubes.color = {0.9f, 0.5f, 0.1f};
            scene->addChild(geometryOf(tubes));
        }
        runViewer(scene, *node, arguments);
    });
}
