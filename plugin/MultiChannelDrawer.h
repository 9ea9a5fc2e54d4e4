// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/base/Vec.h"
#include "brickwall/plugin/ChannelSource.h"

#include <osg/GL>
#include <osg/Group>
#include <osg/Uniform>

#include <vector>

namespace brickwall {

class ChannelPass;
class DrawerView;

/// Shows images that were rendered elsewhere, colour and depth, in the output channels of a host, as a part of its
/// scene. Names and meaning are those of COVISE's class of this name, with a view per channel and eye of a
/// ChannelSource.
///
/// Place. The drawer belongs where the graph is in room space: at the root, or below what moves the room. It has no
/// bounds, is never culled, and has no say in near and far.
///
/// Images. Colour is linear, premultiplied RGBA in float. Row 0 is the bottom row, or the top one if the drawer was
/// made `flipped`. Depth is window depth in [0, 1] by the image's own projection. A pixel with colour and alpha 0 is
/// background, whatever its depth: it is never drawn and hides nothing. An image of another size than its viewport is
/// stretched over it.
///
/// Modes say how an image is brought to what the host draws by now. AsIs is a rectangle over the viewport: each pixel
/// stays where it is on the screen, at its distance from the eye's plane. The others take each pixel to where its point
/// is seen now, R = inverse(image model * view * projection) * (model * view * projection), in double: the model matrix
/// is that of the last update(), view and projection are those that the draw really uses, so that a pose newer than
/// update() counts, and near and far may be rewritten by the cull traversal. Without motion every mode shows what AsIs
/// shows. Where several pixels land on one, the nearest wins; views of one channel compete in the same way. Depth,
/// there as in AsIs, is by the projection of the draw; what lies before its near or beyond its far plane is put on it.
/// An image without depth, or whose matrices were never given, is drawn as in AsIs.
///
/// Composition. Every pixel nearer than what the scene has drawn there is blended over it with (ONE,
/// ONE_MINUS_SRC_ALPHA) and leaves its own depth; one that is as far, up to the rounding of 24 bits, counts as nearer,
/// so that images of rays that end at the scene's depth (View::sceneDepth) are shown in full. The window holds sRGB
/// values, in which blending is not that of light. So the shader emits S = sRGB(C + (1 - A) b) - (1 - A) sRGB(b), b the
/// background: over a window that was cleared to sRGB(b), blending gives exactly sRGB(C + (1 - A) b), what a picture
/// file of the frame has. S is never negative (sRGB is concave). In front of opaque geometry of colour g it gives S +
/// (1 - A) g, the usual blending of sRGB values. The host's depth buffer has to have 24 bits or more.
///
/// Double buffering. rgba() and depth() give the back images; what is drawn are the front images, and nobody writes to
/// them. swapFrame() exchanges both for every view that was written to since the last time. Pointers hold until then; a
/// back image holds something old after it, so that a writer writes all of it.
///
/// Threads. Back images may be written and resized by one thread at a time, beside drawing. Everything else belongs to
/// the update phase (between two calls of frame() of the viewer) and swapFrame() also must not meet a writer. Drawables
/// are DYNAMIC, so that OSG's threading models with a draw thread wait for them before the next update phase.
class MultiChannelDrawer : public osg::Group
{
public:
    enum Mode {
        AsIs,
        Reproject,         ///< a point per pixel, as large as a pixel of the image
        ReprojectAdaptive, ///< points that reach their four neighbours if these have the same depth; up to three pixels
        ReprojectAdaptiveWithNeighbors, ///< the same with the neighbours' own depths
        ReprojectMesh,                  ///< a surface through all pixels, continued beyond the edge
        ReprojectMeshWithHoles,         ///< without its parts that are stretched tenfold in one direction
    };

    /// The views that a channel shows; for AsIs it is always Same, since an image on another screen makes no sense.
    enum ViewSelection {
        Same,        ///< view i in channel i
        MatchingEye, ///< every view for the channel's eye: the wall beside it fills what comes into sight
        All,         ///< every view in every channel
    };

    explicit MultiChannelDrawer(osg::ref_ptr<const ChannelSource> channels, bool flipped = false);

    bool flipped() const { return flipped_; }

    int numViews() const;
    /// -1: one view per channel. Views beyond the channels are kept, and seen where viewsToRender() says; channels
    /// without a view show nothing.
    void setNumViews(int count);
    /// The eye that a view is rendered for, for MatchingEye. At first that of the channel of the same number, or
    /// middle.
    Eye viewEye(int view) const;
    void setViewEye(int view, Eye eye);

    /// Takes over the current matrices of all channels: call it after head tracking and before rendering.
    void update();
    /// Of channel i, as of the last update(); OSG's row-vector matrices, clip = vertex * model * view * projection.
    const osg::Matrixd& modelMatrix(int i) const;
    const osg::Matrixd& viewMatrix(int i) const;
    const osg::Matrixd& projectionMatrix(int i) const;

    Mode mode() const { return mode_; }
    void setMode(Mode mode);
    ViewSelection viewsToRender() const { return selection_; }
    void setViewsToRender(ViewSelection selection);

    /// Linear RGB; the host clears its windows to the sRGB values of this. Black at the start.
    void setBackground(const vec3f& linear);

    /// The matrices that the back image of a view is rendered for; published with it.
    void updateMatrices(int view, const osg::Matrixd& model, const osg::Matrixd& viewing,
                        const osg::Matrixd& projection);
    /// Of the image that is shown, as projected there: model * view * projection.
    osg::Matrixd imageMatrix(int view) const;

    /// The size of the back images, pixels; their content is undefined if it changes. 0 x 0: the view shows nothing.
    /// depthFormat 0: the view has no depth; it is drawn over all opaque geometry and leaves no depth. Throws Error for
    /// negative sizes, sizes of which one is 0, and COVISE's other formats (docs/decisions/0026-one-image-format.md).
    void resizeView(int view, int width, int height, GLenum depthFormat = GL_FLOAT, GLenum colorFormat = GL_FLOAT);
    int width(int view) const;
    int height(int view) const;

    /// The back images, width * height; null if the view has no pixels, or no depth.
    vec4f* rgba(int view);
    float* depth(int view);
    void clearColor(int view); ///< to no colour, transparent
    void clearDepth(int view); ///< to the far value, 1

    /// Publishes the back images of all views that were written to.
    void swapFrame();

protected:
    ~MultiChannelDrawer() override;

private:
    DrawerView& at(int view) const;
    void takeChannels();
    /// The passes that mode and selection ask for, for every pair of a view and a channel.
    void arrange();
    bool shows(int view, int channel) const;
    void shareGrids();

    osg::ref_ptr<const ChannelSource> channels_;
    bool flipped_;
    std::vector<OutputChannel> current_;
    std::vector<osg::ref_ptr<DrawerView>> views_;
    std::vector<osg::ref_ptr<ChannelPass>> passes_;
    osg::ref_ptr<osg::Uniform> background_;
    Mode mode_ = ReprojectMesh;
    ViewSelection selection_ = Same;
};

} // namespace brickwall
