// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/WindowCapture.h"

#include <osg/RenderInfo>

#include <chrono>
#include <utility>

namespace brickwall {
namespace {

osg::ref_ptr<osg::Image> readPixels(const osg::Viewport& viewport, GLenum buffer)
{
    osg::ref_ptr<osg::Image> image = new osg::Image;
    glReadBuffer(buffer);
    image->readPixels(int(viewport.x()), int(viewport.y()), int(viewport.width()), int(viewport.height()), GL_RGB,
                      GL_UNSIGNED_BYTE);
    return image;
}

} // namespace

void WindowCapture::request()
{
    const std::lock_guard lock(mutex_);
    picture_ = {};
    requested_ = true;
}

WindowCapture::Picture WindowCapture::take()
{
    std::unique_lock lock(mutex_);
    done_.wait_for(lock, std::chrono::seconds(30), [this] { return picture_.left.valid(); });
    return std::exchange(picture_, {});
}

void WindowCapture::operator()(osg::RenderInfo& info) const
{
    const std::lock_guard lock(mutex_);
    if (!requested_)
        return;
    const osg::Viewport& viewport = *info.getCurrentCamera()->getViewport();
    picture_.left = readPixels(viewport, quadBuffer_ ? GL_BACK_LEFT : GL_BACK);
    if (quadBuffer_)
        picture_.right = readPixels(viewport, GL_BACK_RIGHT);
    requested_ = false;
    done_.notify_all();
}

} // namespace brickwall
