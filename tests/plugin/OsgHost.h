// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/scene/SceneSetup.h"

#include <osg/Image>
#include <osg/Matrixd>

#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace brickwall::test {

/// A stock program of OpenSceneGraph that finds our plugin, with arguments as a shell takes them.
class OsgHost
{
public:
    /// Runs until it ends or this does. `environment`: NAME=VALUE, beside what every host here is given.
    OsgHost(const std::string& command, const std::vector<std::string>& environment = {});
    ~OsgHost();
    OsgHost(const OsgHost&) = delete;
    OsgHost& operator=(const OsgHost&) = delete;

    /// Its exit code, or -1 if a signal ended it.
    int wait();
    bool running();
    /// What it has written to both outputs so far.
    std::string output() const;

private:
    std::string log_;
    pid_t pid_ = -1;
    int status_ = 0;
};

/// The upper-left part of an X screen; RGB, row 0 at the bottom.
osg::ref_ptr<osg::Image> screenPicture(int width, int height, const std::string& display = {});

/// Looks at the screen until it is as it should be or two minutes are over; returns the last picture.
osg::ref_ptr<osg::Image> waitForPicture(int width, int height, OsgHost& host,
                                        const std::function<bool(const osg::Image&)>& isDone,
                                        const std::string& display = {});

/// What osgviewer does by itself with a window of this size: the matrices of its one camera at `eye`, looking along
/// -z, and of its eyes (OSG's SceneView with its defaults for the display). eye: 0 for mono, -1 left, 1 right.
osg::Matrixd hostModelview(const osg::Vec3d& eye, int side);
osg::Matrixd hostProjection(int width, int height, int side);

/// Arguments that put osgviewer's camera there.
std::string cameraPathAt(const osg::Vec3d& eye);

} // namespace brickwall::test
