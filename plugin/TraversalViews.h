// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/plugin/ChannelSource.h"

#include <osg/Camera>
#include <osg/NodeVisitor>
#include <osg/Viewport>

#include <mutex>
#include <vector>

namespace brickwall {

/// Whole pixels.
PixelRect rectOf(const osg::Viewport& viewport);

/// The views of a node in a host that does not tell its channels: every cull traversal that reaches the node notes one,
/// known by where the node stands in the graph, the camera, and the eye.
///
/// OSG draws both eyes through one camera (osgUtil::SceneView); the eye is known by the matrix that the traversal
/// starts with: that of the camera, moved to the right for the left eye, to the left for the right eye. Besides,
/// osgViewer gives the traversals of each eye an identifier of their own, which serves where both eyes are the same
/// point.
class TraversalViews : public ChannelSource
{
public:
    int numChannels() const override;
    OutputChannel channel(int index) const override;
    /// Asked below the node that notes.
    bool isDrawnBy(int index, osgUtil::CullVisitor& visitor) const override;

    /// In a cull traversal at the node. `nodeFromModel`: from what the images show to the node's own coordinates.
    void note(osgUtil::CullVisitor& visitor, const osg::Matrixd& nodeFromModel);

    /// In the update phase: makes channels of what was noted for the first time, and forgets those that no traversal
    /// has come from for some frames. A channel keeps its index while it lives; the indices that now stand for another
    /// channel, or none, are returned. Whether the number of channels has changed, numChannels tells.
    std::vector<int> settle();

    /// The indices that stand for a channel.
    std::vector<int> living() const;

    /// What the camera of a channel clears to, as displayed.
    osg::Vec4 clearColor(int index) const;

private:
    struct Key
    {
        osg::NodePath path; ///< from the scene's root to the node
        const void* traversal = nullptr;
        const osg::Camera* camera = nullptr;
        Eye eye = Eye::middle;

        bool operator==(const Key&) const = default;
    };
    struct Entry
    {
        Key key;
        bool alive = false;
        unsigned lastSeen = 0; ///< by the count of updates
        OutputChannel output;
        osg::Vec4 clearColor;
    };

    ~TraversalViews() override = default;
    static Key keyOf(osgUtil::CullVisitor& visitor);

    mutable std::mutex mutex_;
    unsigned updates_ = 0; ///< our own count of frames: each viewer of a program has one
    std::vector<Entry> entries_;
    std::vector<Entry> noted_; ///< no channels yet
};

} // namespace brickwall
