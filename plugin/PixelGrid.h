// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include <osg/Array>
#include <osg/PrimitiveSet>
#include <osg/Referenced>

namespace brickwall {

/// The vertices of an image, shared by all views of one size: a vertex in the middle of every pixel, in pixels of the
/// image (the first at (1/2, 1/2)), and a ring of vertices on the image's edge, at 0 or at its width or height, so that
/// the outermost half pixel is covered too. 8 bytes per pixel, 16 with the mesh.
class PixelGrid : public osg::Referenced
{
public:
    PixelGrid(int width, int height, bool withMesh);

    bool serves(int width, int height, bool withMesh) const
    {
        return width == width_ && height == height_ && withMesh == mesh_.valid();
    }

    osg::Array* vertices() const { return vertices_.get(); }
    /// All vertices, or a quad between any four neighbours if it was made with the mesh.
    osg::PrimitiveSet* points() const { return points_.get(); }
    osg::PrimitiveSet* mesh() const { return mesh_.get(); }

private:
    int width_;
    int height_;
    osg::ref_ptr<osg::Vec2Array> vertices_;
    osg::ref_ptr<osg::DrawArrays> points_;
    osg::ref_ptr<osg::DrawElementsUInt> mesh_;
};

} // namespace brickwall
