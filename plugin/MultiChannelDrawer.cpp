// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/MultiChannelDrawer.h"

#include "brickwall/core/base/Error.h"
#include "brickwall/plugin/DrawerShaders.h"
#include "brickwall/plugin/ViewportQuad.h"

#include <osg/BufferObject>
#include <osg/Image>
#include <osg/Texture2D>
#include <osgUtil/CullVisitor>

#include <fmt/format.h>

#include <algorithm>
#include <utility>

namespace brickwall {
namespace {

struct PixelFormat
{
    GLint internal;
    GLenum source;
};
constexpr PixelFormat colorFormat{GL_RGBA32F_ARB, GL_RGBA};
constexpr PixelFormat depthFormat{GL_R32F, GL_RED};

osg::ref_ptr<osg::Image> makeImage(int width, int height, const PixelFormat& format)
{
    if (width == 0)
        return nullptr;
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

struct MultiChannelDrawer::ViewData : osg::Referenced
{
    struct Images
    {
        int width = 0;
        int height = 0;
        osg::ref_ptr<osg::Image> color;
        osg::ref_ptr<osg::Image> depth;

        void resize(int newWidth, int newHeight)
        {
            if (newWidth == width && newHeight == height)
                return;
            width = newWidth;
            height = newHeight;
            color = makeImage(width, height, colorFormat);
            depth = makeImage(width, height, depthFormat);
        }
    };

    Images front;
    Images back;
    bool written = false;
    osg::Matrixd nextMatrix;  ///< of the back images
    osg::Matrixd shownMatrix; ///< of the front images
    osg::ref_ptr<osg::Texture2D> color = makeTexture(colorFormat);
    osg::ref_ptr<osg::Texture2D> depth = makeTexture(depthFormat);
    osg::ref_ptr<osg::Geometry> quad = makeViewportQuad();

    ViewData()
    {
        osg::StateSet* state = quad->getOrCreateStateSet();
        state->setDataVariance(osg::Object::DYNAMIC);
        state->setTextureAttribute(drawerState::colorUnit, color);
        state->setTextureAttribute(drawerState::depthUnit, depth);
    }

    void swap()
    {
        std::swap(front, back);
        shownMatrix = nextMatrix;
        back.resize(front.width, front.height);
        written = false;
        if (!front.color)
            return;
        front.color->dirty();
        front.depth->dirty();
        color->setImage(front.color);
        depth->setImage(front.depth);
    }
};

MultiChannelDrawer::MultiChannelDrawer(osg::ref_ptr<const ChannelSource> channels)
    : channels_(std::move(channels)), background_(new osg::Uniform(drawerState::backgroundName, osg::Vec3f()))
{
    setName("MultiChannelDrawer");
    setCullingActive(false);
    setStateSet(makeDrawerState());
    background_->setDataVariance(osg::Object::DYNAMIC);
    getStateSet()->addUniform(background_);
    setNumViews(-1);
    update();
}

MultiChannelDrawer::~MultiChannelDrawer() = default;

MultiChannelDrawer::ViewData& MultiChannelDrawer::at(int view) const
{
    if (view < 0 || view >= numViews())
        throw Error("MultiChannelDrawer", fmt::format("there is no view {}; it has {}", view, numViews()));
    return *views_[view];
}

int MultiChannelDrawer::numViews() const
{
    return int(views_.size());
}

void MultiChannelDrawer::setNumViews(int count)
{
    if (count < -1)
        throw Error("MultiChannelDrawer",
                    fmt::format("expected a number of views, or -1 for one per channel, not {}", count));
    views_.resize(count < 0 ? channels_->numChannels() : count);
    removeChildren(0, getNumChildren());
    for (osg::ref_ptr<ViewData>& view : views_) {
        if (!view)
            view = new ViewData;
        addChild(view->quad);
    }
}

void MultiChannelDrawer::update()
{
    current_.resize(channels_->numChannels());
    for (int i = 0; i < int(current_.size()); ++i)
        current_[i] = channels_->channel(i);
}

const osg::Matrixd& MultiChannelDrawer::modelMatrix(int i) const
{
    return current_.at(i).model;
}

const osg::Matrixd& MultiChannelDrawer::viewMatrix(int i) const
{
    return current_.at(i).view;
}

const osg::Matrixd& MultiChannelDrawer::projectionMatrix(int i) const
{
    return current_.at(i).projection;
}

void MultiChannelDrawer::setBackground(const vec3f& linear)
{
    background_->set(osg::Vec3f(linear.r, linear.g, linear.b));
}

void MultiChannelDrawer::updateMatrices(int view, const osg::Matrixd& model, const osg::Matrixd& viewing,
                                        const osg::Matrixd& projection)
{
    at(view).nextMatrix = model * viewing * projection;
}

osg::Matrixd MultiChannelDrawer::imageMatrix(int view) const
{
    return at(view).shownMatrix;
}

void MultiChannelDrawer::resizeView(int view, int width, int height)
{
    if (width < 0 || height < 0 || (width == 0) != (height == 0))
        throw Error("MultiChannelDrawer", fmt::format("view {} cannot be {} x {} pixels", view, width, height));
    ViewData& data = at(view);
    data.written = data.written || width != data.back.width || height != data.back.height;
    data.back.resize(width, height);
}

int MultiChannelDrawer::width(int view) const
{
    return at(view).back.width;
}

int MultiChannelDrawer::height(int view) const
{
    return at(view).back.height;
}

vec4f* MultiChannelDrawer::rgba(int view)
{
    ViewData& data = at(view);
    data.written = true;
    return data.back.color ? reinterpret_cast<vec4f*>(data.back.color->data()) : nullptr;
}

float* MultiChannelDrawer::depth(int view)
{
    ViewData& data = at(view);
    data.written = true;
    return data.back.depth ? reinterpret_cast<float*>(data.back.depth->data()) : nullptr;
}

void MultiChannelDrawer::clearColor(int view)
{
    std::fill_n(rgba(view), std::size_t(width(view)) * height(view), vec4f(0.0f));
}

void MultiChannelDrawer::clearDepth(int view)
{
    std::fill_n(depth(view), std::size_t(width(view)) * height(view), 1.0f);
}

void MultiChannelDrawer::swapFrame()
{
    for (osg::ref_ptr<ViewData>& view : views_) {
        if (view->written)
            view->swap();
    }
}

void MultiChannelDrawer::traverse(osg::NodeVisitor& visitor)
{
    osgUtil::CullVisitor* cull = visitor.asCullVisitor();
    if (!cull) {
        osg::Group::traverse(visitor);
        return;
    }
    const int count = std::min(numViews(), channels_->numChannels());
    for (int i = 0; i < count; ++i) {
        if (views_[i]->front.color && channels_->isDrawnBy(i, *cull))
            views_[i]->quad->accept(visitor);
    }
}

} // namespace brickwall
