// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/DrawerShaders.h"

#include "brickwall/plugin/ViewportQuad.h"

#include <osg/BlendFunc>
#include <osg/Depth>
#include <osg/Uniform>

namespace brickwall {
namespace {

// IEC 61966-2-1 for the transfer from linear to sRGB.
constexpr const char* fragmentSource = R"(#version 120
uniform sampler2D brickwallColor;
uniform sampler2D brickwallDepth;
uniform vec3 brickwallBackground;
varying vec2 texel;

vec3 srgb(vec3 linear)
{
    vec3 c = clamp(linear, 0.0, 1.0);
    vec3 curved = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
    return mix(curved, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}

void main()
{
    vec4 color = texture2D(brickwallColor, texel);
    if (color == vec4(0.0))
        discard;
    float behind = 1.0 - color.a;
    vec3 overBackground = srgb(color.rgb + behind * brickwallBackground);
    gl_FragColor = vec4(max(overBackground - behind * srgb(brickwallBackground), 0.0), color.a);
    gl_FragDepth = texture2D(brickwallDepth, texel).r;
}
)";

constexpr int binBetweenOpaqueAndTransparent = 9;

} // namespace

osg::ref_ptr<osg::StateSet> makeDrawerState()
{
    osg::ref_ptr<osg::StateSet> state = new osg::StateSet;
    state->setAttributeAndModes(makeViewportProgram("brickwall MultiChannelDrawer", fragmentSource));
    state->addUniform(new osg::Uniform("brickwallColor", int(drawerState::colorUnit)));
    state->addUniform(new osg::Uniform("brickwallDepth", int(drawerState::depthUnit)));
    state->setAttributeAndModes(new osg::BlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::LEQUAL, 0.0, 1.0, true));
    state->setMode(GL_CULL_FACE, osg::StateAttribute::OFF);
    state->setRenderBinDetails(binBetweenOpaqueAndTransparent, "RenderBin");
    return state;
}

} // namespace brickwall
