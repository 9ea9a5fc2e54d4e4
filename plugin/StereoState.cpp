// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/StereoState.h"

#include "brickwall/plugin/ViewportQuad.h"

#include <osg/ColorMask>
#include <osg/Depth>
#include <osg/Stencil>
#include <osg/Uniform>

namespace brickwall {
namespace {

struct Interlace
{
    StereoMode mode;
    unsigned stencilBit;
    osg::Vec2f weights; ///< the right eye's pixels have an odd x * weights.x + y * weights.y
};

const Interlace interlaces[] = {
    {StereoMode::horizontalInterlace, 1, {0.0f, 1.0f}},
    {StereoMode::verticalInterlace, 2, {1.0f, 0.0f}},
    {StereoMode::checkerboard, 4, {1.0f, 1.0f}},
};

const Interlace* interlaceOf(StereoMode mode)
{
    for (const Interlace& interlace : interlaces) {
        if (interlace.mode == mode)
            return &interlace;
    }
    return nullptr;
}

constexpr const char* patternSource = R"(#version 120
uniform vec2 brickwallWeights;

void main()
{
    if (mod(dot(floor(gl_FragCoord.xy), brickwallWeights), 2.0) < 0.5)
        discard;
    gl_FragColor = vec4(0.0);
}
)";

osg::ref_ptr<osg::Stencil> stencilOf(unsigned bit, osg::Stencil::Function function, unsigned reference,
                                     osg::Stencil::Operation onPass)
{
    osg::ref_ptr<osg::Stencil> stencil = new osg::Stencil;
    stencil->setFunction(function, int(reference), bit);
    stencil->setOperation(osg::Stencil::KEEP, osg::Stencil::KEEP, onPass);
    stencil->setWriteMask(bit);
    return stencil;
}

osg::ref_ptr<osg::Node> makePattern(const Interlace& interlace)
{
    osg::ref_ptr<osg::Geometry> quad = makeViewportQuad();
    osg::StateSet* state = quad->getOrCreateStateSet();
    state->setAttributeAndModes(makeViewportProgram("brickwall interlace", patternSource));
    state->addUniform(new osg::Uniform("brickwallWeights", interlace.weights));
    state->setAttributeAndModes(
        stencilOf(interlace.stencilBit, osg::Stencil::ALWAYS, interlace.stencilBit, osg::Stencil::REPLACE));
    state->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0.0, 1.0, false));
    state->setAttributeAndModes(new osg::ColorMask(false, false, false, false));
    return quad;
}

} // namespace

std::vector<Eye> eyesOf(StereoMode mode)
{
    if (needsTwoEyes(mode))
        return {Eye::left, Eye::right};
    if (mode == StereoMode::mono)
        return {Eye::middle};
    return {mode == StereoMode::right ? Eye::right : Eye::left};
}

bool isInterlaced(StereoMode mode)
{
    return interlaceOf(mode) != nullptr;
}

void restrictToEye(osg::Camera& camera, StereoMode mode, Eye eye)
{
    const bool right = eye == Eye::right;
    GLenum buffer = GL_BACK;
    if (mode == StereoMode::quadBuffer)
        buffer = right ? GL_BACK_RIGHT : GL_BACK_LEFT;
    camera.setDrawBuffer(buffer);
    camera.setReadBuffer(buffer);
    // An explicit mask in any case: the next camera of the window would inherit this one's.
    const bool anaglyphic = mode == StereoMode::anaglyphic;
    camera.setColorMask(!anaglyphic || !right, !anaglyphic || right, !anaglyphic || right, true);
    if (const Interlace* interlace = interlaceOf(mode)) {
        const unsigned bit = interlace->stencilBit;
        camera.getOrCreateStateSet()->setAttributeAndModes(
            stencilOf(bit, osg::Stencil::EQUAL, right ? bit : 0, osg::Stencil::KEEP));
    }
}

osg::ref_ptr<osg::Node> makeInterlacePatterns()
{
    osg::ref_ptr<osg::Group> patterns = new osg::Group;
    patterns->setCullingActive(false);
    for (const Interlace& interlace : interlaces)
        patterns->addChild(makePattern(interlace));
    return patterns;
}

} // namespace brickwall
