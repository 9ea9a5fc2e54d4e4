// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/Rig.h"

#include <osg/Matrixd>
#include <osg/Referenced>

#include <string>

namespace osgUtil {
class CullVisitor;
}

namespace brickwall {

/// One output channel seen by one eye. Room space to eye space is `view`, the application's model space to the room
/// `model`.
struct OutputChannel
{
    std::string name;
    Eye eye = Eye::middle;
    PixelRect viewport; ///< of the window, y upwards
    osg::Matrixd model;
    osg::Matrixd view;
    osg::Matrixd projection;
};

/// The output channels of a host program (the rig viewer, COVER), one entry per channel and eye, left before right.
/// A source whose number of channels changes does so in the update phase, before its user calls setNumViews(-1) of the
/// drawer. Called from the update phase, isDrawnBy from cull traversals, several at a time.
class ChannelSource : public osg::Referenced
{
public:
    virtual int numChannels() const = 0;

    /// With the matrices of the coming draw.
    virtual OutputChannel channel(int index) const = 0;

    /// Whether this cull traversal is the one that draws the channel. A host that has a camera per eye compares cameras
    /// (CullVisitor::getCurrentCamera); one that draws both eyes through one camera has to tell them apart by the
    /// visitor's traversal mask. Never by counting: a traversal may be skipped or repeated.
    virtual bool isDrawnBy(int index, osgUtil::CullVisitor& visitor) const = 0;

protected:
    ~ChannelSource() override = default;
};

} // namespace brickwall
