// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/plugin/DepthReader.h"

#include <osg/Group>

#include <optional>
#include <vector>

namespace brickwall {

/// A reader per channel of TraversalViews. Belongs below the node that notes, in the coordinates of its images.
class DepthReaders : public osg::Group
{
public:
    explicit DepthReaders(osg::ref_ptr<const TraversalViews> views);

    /// Without readers, nothing is read. Update phase, as what follows.
    void enable(bool enabled);
    /// After views_->settle(), with what that returned.
    void follow(const std::vector<int>& changed);

    std::optional<DepthReading> latest(int channel) const;
    /// A first reading of some channel is still to come.
    bool areIncomplete() const;
    /// So is the reading for the matrices that some channel has now.
    bool areBehind() const;

private:
    ~DepthReaders() override = default;
    /// Of the living channels, those that see.
    std::vector<int> seeing() const;

    osg::ref_ptr<const TraversalViews> views_;
    bool enabled_ = true;
    std::vector<osg::ref_ptr<DepthReader>> readers_; ///< one per channel, while enabled
};

} // namespace brickwall
