// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/Rig.h"
#include "brickwall/core/base/Progress.h"
#include "brickwall/core/render/Frame.h"
#include "brickwall/plugin/RigWindows.h"

#include <osg/Image>

#include <array>
#include <functional>
#include <span>
#include <vector>

namespace brickwall::test {

/// A front screen of 2 m x 2 m one metre before the viewer, in one window whose only channel fills it.
Rig deskRig(int width, int height, StereoMode stereo = StereoMode::mono);

/// The same with a second screen and window to the left of the viewer.
Rig cornerRig(int width, int height);

/// A frame that no mirroring, turning or exchange with another seed leaves as it is: opaque to the left, empty to the
/// right, semi-transparent in between, a bright mark near the lower left corner; depth 1 where it is empty, else
/// `depth`.
Frame patternFrame(const View& view, int seed, float depth = 0.5f);
/// One for each view, with its number as the seed: a FrameMaker.
std::vector<Frame> patternFrames(std::span<const View> views, Progress& progress);

/// Windows, and the frame of every view handed to the drawer. Data space is the room.
struct ShownRig
{
    RigViews views;
    std::vector<Frame> frames; ///< one per view
    RigWindows windows;

    explicit ShownRig(const Rig& rig, bool drawThreads = false);

    const Frame& frameOf(int channel, Eye eye) const;
    /// Hands a frame to its view's back images.
    void write(const ChannelView& view, const Frame& frame);
    /// Draws one frame and returns the windows' pictures.
    std::vector<WindowCapture::Picture> draw();
    osg::ref_ptr<osg::Image> drawOne() { return draw().at(0).left; }
};

using Rgb = std::array<int, 3>;

/// What a picture file of the frame has in this pixel: sRGB(C + (1 - A) background), in 8 bits.
Rgb composed(const Frame& frame, int x, int y, const vec3f& background);

Rgb pixel(const osg::Image& image, int x, int y);

/// Compares every pixel of a rectangle of the picture with expected(x, y), x and y counted from the rectangle's lower
/// left.
void expectPicture(const osg::Image& picture, const PixelRect& rect, const std::function<Rgb(int x, int y)>& expected,
                   int tolerance = 2);

} // namespace brickwall::test
