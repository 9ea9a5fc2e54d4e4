// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/DrawerView.h"

#include <osg/BufferObject>

#include <utility>

namespace brickwall {
namespace {

struct PixelFormat
{
    GLint internal;
    GLenum source;
};
constexpr PixelFormat colorFormat{GL_RGBA32F_ARB, GL_RGBA};
constexpr PixelFormat depthFormat{GL_R32F, GL_RED}; // a colour texture: a depth texture would have fewer bits

osg::ref_ptr<osg::Image> makeImage(int width, int height, const PixelFormat& format)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    image->allocateImage(width, height, 1, format.source, GL_FLOAT);
    image->setInternalTextureFormat(format.internal);
    image->setDataVariance(osg::Object::DYNAMIC);
    // Uploading from a buffer object of its own lets the driver copy while the next frame is being rendered.
    image->setPixelBufferObject(new osg::PixelBufferObject(image));
    return image;
}

osg::ref_ptr<osg::Texture2D> makeTexture(const PixelFormat& format)
{
    osg::ref_ptr<osg::Texture2D> texture = new osg::Texture2D;
    texture->setDataVariance(osg::Object::DYNAMIC);
    texture->setInternalFormat(format.internal);
    texture->setSourceFormat(format.source);
    texture->setSourceType(GL_FLOAT);
    texture->setFilter(osg::Texture::MIN_FILTER, osg::Texture::NEAREST);
    texture->setFilter(osg::Texture::MAG_FILTER, osg::Texture::NEAREST);
    texture->setWrap(osg::Texture::WRAP_S, osg::Texture::CLAMP_TO_EDGE);
    texture->setWrap(osg::Texture::WRAP_T, osg::Texture::CLAMP_TO_EDGE);
    texture->setResizeNonPowerOfTwoHint(false);
    return texture;
}

} // namespace

void DrawerView::Images::resize(int newWidth, int newHeight, bool withDepth)
{
    if (newWidth == width && newHeight == height && withDepth == hasDepth)
        return;
    width = newWidth;
    height = newHeight;
    hasDepth = withDepth;
    const bool empty = width == 0;
    color = empty ? nullptr : makeImage(width, height, colorFormat);
    depth = empty || !hasDepth ? nullptr : makeImage(width, height, depthFormat);
}

DrawerView::DrawerView() : color_(makeTexture(colorFormat)), depth_(makeTexture(depthFormat)) {}

void DrawerView::swap()
{
    std::swap(front_, back);
    back.resize(front_.width, front_.height, front_.hasDepth);
    written = false;
    shown_ = next;
    invertible_ = shown_.given && modelFromImage_.invert(shown_.modelviewProjection) &&
                  eyeFromImage_.invert(shown_.projection) && !modelFromImage_.isNaN() && !eyeFromImage_.isNaN();
    if (!front_.color)
        return;
    front_.color->dirty();
    color_->setImage(front_.color);
    if (front_.depth) {
        front_.depth->dirty();
        depth_->setImage(front_.depth);
    }
}

bool DrawerView::canReproject() const
{
    return invertible_ && front_.depth;
}

} // namespace brickwall
