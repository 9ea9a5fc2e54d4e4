// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Geometry>
#include <osg/Texture2D>
#include <osg/Uniform>

#include <string>

namespace brickwall {

/// Lines of text over the upper left corner of a viewport, on a dark ground, in the core's own small font: what a
/// window shows does not depend on the fonts of a machine.
class TextOverlay
{
public:
    TextOverlay();

    /// To be drawn last, with a viewport that starts at the window's lower left corner.
    osg::Node* node() { return quad_.get(); }
    /// Empty: nothing is drawn. Update phase.
    void setText(const std::string& text);
    void setWindowHeight(int height);

private:
    void place();

    osg::ref_ptr<osg::Geometry> quad_;
    osg::ref_ptr<osg::Texture2D> texture_;
    osg::ref_ptr<osg::Uniform> rect_; ///< x, y, width, height in pixels of the window
    int windowHeight_ = 0;
};

} // namespace brickwall
