// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/plugin/TraversalViews.h"

#include <osg/BufferObject>
#include <osg/Drawable>

#include <memory>
#include <mutex>
#include <optional>

namespace brickwall {

/// What the opaque scene has put in front of a view, and what that was drawn with.
struct DepthReading
{
    PixelRect viewport;
    osg::Matrixd modelview; ///< from the coordinates that the reader stands in
    osg::Matrixd projection;
    std::shared_ptr<const SceneDepth> depth; ///< of the viewport's pixels; null where it is empty
};

/// Reads the depth buffer in the draw traversal of a channel, after what the scene draws in its opaque bins and before
/// any image of a drawer. A draw asks for it and the next one takes what came, so that no draw waits for the graphics
/// card: a reading is one draw old. The same depth, but for a few steps of a depth buffer of 24 bits, at the same place
/// is the same reading, to the pointer.
class DepthReader : public osg::Drawable
{
public:
    DepthReader(osg::ref_ptr<const TraversalViews> views, int channel);

    /// Nothing before the second draw. Any thread.
    std::optional<DepthReading> latest() const;
    /// The channel is drawn into what has no depth to be read: no depth buffer, or a framebuffer object with several
    /// samples per pixel.
    bool isBlind() const;

    /// Cull traversals of other channels pass by.
    void accept(osg::NodeVisitor& visitor) override;
    void drawImplementation(osg::RenderInfo& info) const override;
    void resizeGLObjectBuffers(unsigned size) override;
    void releaseGLObjects(osg::State* state = nullptr) const override;

private:
    struct Asked
    {
        unsigned context = 0;
        DepthReading drawn; ///< without the depth
    };

    ~DepthReader() override = default;
    void take(osg::State& state) const;
    void ask(osg::State& state, const PixelRect& viewport) const;
    void note(DepthReading drawn, const float* values) const;

    osg::ref_ptr<const TraversalViews> views_;
    int channel_;
    // Draw traversals are const.
    mutable std::mutex mutex_;
    mutable osg::ref_ptr<osg::PixelDataBufferObject> buffer_;
    mutable std::optional<Asked> asked_; ///< on its way into the buffer
    mutable std::optional<DepthReading> latest_;
    mutable bool blind_ = false;
};

} // namespace brickwall
