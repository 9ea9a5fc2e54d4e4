// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/DrawerShaders.h"

#include "brickwall/plugin/WarpShaders.h"

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/PolygonMode>
#include <osg/Uniform>

#include <limits>

namespace brickwall {
namespace {

constexpr int depthBin = 8; // between the opaque bin, 0, and the transparent one, 10
constexpr int colorBin = 9;

osg::ref_ptr<osg::Depth> depthTestOf(DrawerPass pass)
{
    // Two fragments of a warped image at one depth: only the first may be blended.
    if (isWarped(pass))
        return new osg::Depth(osg::Depth::LESS, 0.0, 1.0, true);
    if (pass == DrawerPass::asIs)
        return new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, true);
    return new osg::Depth(osg::Depth::ALWAYS, 0.0, 1.0, false);
}

/// The neighbours that a point reaches: none, those in its own depth, or where they are.
int reachOf(MultiChannelDrawer::Mode mode)
{
    if (mode == MultiChannelDrawer::ReprojectAdaptiveWithNeighbors)
        return 2;
    return mode == MultiChannelDrawer::ReprojectAdaptive ? 1 : 0;
}

/// COVISE's.
constexpr float stretchOfHoles = 10.0f;

} // namespace

osg::ref_ptr<osg::StateSet> makeDrawerState(osg::Uniform* background)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->addUniform(new osg::Uniform("brickwallColor", int(drawerState::colorUnit)));
    state->addUniform(new osg::Uniform("brickwallDepth", int(drawerState::depthUnit)));
    state->addUniform(background);
    state->setAttributeAndModes(new osg::BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA));
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    // A viewer that shows its scene as wires should still show the images.
    state->setAttributeAndModes(new osg::PolygonMode(osg::PolygonMode::FRONT_AND_BACK, osg::PolygonMode::FILL),
                                osg::StateAttribute::ON | osg::StateAttribute::PROTECTED);
    return state;
}

osg::ref_ptr<osg::StateSet> makePassState(DrawerPass pass, MultiChannelDrawer::Mode mode)
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setAttributeAndModes(isWarped(pass) ? makeWarpProgram(mode) : makeAsIsProgram());
    state->setAttributeAndModes(depthTestOf(pass));
    state->addUniform(new osg::Uniform("brickwallReach", reachOf(mode)));
    state->addUniform(new osg::Uniform("brickwallLargestStretch", mode == MultiChannelDrawer::ReprojectMeshWithHoles
                                                                      ? stretchOfHoles
                                                                      : std::numeric_limits<float>::max()));
    state->setMode(GL_VERTEX_PROGRAM_POINT_SIZE, osg::StateAttribute::ON);
    state->setRenderBinDetails(pass == DrawerPass::depth ? depthBin : colorBin, "RenderBin");
    return state;
}

} // namespace brickwall
