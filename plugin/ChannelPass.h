// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/plugin/ChannelSource.h"
#include "brickwall/plugin/DrawerShaders.h"
#include "brickwall/plugin/DrawerView.h"

#include <osg/Geometry>

namespace brickwall {

/// One drawing of a view in a channel of a host, with a program of DrawerShaders. It sets the program's uniforms at
/// the draw itself, from the matrices that the draw uses: nothing is shared between contexts, threads or eyes.
class ChannelPass : public osg::Geometry
{
public:
    struct Drawing
    {
        bool flipped = false; ///< row 0 of the image is its top row
        double margin = 0.0;  ///< by which a mesh continues the image's edge; of its width and height
        bool alone = false;   ///< no other view is shown in the channel
    };

    ChannelPass(osg::ref_ptr<DrawerView> view, osg::ref_ptr<const ChannelSource> channels, int channel, DrawerPass pass,
                const Drawing& drawing);

    int channel() const { return channel_; }

    /// From the application's model space to the room. Update phase, as refresh().
    void setModel(const osg::Matrixd& model) { model_ = model; }
    /// Takes over the view's grid.
    void refresh();

    /// Cull traversals of other channels, and those that have nothing to show, pass by.
    void accept(osg::NodeVisitor& visitor) override;
    void drawImplementation(osg::RenderInfo& info) const override;

private:
    ~ChannelPass() override = default;
    bool isDrawnBy(osgUtil::CullVisitor& cull) const;
    bool isAtRest(osgUtil::CullVisitor& cull) const;
    osg::Matrixd drawnFromImage(const osg::State& state) const;

    osg::ref_ptr<DrawerView> view_;
    osg::ref_ptr<const ChannelSource> channels_;
    int channel_;
    DrawerPass pass_;
    Drawing drawing_;
    osg::Matrixd model_;
};

} // namespace brickwall
