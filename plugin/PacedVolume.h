// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/plugin/FramePace.h"
#include "brickwall/plugin/VolumeRenderer.h"

#include <memory>
#include <string>

namespace brickwall {

/// A VolumeRenderer whose frame rate is held (FramePace), while its look may be another one in each call. The makers
/// are called one at a time, by the thread that renders, and keep this alive; all else from any thread.
class PacedVolume : public std::enable_shared_from_this<PacedVolume>
{
public:
    /// The levers are those of the looks to come (leversOf). Their finest setting is the looks' own.
    static std::shared_ptr<PacedVolume> make(std::shared_ptr<VolumeRenderer> renderer, LeverTable levers, double fps);

    FrameMaker moving(VolumeLook look) { return maker(std::move(look), pace_.moving()); }
    FrameMaker resting(VolumeLook look) { return maker(std::move(look), pace_.resting()); }
    const LeverTable& levers() const { return pace_.levers(); }
    bool refined() const { return pace_.refined(); }
    void setFps(double fps) { pace_.setFps(fps); }
    std::string status() const { return pace_.status(); }

private:
    PacedVolume(std::shared_ptr<VolumeRenderer> renderer, LeverTable levers, double fps);
    FrameMaker maker(VolumeLook look, FrameMaker paced);

    const std::shared_ptr<VolumeRenderer> renderer_;
    VolumeLook look_; ///< of the call that is running
    FramePace pace_;
};

} // namespace brickwall
