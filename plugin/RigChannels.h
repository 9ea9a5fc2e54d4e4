// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/plugin/ChannelSource.h"

#include <osg/Camera>

#include <vector>

namespace brickwall {

/// The channels of a rig, each eye of each with an osg::Camera of its own, which is how the eye is known.
class RigChannels : public ChannelSource
{
public:
    /// A camera per channel and eye, with the rig's background; the window's graphics context is set by the caller.
    explicit RigChannels(const Rig& rig);

    int numChannels() const override { return int(entries_.size()); }
    OutputChannel channel(int index) const override { return entries_[index].output; }
    bool isDrawnBy(int index, osgUtil::CullVisitor& visitor) const override;

    osg::Camera& camera(int index) const { return *entries_[index].camera; }
    /// The channel of the rig that `index` is an eye of.
    int rigChannel(int index) const { return entries_[index].rigChannel; }
    /// Index of a rig's channel and eye, or -1.
    int indexOf(int rigChannel, Eye eye) const;

    /// What a camera of the view has, with the eye's screen in the room.
    static OutputChannel outputOf(const ChannelView& view, const mat4d& roomFromWorld, double near, double far);

    /// Points the cameras at these views, to draw a scene in the room. Channels without a view go black.
    void show(const RigViews& views, const mat4d& roomFromWorld, double near, double far);

private:
    struct Entry
    {
        int rigChannel;
        StereoMode stereo;
        OutputChannel output;
        osg::ref_ptr<osg::Camera> camera;
    };

    ~RigChannels() override = default;
    void hide(Entry& entry);
    void show(Entry& entry, const ChannelView& view, const mat4d& roomFromWorld, double near, double far);

    std::vector<Entry> entries_;
};

} // namespace brickwall
