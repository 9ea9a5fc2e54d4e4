// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/WarpShaders.h"

#include "brickwall/plugin/DrawerShaders.h"
#include "brickwall/plugin/MeshSources.h"
#include "brickwall/plugin/PointSources.h"
#include "brickwall/plugin/ViewportQuad.h"

#include <string>

namespace brickwall {
namespace {

// IEC 61966-2-1 for the transfer from linear to sRGB.
const std::string composition = R"(#version 120
uniform sampler2D brickwallColor;
uniform sampler2D brickwallDepth;
uniform vec3 brickwallBackground;
uniform mat4 brickwallDrawnFromImage;
uniform float brickwallUp;

vec3 srgb(vec3 linear)
{
    vec3 c = clamp(linear, 0.0, 1.0);
    vec3 curved = 1.055 * pow(c, vec3(1.0 / 2.4)) - 0.055;
    return mix(curved, 12.92 * c, vec3(lessThanEqual(c, vec3(0.0031308))));
}

vec4 emitted(vec4 color)
{
    float behind = 1.0 - color.a;
    vec3 overBackground = srgb(color.rgb + behind * brickwallBackground);
    return vec4(max(overBackground - behind * srgb(brickwallBackground), 0.0), color.a);
}
)";

// A ray that has ended at the scene's own depth is drawn over it: that may not be lost in a buffer of 24 bits.
const std::string asIsFragment = composition + R"(
varying vec2 texel;
const float rounding = 1.0 / 4194304.0;

void main()
{
    vec2 place = vec2(texel.x, brickwallUp > 0.0 ? texel.y : 1.0 - texel.y);
    vec4 color = texture2D(brickwallColor, place);
    if (color == vec4(0.0))
        discard;
    float depth = texture2D(brickwallDepth, place).r;
    vec4 clip = brickwallDrawnFromImage * vec4(2.0 * vec3(texel, depth) - 1.0, 1.0);
    gl_FragDepth = clamp(0.5 * clip.z / clip.w + 0.5 - rounding, 0.0, 1.0);
    gl_FragColor = emitted(color);
}
)";

// Vertex shaders see an image through pixels, not texture coordinates: p = (x + 1/2, y + 1/2) of a pixel, or on the
// image's edge. What is nearer or farther than the draw's planes is put on them; what is behind the eye stays outside,
// because its w is negative.
const std::string warpVertex = R"(#version 120
uniform sampler2D brickwallColor;
uniform sampler2D brickwallDepth;
uniform mat4 brickwallDrawnFromImage;
uniform float brickwallUp;
uniform vec2 brickwallSize;
uniform vec2 brickwallViewport;
attribute vec2 pixel;

vec4 colorOf(vec2 p)
{
    return texture2DLod(brickwallColor, p / brickwallSize, 0.0);
}

float depthOf(vec2 p)
{
    return texture2DLod(brickwallDepth, p / brickwallSize, 0.0).r;
}

vec4 clipOf(vec2 p, float depth)
{
    vec2 inImage = 2.0 * p / brickwallSize - 1.0;
    return brickwallDrawnFromImage * vec4(inImage.x, brickwallUp * inImage.y, 2.0 * depth - 1.0, 1.0);
}

vec4 betweenPlanes(vec4 clip)
{
    return vec4(clip.xy, max(-clip.w, min(clip.z, clip.w)), clip.w);
}
)";

// Depth in whole steps and, for the colour pass, half a step nearer: then LESS lets the nearest fragment pass the depth
// that it left in the depth pass, once, since it leaves a smaller one. 2^23 half steps are exact in a float and
// different in 24 bits.
const std::string warpFragment = composition + R"(
uniform vec2 brickwallSize;
uniform float brickwallPass;

void leave(vec4 color, float depth)
{
    const float steps = 4194304.0;
    float whole = clamp(floor(steps * depth), 1.0, steps - 1.0);
    gl_FragDepth = (whole - 0.5 * brickwallPass) / steps;
    gl_FragColor = brickwallPass * emitted(color);
}
)";

} // namespace

osg::ref_ptr<osg::Program> makeAsIsProgram()
{
    return makeViewportProgram("brickwall AsIs", asIsFragment.c_str());
}

osg::ref_ptr<osg::Program> makeWarpProgram(MultiChannelDrawer::Mode mode)
{
    const bool mesh = isMesh(mode);
    osg::ref_ptr<osg::Program> program = new osg::Program;
    program->setName(mesh ? "brickwall mesh" : "brickwall points");
    program->addShader(new osg::Shader(osg::Shader::VERTEX, warpVertex + (mesh ? meshVertex : pointVertex)));
    program->addShader(new osg::Shader(osg::Shader::FRAGMENT, warpFragment + (mesh ? meshFragment : pointFragment)));
    program->addBindAttribLocation("pixel", drawerState::pixelAttribute);
    return program;
}

} // namespace brickwall
