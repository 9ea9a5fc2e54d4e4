// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Camera>
#include <osg/Image>

#include <condition_variable>
#include <mutex>

namespace brickwall {

/// Reads a window's pixels at the end of a drawn frame: the final draw callback of the camera that is drawn last in the
/// window, whose viewport is all of it.
class WindowCapture : public osg::Camera::DrawCallback
{
public:
    struct Picture
    {
        osg::ref_ptr<osg::Image> left;  ///< RGB in bytes, row 0 at the bottom
        osg::ref_ptr<osg::Image> right; ///< only of windows with quad buffers
    };

    explicit WindowCapture(bool quadBuffer) : quadBuffer_(quadBuffer) {}

    /// The next frame that is drawn will be read.
    void request();
    /// What was asked for, once it is drawn; empty if nothing was drawn within half a minute.
    Picture take();

    void operator()(osg::RenderInfo& info) const override;

private:
    bool quadBuffer_;
    // Draw callbacks are const and run in the window's draw thread.
    mutable std::mutex mutex_;
    mutable std::condition_variable done_;
    mutable bool requested_ = false;
    mutable Picture picture_;
};

} // namespace brickwall
