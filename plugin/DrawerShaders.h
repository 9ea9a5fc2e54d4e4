// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/plugin/MultiChannelDrawer.h"

#include <osg/StateSet>

namespace brickwall {

/// What the drawer's programs read from the state.
namespace drawerState {
constexpr unsigned colorUnit = 0;
constexpr unsigned depthUnit = 1;
constexpr unsigned pixelAttribute = 0; ///< of the programs that warp: place in the image, pixels
constexpr const char* backgroundName = "brickwallBackground";
} // namespace drawerState

/// Images are drawn as rectangles, or warped in two passes: all views of a channel leave their depth before any leaves
/// its colour, so that of several pixels that land on one the nearest is blended over the scene, and that once.
enum class DrawerPass { asIs, asIsWithoutDepth, depth, color };

constexpr bool isWarped(DrawerPass pass)
{
    return pass == DrawerPass::depth || pass == DrawerPass::color;
}

/// What all have in common: samplers, background, premultiplied blending.
osg::ref_ptr<osg::StateSet> makeDrawerState(osg::Uniform* background);

/// Program (GLSL 1.20, no fixed function, no geometry shader), depth test and render bin (after the opaque and before
/// the transparent one) of a pass. ChannelPass sets the program's other uniforms.
osg::ref_ptr<osg::StateSet> makePassState(DrawerPass pass, MultiChannelDrawer::Mode mode);

constexpr bool isMesh(MultiChannelDrawer::Mode mode)
{
    return mode == MultiChannelDrawer::ReprojectMesh || mode == MultiChannelDrawer::ReprojectMeshWithHoles;
}

} // namespace brickwall
