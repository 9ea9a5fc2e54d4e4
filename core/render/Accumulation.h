// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Frame.h"

#include <span>
#include <vector>

namespace brickwall {

/// From a pixel's centre, in pixels.
struct PixelOffset
{
    double x = 0.0;
    double y = 0.0;
};

/// Where in its pixel frame number `n` samples, in [-1/2, 1/2]: a sequence that covers the pixel evenly, however many
/// frames there are (R2: Roberts, "The Unreasonable Effectiveness of Quasirandom Sequences", 2018). Frame 0 samples the
/// centre; every point is followed by the one opposite to it, so that after odd numbers of frames the mean is not
/// moved.
PixelOffset pixelOffset(int n);

/// The view with its rays moved by parts of a pixel; all else is the same.
View movedByPixels(const View& view, const PixelOffset& offset);

/// Mean of frames of views that rest, each of other points of the pixels, so that edges become smooth: after n frames
/// the error of the mean is about n^-3/4 of that of one frame. Colours are averaged as they are, linear and
/// premultiplied. The depth of a pixel is that of its centre, where there is something, or else the first that was
/// found, so that one frame accumulated is that frame.
///
/// Starts anew with views that differ in anything from those before: two poses are never blended. What else can be seen
/// (data, transfer function, settings) it does not know of: then restart(). Not thread-safe.
class Accumulation
{
public:
    /// The views that the next frames are to be made of, for these.
    std::vector<View> next(std::span<const View> views);
    /// Frames of what `next` has returned last, in its order; returns the means so far, which are of the views that it
    /// was asked for.
    std::vector<Frame> add(std::vector<Frame> frames);
    void restart();

    /// Frames in the mean.
    int count() const { return count_; }

private:
    std::vector<View> views_;
    std::vector<Frame> means_;
    int count_ = 0;
};

} // namespace brickwall
