// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/Rig.h"
#include "brickwall/core/render/Frame.h"

#include <osg/Group>
#include <osg/StateSet>

#include <vector>

namespace brickwall {

/// A rig to be looked at from outside, in the room's space: its screens as rectangles with the pictures that they show,
/// the heads, and from each eye the frusta through the screens (left eye blue, right eye red, else white). A channel in
/// stereo shows what its left eye sees. Update phase.
class RoomModel
{
public:
    /// The rig has to outlive this.
    explicit RoomModel(const Rig& rig);

    osg::Node* node() { return root_.get(); }

    /// Heads and frusta of this moment.
    void setPose(const RigViews& views, const mat4d& roomFromWorld, const std::vector<mat4d>& roomFromHeads);

    /// A frame per view, in their order, over the rig's background. Channels without a view go black.
    void setPictures(const RigViews& views, const std::vector<Frame>& frames);

private:
    const Rig& rig_;
    osg::ref_ptr<osg::Group> root_;
    osg::ref_ptr<osg::Group> pose_;                  ///< heads and frusta
    std::vector<osg::ref_ptr<osg::StateSet>> walls_; ///< of the channels, with their pictures
};

} // namespace brickwall
