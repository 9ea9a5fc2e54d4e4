// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/RigChannels.h"

#include "brickwall/core/shade/Srgb.h"
#include "brickwall/plugin/OsgConversions.h"
#include "brickwall/plugin/StereoState.h"

#include <fmt/format.h>
#include <glm/gtc/matrix_transform.hpp>

#include <osgUtil/CullVisitor>

#include <algorithm>
#include <utility>

namespace brickwall {
namespace {

/// OpenGL clears to what a display shows.
osg::Vec4 clearColorOf(const vec3f& linear)
{
    const auto shown = [](float l) { return srgbFromLinear(std::clamp(l, 0.0f, 1.0f)); };
    return {shown(linear.r), shown(linear.g), shown(linear.b), 1.0f};
}

osg::ref_ptr<osg::Camera> makeCamera(const Rig& rig, StereoMode stereo, Eye eye)
{
    osg::ref_ptr<osg::Camera> camera = new osg::Camera;
    camera->setReferenceFrame(osg::Transform::ABSOLUTE_RF);
    camera->setComputeNearFarMode(osg::CullSettings::DO_NOT_COMPUTE_NEAR_FAR);
    camera->setProjectionResizePolicy(osg::Camera::FIXED);
    camera->setClearColor(clearColorOf(rig.background));
    restrictToEye(*camera, stereo, eye);
    return camera;
}

/// Makes the clip space of a view's window from that of its whole screen.
mat4d windowFromScreen(const View& view)
{
    const vec3d scale(double(view.screenWidth) / view.window.width, double(view.screenHeight) / view.window.height,
                      1.0);
    const vec3d center((2.0 * view.window.x + view.window.width) / view.screenWidth - 1.0,
                       (2.0 * view.window.y + view.window.height) / view.screenHeight - 1.0, 0.0);
    return glm::scale(mat4d(1.0), scale) * glm::translate(mat4d(1.0), -center);
}

} // namespace

RigChannels::RigChannels(const Rig& rig)
{
    for (int i = 0; i < int(rig.channels.size()); ++i) {
        const Channel& channel = rig.channels[i];
        for (const Eye eye : eyesOf(channel.stereo)) {
            Entry entry{i, channel.stereo, {}, makeCamera(rig, channel.stereo, eye)};
            entry.output.name = channel.name;
            entry.output.eye = eye;
            entry.output.viewport = channel.viewport;
            entry.camera->setName(fmt::format("{} {}", channel.name, toString(eye)));
            entry.camera->setViewport(channel.viewport.x, channel.viewport.y, channel.viewport.width,
                                      channel.viewport.height);
            hide(entry);
            entries_.push_back(std::move(entry));
        }
    }
}

bool RigChannels::isDrawnBy(int index, osgUtil::CullVisitor& visitor) const
{
    return visitor.getCurrentCamera() == entries_[index].camera.get();
}

int RigChannels::indexOf(int rigChannel, Eye eye) const
{
    for (int i = 0; i < numChannels(); ++i) {
        if (entries_[i].rigChannel == rigChannel && entries_[i].output.eye == eye)
            return i;
    }
    return -1;
}

void RigChannels::hide(Entry& entry)
{
    entry.camera->setCullMask(0);
    entry.camera->setClearMask(0);
}

OutputChannel RigChannels::outputOf(const ChannelView& view, const mat4d& roomFromWorld, double near, double far)
{
    const auto inRoom = [&](const vec3d& p) { return transformPoint(roomFromWorld, p); };
    const vec3d eye = inRoom(view.view.eye);
    const vec3d lowerLeft = inRoom(view.view.lowerLeft);
    const vec3d lowerRight = inRoom(view.view.lowerRight);
    const vec3d upperRight = inRoom(view.view.upperRight);
    OutputChannel output;
    output.name = view.name;
    output.eye = view.eye;
    output.viewport = view.viewport;
    output.model = toOsg(roomFromWorld);
    output.view = toOsg(modelviewOfScreen(eye, lowerLeft, lowerRight, upperRight));
    output.projection =
        toOsg(windowFromScreen(view.view) * projectionOfScreen(eye, lowerLeft, lowerRight, upperRight, near, far));
    return output;
}

void RigChannels::show(Entry& entry, const ChannelView& view, const mat4d& roomFromWorld, double near, double far)
{
    const std::string name = entry.output.name;
    entry.output = outputOf(view, roomFromWorld, near, far);
    entry.output.name = name;
    osg::Camera& camera = *entry.camera;
    camera.setViewport(view.viewport.x, view.viewport.y, view.viewport.width, view.viewport.height);
    camera.setViewMatrix(entry.output.view);
    camera.setProjectionMatrix(entry.output.projection);
    camera.setCullMask(~0u);
    camera.setClearMask(GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT);
}

void RigChannels::show(const RigViews& views, const mat4d& roomFromWorld, double near, double far)
{
    for (Entry& entry : entries_)
        hide(entry);
    for (const ChannelView& view : views.views) {
        Entry& entry = entries_.at(indexOf(view.channel, view.eye));
        show(entry, view, roomFromWorld, near, far);
        // Interlaced eyes share pixels that a clear does not tell apart: the left one's are there already.
        const int left = indexOf(view.channel, Eye::left);
        if (isInterlaced(entry.stereo) && view.eye == Eye::right && entries_[left].camera->getClearMask() != 0)
            entry.camera->setClearMask(GL_DEPTH_BUFFER_BIT);
    }
}

} // namespace brickwall
