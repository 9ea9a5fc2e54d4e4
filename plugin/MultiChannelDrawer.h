// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"
#include "brickwall/plugin/ChannelSource.h"

#include <osg/Group>
#include <osg/Uniform>

#include <vector>

namespace brickwall {

/// Shows images that were rendered elsewhere, colour and depth, in the output channels of a host, as a part of its
/// scene. Names and meaning are those of COVISE's class of this name; view i belongs to channel i of the ChannelSource,
/// so there is a view per eye.
///
/// Images. Row 0 is the bottom row. Colour is linear, premultiplied RGBA in float; depth is window depth in [0, 1], 1
/// where there is nothing. An image whose size differs from its viewport is stretched over it (nearest neighbour).
///
/// Double buffering. rgba() and depth() give the back images; what is drawn are the front images, and nobody writes to
/// them. swapFrame() exchanges both for every view that was written to since the last time. Pointers hold until then; a
/// back image holds something old after it, so that a writer writes all of it.
///
/// Composition. Every pixel with depth <= what the scene has drawn there is blended over it with (ONE,
/// ONE_MINUS_SRC_ALPHA) and leaves its own depth; a pixel with colour and alpha 0 leaves nothing. The window holds sRGB
/// values, in which blending is not that of light. So the shader emits S = sRGB(C + (1 - A) b) - (1 - A) sRGB(b), b the
/// background: over a window that was cleared to sRGB(b), blending gives exactly sRGB(C + (1 - A) b), what a picture
/// file of the frame has. S is never negative (sRGB is concave). In front of opaque geometry of colour g it gives S +
/// (1 - A) g, the usual blending of sRGB values.
///
/// Threads. Back images may be written and resized by one thread at a time, beside drawing. Everything else belongs to
/// the update phase (between two calls of frame() of the viewer) and swapFrame() also must not meet a writer. Drawables
/// are DYNAMIC, so that OSG's threading models with a draw thread wait for them before the next update phase.
class MultiChannelDrawer : public osg::Group
{
public:
    /// How an image is brought to the channel: AsIs, as a rectangle that covers the viewport, whatever the channel's
    /// matrices are by now.
    enum Mode { AsIs };

    explicit MultiChannelDrawer(osg::ref_ptr<const ChannelSource> channels);

    int numViews() const;
    /// -1: one view per channel. Views without a channel are kept but not drawn, channels without a view show nothing.
    void setNumViews(int count);

    /// Takes over the current matrices of all channels: call it after head tracking and before rendering.
    void update();
    /// Of channel i, as of the last update(); OSG's row-vector matrices, clip = vertex * model * view * projection.
    const osg::Matrixd& modelMatrix(int i) const;
    const osg::Matrixd& viewMatrix(int i) const;
    const osg::Matrixd& projectionMatrix(int i) const;

    Mode mode() const { return mode_; }
    void setMode(Mode mode) { mode_ = mode; }

    /// Linear RGB; the host clears its windows to the sRGB values of this. Black at the start.
    void setBackground(const vec3f& linear);

    /// The matrices that the back image of a view is rendered for; published with it.
    void updateMatrices(int view, const osg::Matrixd& model, const osg::Matrixd& viewing,
                        const osg::Matrixd& projection);
    /// Of the image that is shown, as projected there: model * view * projection.
    osg::Matrixd imageMatrix(int view) const;

    /// The size of the back images, pixels; their content is undefined if it changes. 0 x 0: the view shows nothing.
    /// Throws Error for negative sizes and sizes of which one is 0.
    void resizeView(int view, int width, int height);
    int width(int view) const;
    int height(int view) const;

    /// The back images, width * height; null if the view has no pixels.
    vec4f* rgba(int view);
    float* depth(int view);
    void clearColor(int view); ///< to no colour, transparent
    void clearDepth(int view); ///< to the far value, 1

    /// Publishes the back images of all views that were written to.
    void swapFrame();

    void traverse(osg::NodeVisitor& visitor) override;

protected:
    ~MultiChannelDrawer() override;

private:
    struct ViewData;
    ViewData& at(int view) const;

    osg::ref_ptr<const ChannelSource> channels_;
    std::vector<OutputChannel> current_;
    std::vector<osg::ref_ptr<ViewData>> views_;
    osg::ref_ptr<osg::Uniform> background_;
    Mode mode_ = AsIs;
};

} // namespace brickwall
