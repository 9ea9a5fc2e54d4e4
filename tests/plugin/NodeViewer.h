// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/plugin/VolumeNode.h"
#include "brickwall/plugin/WindowCapture.h"

#include <osg/Image>
#include <osgViewer/Viewer>

namespace brickwall::test {

/// An osgViewer as any program has it: near and far computed from the bounds, one window, one camera at (0, 0, 10) that
/// looks along -z with 40 degrees, cleared to a blue. The camera's matrices are known; nothing else is ours.
struct NodeViewer
{
    static constexpr int width = 64;
    static constexpr int height = 48;

    osgViewer::Viewer viewer;

    /// `stereo`: OSG's mode, or -1.
    explicit NodeViewer(osg::Node* scene, int stereo = -1,
                        osgViewer::ViewerBase::ThreadingModel threads = osgViewer::ViewerBase::SingleThreaded);
    ~NodeViewer();

    /// Draws frames until the node shows what it should; a failure of the test after some minutes.
    void settle(const VolumeNode& node);
    /// The window, as drawn by one more frame.
    osg::ref_ptr<osg::Image> picture();

    /// The view that the renderer is to make for a modelview matrix, relative to the camera's, of this part of the
    /// window.
    View view(const osg::Matrixd& model = {}, int viewWidth = width, int viewHeight = height) const;
    /// Of an eye as OSG's SceneView has it: -1 the left, 1 the right.
    View eyeView(int side, int viewWidth, int viewHeight) const;
    vec3f background() const;

private:
    osg::ref_ptr<WindowCapture> capture_;
};

/// A square of 4 x 4 about (x, y, z), unlit.
osg::ref_ptr<osg::Node> square(const osg::Vec3& center, const osg::Vec4& color, float halfWidth = 2.0f);

} // namespace brickwall::test
