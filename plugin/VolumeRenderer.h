// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/channels/FrameLevers.h"
#include "brickwall/core/scene/SceneSetup.h"

#include <memory>
#include <optional>
#include <span>
#include <vector>

namespace brickwall {

/// Data that were read and prepared, shared by all nodes that show them.
struct VolumeData
{
    SceneOptions options; ///< that they were read with
    PreparedScene prepared;
};

/// Throws Error for what cannot be read, and Cancelled.
std::shared_ptr<const VolumeData> readVolume(const SceneOptions& options, Progress& progress);

/// The options to read data with that are shown with a transfer function of their own: with its colour field, if it has
/// one.
SceneOptions withColorField(const SceneOptions& options, const std::optional<TransferFunction>& tf);

/// Whether data read with `a` do not serve `b`: another field, or a transfer function that is made from the data.
bool needsReading(const SceneOptions& a, const SceneOptions& b);

/// How data are shown. With an empty name of data in the options, the data's own surfaces and transfer function.
struct VolumeLook
{
    SceneOptions options;
    std::optional<TransferFunction> transferFunction; ///< instead of that of the options
    std::shared_ptr<const TriangleScene> occluders;   ///< instead of the scene's own, if not null
    unsigned stamp = 0;                               ///< equal stamps, equal looks
};

/// Renders data with a look that changes from call to call; does only the work that the change needs. One thread at a
/// time.
class VolumeRenderer
{
public:
    explicit VolumeRenderer(std::shared_ptr<const VolumeData> data);

    /// Throws as Renderer::render, and what reading throws if the look needs data that are not there.
    std::vector<Frame> render(const VolumeLook& look, std::span<const View> views, Progress& progress);
    /// As accurately as the levers say, with as many pixels as they say (scaledView).
    std::vector<Frame> render(const VolumeLook& look, std::span<const View> views, const FrameLevers& levers,
                              Progress& progress);
    /// Does what the look needs, which may be reading, and renders nothing.
    const Renderer& prepare(const VolumeLook& look, Progress& progress);
    /// What the views will have to do (workOf).
    double work(const VolumeLook& look, std::span<const View> views, Progress& progress);

private:
    void take(const VolumeLook& look, Progress& progress);

    std::shared_ptr<const VolumeData> data_;
    std::optional<Executor> executor_;
    std::optional<Renderer> renderer_;
    std::optional<unsigned> stamp_;
};

} // namespace brickwall
