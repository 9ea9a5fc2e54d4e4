// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/Rig.h"
#include "brickwall/plugin/PixelGrid.h"

#include <osg/Image>
#include <osg/Matrixd>
#include <osg/Texture2D>

namespace brickwall {

/// A view of a MultiChannelDrawer: two sets of images, the back one to be written and the front one to be drawn, and
/// the matrices of each. Its textures have the front images.
class DrawerView : public osg::Referenced
{
public:
    /// One set of images; null without pixels, `depth` also for a view that has none.
    struct Images
    {
        int width = 0;
        int height = 0;
        bool hasDepth = true;
        osg::ref_ptr<osg::Image> color;
        osg::ref_ptr<osg::Image> depth;

        void resize(int newWidth, int newHeight, bool withDepth);
    };

    /// What an image was rendered for.
    struct Matrices
    {
        bool given = false;
        osg::Matrixd modelviewProjection;
        osg::Matrixd projection;
    };

    DrawerView();

    Images back;
    Matrices next;        ///< of the back images
    bool written = false; ///< since the last swap
    Eye eye = Eye::middle;
    osg::ref_ptr<PixelGrid> grid; ///< of the front images' size; null if no mode needs it

    void swap();

    const Images& front() const { return front_; }
    const Matrices& shown() const { return shown_; } ///< of the front images
    /// Whether the front images can be brought to other matrices.
    bool canReproject() const;
    const osg::Matrixd& modelFromImage() const { return modelFromImage_; } ///< from the clip space of the image
    const osg::Matrixd& eyeFromImage() const { return eyeFromImage_; }

    osg::Texture2D* colorTexture() { return color_.get(); }
    osg::Texture2D* depthTexture() { return depth_.get(); }

private:
    Images front_;
    Matrices shown_;
    bool invertible_ = false;
    osg::Matrixd modelFromImage_;
    osg::Matrixd eyeFromImage_;
    osg::ref_ptr<osg::Texture2D> color_;
    osg::ref_ptr<osg::Texture2D> depth_;
};

} // namespace brickwall
