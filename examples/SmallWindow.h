// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "Arguments.h"

#include <brickwall/plugin/VolumeNode.h>
#include <brickwall/plugin/WindowCapture.h>

#include <osgDB/WriteFile>
#include <osgGA/TrackballManipulator>
#include <osgViewer/Viewer>

#include <stdexcept>

/// What the examples with a window share, none of it about volumes: an osgViewer of 320 x 240 that runs until it is
/// closed, or until `node` has its image and so many frames were drawn, and then writes the picture.
inline void runViewer(osg::Node* scene, const brickwall::VolumeNode& node, const Arguments& arguments)
{
    osgViewer::Viewer viewer;
    viewer.setUpViewInWindow(0, 0, 320, 240);
    viewer.setCameraManipulator(new osgGA::TrackballManipulator);
    viewer.setSceneData(scene);
    if (arguments.frames == 0) {
        viewer.run();
        return;
    }
    osg::ref_ptr<brickwall::WindowCapture> capture = new brickwall::WindowCapture(false);
    viewer.getCamera()->setFinalDrawCallback(capture);
    for (int i = 0; !viewer.done() && (i < arguments.frames || !node.settled()); ++i)
        viewer.frame();
    if (arguments.out.empty())
        return;
    capture->request();
    viewer.frame();
    if (!osgDB::writeImageFile(*capture->take().left, arguments.out))
        throw std::runtime_error("cannot write " + arguments.out);
}
