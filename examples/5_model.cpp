// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
/// An opaque model inside the volume: it is seen through what lies before it, and hides the rest.
#include "SmallWindow.h"

#include <osg/ShapeDrawable>

using namespace brickwall;

int main(int argc, char** argv)
{
    return runExample(argc, argv, {}, [](const Arguments& arguments) {
        SceneOptions options;
        options.data = arguments.data;
        Progress silent;
        osg::ref_ptr<VolumeNode> node = new VolumeNode;
        node->load(options, silent);

        const osg::BoundingBox box = node->boundingBox();
        osg::ref_ptr<osg::ShapeDrawable> ball =
            new osg::ShapeDrawable(new osg::Sphere(box.center(), 0.1f * box.radius()));
        ball->setColor(osg::Vec4(0.9f, 0.6f, 0.1f, 1.0f));
        osg::ref_ptr<osg::Group> scene = new osg::Group;
        scene->addChild(node);
        scene->addChild(ball);
        runViewer(scene, *node, arguments);
    });
}
