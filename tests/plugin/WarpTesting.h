// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "TestRigs.h"

#include <osg/Geometry>

#include <functional>
#include <vector>

namespace brickwall::test {

/// An upright rectangle in the room, parallel to the desk rig's screen, coloured by place (linear, premultiplied).
struct Card
{
    double y = 0.0; ///< how far in front of the viewer at the start
    double lowerX = -20.0, upperX = 20.0;
    std::function<vec4f(double x, double z)> color;
};

/// Red, unlit, upright at a distance in front of the viewer, over all of the desk rig's screen and more; leaning if the
/// distances differ (of its lower and upper edge, 20 m below and above the eye).
osg::ref_ptr<osg::Geometry> redWall(double lowerY, double upperY);
/// Window depth of something that far in front of the viewer, with the desk rig's near and far.
float depthAt(double distance);

Card plainCard(double y, const vec4f& color);
/// Light from left to right and from bottom to top: a shift by one pixel anywhere is seen.
Card gradientCard(double y);

/// What the view sees of them: of several the nearest, alone.
Frame frameOf(const View& view, const std::vector<Card>& cards);

/// Windows of a rig with a drawer of their own whose images were rendered for an earlier pose of the head or the data.
struct WarpedRig : ShownRig
{
    explicit WarpedRig(const Rig& rig, bool flipped = false);

    /// Renders all views for the present pose and publishes them with their matrices.
    void render(const std::vector<Card>& cards);
    void publish(int view, const Frame& frame);
    /// The pose from now on: the head's place in the room, and where the data are (roomFromWorld is a translation).
    void move(const vec3d& head, const vec3d& data = vec3d(0.0));
    void computeNearAndFar();

    Rig rig;
    osg::ref_ptr<MultiChannelDrawer> drawer;
};

struct NamedMode
{
    const char* name;
    MultiChannelDrawer::Mode mode;
};
/// All that reproject.
extern const std::vector<NamedMode> warpingModes;

/// Differences of a picture from what is expected, in sRGB steps of 1/255, over pixels at least `border` from its edge.
struct Difference
{
    double meanSigned = 0.0; ///< of the component where it is farthest from 0
    double mean = 0.0;
    int largest = 0;
};
Difference differenceOf(const osg::Image& picture, const std::function<Rgb(int x, int y)>& expected, int border = 0);

/// The share of a picture's pixels for which `is` holds.
double shareOf(const osg::Image& picture, const std::function<bool(const Rgb&)>& is, int border = 0);

} // namespace brickwall::test
