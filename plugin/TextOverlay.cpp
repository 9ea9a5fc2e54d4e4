// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/TextOverlay.h"

#include "brickwall/core/render/LegendText.h"
#include "brickwall/plugin/ViewportQuad.h"

#include <osg/Depth>

#include <algorithm>
#include <sstream>
#include <vector>

namespace brickwall {
namespace {

constexpr int fontScale = 2;
constexpr int margin = 8; ///< pixels around the text, and of its ground to the window's corner

constexpr const char* fragmentSource = R"(#version 120
uniform sampler2D brickwallText;
uniform vec4 brickwallRect;

void main()
{
    vec2 inside = (gl_FragCoord.xy - brickwallRect.xy) / brickwallRect.zw;
    if (any(lessThan(inside, vec2(0.0))) || any(greaterThan(inside, vec2(1.0))))
        discard;
    gl_FragColor = texture2D(brickwallText, inside);
}
)";

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

Image pictureOf(const std::vector<std::string>& lines)
{
    int width = 0;
    for (const std::string& line : lines)
        width = std::max(width, textWidth(line));
    Image image;
    image.width = fontScale * width + 2 * margin;
    image.height = fontScale * textLineHeight * int(lines.size()) + 2 * margin;
    image.rgba.assign(std::size_t(4) * image.width * image.height, 0);
    for (std::size_t i = 3; i < image.rgba.size(); i += 4)
        image.rgba[i] = 255;
    for (std::size_t i = 0; i < lines.size(); ++i)
        drawText(image, margin, margin + fontScale * textLineHeight * int(i), fontScale, lines[i], vec3i(255));
    return image;
}

osg::ref_ptr<osg::Image> toOsg(const Image& image)
{
    osg::ref_ptr<osg::Image> result = new osg::Image;
    result->allocateImage(image.width, image.height, 1, GL_RGBA, GL_UNSIGNED_BYTE);
    for (int y = 0; y < image.height; ++y) // row 0 is the top row there, the bottom row here
        std::copy_n(image.rgba.begin() + image.index(0, y), 4 * image.width, result->data(0, image.height - 1 - y));
    return result;
}

} // namespace

TextOverlay::TextOverlay()
    : quad_(makeViewportQuad()), texture_(new osg::Texture2D), rect_(new osg::Uniform("brickwallRect", osg::Vec4f()))
{
    rect_->setDataVariance(osg::Object::DYNAMIC);
    texture_->setDataVariance(osg::Object::DYNAMIC);
    texture_->setResizeNonPowerOfTwoHint(false);
    texture_->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture_->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    osg::StateSet* state = quad_->getOrCreateStateSet();
    state->setDataVariance(osg::Object::DYNAMIC);
    state->setAttributeAndModes(makeViewportProgram("brickwall text", fragmentSource));
    state->setTextureAttribute(0, texture_);
    state->addUniform(new osg::Uniform("brickwallText", 0));
    state->addUniform(rect_);
    state->setAttributeAndModes(new osg::Depth(osg::Depth::ALWAYS, 0.0, 1.0, false));
    quad_->setNodeMask(0);
}

void TextOverlay::setText(const std::string& text)
{
    const std::vector<std::string> lines = linesOf(text);
    quad_->setNodeMask(lines.empty() ? 0 : ~0u);
    if (lines.empty())
        return;
    const osg::ref_ptr<osg::Image> image = toOsg(pictureOf(lines));
    image->dirty();
    texture_->setImage(image);
    place();
}

void TextOverlay::setWindowHeight(int height)
{
    windowHeight_ = height;
    place();
}

void TextOverlay::place()
{
    if (const osg::Image* image = texture_->getImage())
        rect_->set(osg::Vec4f(margin, windowHeight_ - margin - image->t(), image->s(), image->t()));
}

} // namespace brickwall
