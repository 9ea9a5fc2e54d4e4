// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/DepthReader.h"

#include "brickwall/plugin/SameMatrices.h"

#include <osg/FrameBufferObject>
#include <osg/GLExtensions>
#include <osg/Multisample>
#include <osg/State>
#include <osgUtil/CullVisitor>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>

namespace brickwall {
namespace {

/// Four steps of a depth buffer of 24 bits. The host's matrices are not the same to the last bit in every frame.
constexpr float steps = 0x1p-22f;

bool isDepthReadable(const osg::GLExtensions& gl)
{
    GLint bits = 0, framebuffer = 0, samples = 0;
    glGetIntegerv(GL_DEPTH_BITS, &bits);
    glGetIntegerv(GL_FRAMEBUFFER_BINDING_EXT, &framebuffer);
    glGetIntegerv(GL_SAMPLE_BUFFERS_ARB, &samples);
    return gl.isPBOSupported && bits > 0 && (framebuffer == 0 || samples == 0);
}

/// Null without it.
osg::GLBufferObject* bound(osg::PixelDataBufferObject* buffer, unsigned context)
{
    osg::GLBufferObject* object = buffer ? buffer->getOrCreateGLBufferObject(context) : nullptr;
    if (!object)
        return nullptr;
    if (object->isDirty())
        object->compileBuffer();
    object->bindBuffer();
    return object;
}

osg::ref_ptr<osg::PixelDataBufferObject> makeBuffer(std::size_t bytes)
{
    osg::ref_ptr<osg::PixelDataBufferObject> buffer = new osg::PixelDataBufferObject;
    buffer->setTarget(GL_PIXEL_PACK_BUFFER_ARB);
    buffer->setUsage(GL_STREAM_READ_ARB);
    buffer->setDataSize(unsigned(bytes));
    return buffer;
}

std::size_t pixelsOf(const PixelRect& rect)
{
    return std::size_t(rect.width) * std::size_t(rect.height);
}

bool isEmpty(const float* values, std::size_t count)
{
    return std::all_of(values, values + count, [](float depth) { return depth >= 1.0f; });
}

bool sameDepth(const SceneDepth* a, const float* b, std::size_t count)
{
    if (!a)
        return isEmpty(b, count);
    float largest = 0.0f;
    for (std::size_t i = 0; i < count; ++i)
        largest = std::max(largest, std::abs(a->depth[i] - b[i]));
    return largest <= steps;
}

} // namespace

DepthReader::DepthReader(osg::ref_ptr<const TraversalViews> views, int channel)
    : views_(std::move(views)), channel_(channel)
{
    setUseDisplayList(false);
    setSupportsDisplayList(false);
    setComputeBoundingBoxCallback(new osg::Drawable::ComputeBoundingBoxCallback); // none: no say in near and far
    setCullingActive(false);
    setDataVariance(osg::Object::DYNAMIC);
}

std::optional<DepthReading> DepthReader::latest() const
{
    const std::lock_guard lock(mutex_);
    return latest_;
}

bool DepthReader::isBlind() const
{
    const std::lock_guard lock(mutex_);
    return blind_;
}

void DepthReader::accept(osg::NodeVisitor& visitor)
{
    osgUtil::CullVisitor* cull = visitor.asCullVisitor();
    if (!cull || views_->isDrawnBy(channel_, *cull))
        osg::Drawable::accept(visitor);
}

void DepthReader::drawImplementation(osg::RenderInfo& info) const
{
    osg::State& state = *info.getState();
    const osg::Viewport* viewport = state.getCurrentViewport();
    const PixelRect rect = viewport ? rectOf(*viewport) : PixelRect{};
    const std::lock_guard lock(mutex_);
    take(state);
    blind_ = rect.width <= 0 || rect.height <= 0 || !isDepthReadable(*state.get<osg::GLExtensions>());
    if (!blind_)
        return ask(state, rect);
    latest_.reset();
}

void DepthReader::ask(osg::State& state, const PixelRect& viewport) const
{
    const std::size_t bytes = pixelsOf(viewport) * sizeof(float);
    if (!buffer_ || buffer_->getDataSize() != bytes)
        buffer_ = makeBuffer(bytes);
    osg::GLBufferObject* buffer = bound(buffer_, state.getContextID());
    if (!buffer)
        return;
    glPixelStorei(GL_PACK_ALIGNMENT, sizeof(float));
    glReadPixels(viewport.x, viewport.y, viewport.width, viewport.height, GL_DEPTH_COMPONENT, GL_FLOAT, nullptr);
    buffer->unbindBuffer();
    asked_ = Asked{state.getContextID(), {viewport, state.getModelViewMatrix(), state.getProjectionMatrix(), nullptr}};
}

void DepthReader::take(osg::State& state) const
{
    const std::optional<Asked> asked = std::exchange(asked_, std::nullopt);
    if (!asked || asked->context != state.getContextID())
        return;
    osg::GLBufferObject* buffer = bound(buffer_, state.getContextID());
    if (!buffer)
        return;
    const osg::GLExtensions& gl = *state.get<osg::GLExtensions>();
    if (const void* values = gl.glMapBuffer(GL_PIXEL_PACK_BUFFER_ARB, GL_READ_ONLY_ARB)) {
        note(asked->drawn, static_cast<const float*>(values));
        gl.glUnmapBuffer(GL_PIXEL_PACK_BUFFER_ARB);
    }
    buffer->unbindBuffer();
}

void DepthReader::note(DepthReading drawn, const float* values) const
{
    const std::size_t count = pixelsOf(drawn.viewport);
    if (latest_ && latest_->viewport == drawn.viewport && same(latest_->modelview, drawn.modelview) &&
        same(latest_->projection, drawn.projection) && sameDepth(latest_->depth.get(), values, count))
        return;
    if (!isEmpty(values, count)) {
        const PixelRect window{0, 0, drawn.viewport.width, drawn.viewport.height};
        drawn.depth = std::make_shared<SceneDepth>(SceneDepth{window, std::vector<float>(values, values + count)});
    }
    latest_ = std::move(drawn);
}

void DepthReader::resizeGLObjectBuffers(unsigned size)
{
    osg::Drawable::resizeGLObjectBuffers(size);
    const std::lock_guard lock(mutex_);
    if (buffer_)
        buffer_->resizeGLObjectBuffers(size);
}

void DepthReader::releaseGLObjects(osg::State* state) const
{
    osg::Drawable::releaseGLObjects(state);
    const std::lock_guard lock(mutex_);
    asked_.reset();
    if (buffer_)
        buffer_->releaseGLObjects(state);
}

} // namespace brickwall
