// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/PacedVolume.h"

#include <utility>

namespace brickwall {

std::shared_ptr<PacedVolume> PacedVolume::make(std::shared_ptr<VolumeRenderer> renderer, LeverTable levers, double fps)
{
    return std::shared_ptr<PacedVolume>(new PacedVolume(std::move(renderer), std::move(levers), fps));
}

PacedVolume::PacedVolume(std::shared_ptr<VolumeRenderer> renderer, LeverTable levers, double fps)
    : renderer_(std::move(renderer)),
      pace_([this](std::span<const View> views, const FrameLevers& paid,
                   Progress& progress) { return renderer_->render(look_, views, paid, progress); },
            std::move(levers), fps,
            [this](std::span<const View> views, Progress& progress) { return renderer_->work(look_, views, progress); })
{
}

FrameMaker PacedVolume::maker(VolumeLook look, FrameMaker paced)
{
    return [self = shared_from_this(), look = std::move(look), paced = std::move(paced)](std::span<const View> views,
                                                                                         Progress& progress) {
        self->renderer_->prepare(look, progress); // no part of the frame's time
        self->look_ = look;
        return paced(views, progress);
    };
}

} // namespace brickwall
