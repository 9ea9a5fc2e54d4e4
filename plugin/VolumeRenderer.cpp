// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/plugin/VolumeRenderer.h"

#include "brickwall/channels/FrameWork.h"
#include "brickwall/channels/LeveredViews.h"

#include <utility>

namespace brickwall {

std::shared_ptr<const VolumeData> readVolume(const SceneOptions& options, Progress& progress)
{
    const Executor executor(options.threads);
    return std::make_shared<VolumeData>(VolumeData{options, prepareScene(options, executor, progress)});
}

SceneOptions withColorField(const SceneOptions& options, const std::optional<TransferFunction>& tf)
{
    SceneOptions changed = options;
    if (tf && tf->colorField && tf->colorField->name != options.colorField) {
        changed.colorField = tf->colorField->name;
        changed.colorRange.clear();
    }
    return changed;
}

bool needsReading(const SceneOptions& a, const SceneOptions& b)
{
    SceneOptions asRead = a; // what Renderer takes as it comes
    asRead.shading = b.shading;
    asRead.iso = b.iso;
    asRead.isoColors = b.isoColors;
    asRead.isoOpacity = b.isoOpacity;
    asRead.light = b.light;
    asRead.ambient = b.ambient;
    asRead.lightTolerance = b.lightTolerance;
    asRead.specular = b.specular;
    asRead.shininess = b.shininess;
    asRead.ambientOcclusion = b.ambientOcclusion;
    asRead.ambientOcclusionRays = b.ambientOcclusionRays;
    asRead.planes = b.planes;
    asRead.planeOpacity = b.planeOpacity;
    asRead.clipPlanes = b.clipPlanes;
    asRead.clipBox = b.clipBox;
    asRead.clipSphere = b.clipSphere;
    asRead.background = b.background;
    asRead.method = b.method;
    asRead.tolerance = b.tolerance;
    asRead.dt = b.dt;
    asRead.threads = b.threads;
    return asRead != b;
}

VolumeRenderer::VolumeRenderer(std::shared_ptr<const VolumeData> data) : data_(std::move(data)) {}

std::vector<Frame> VolumeRenderer::render(const VolumeLook& look, std::span<const View> views, Progress& progress)
{
    return prepare(look, progress).render(views, renderSettings(look.options), progress);
}

std::vector<Frame> VolumeRenderer::render(const VolumeLook& look, std::span<const View> views,
                                          const FrameLevers& levers, Progress& progress)
{
    const RenderSettings settings = withLevers(renderSettings(look.options), levers);
    return prepare(look, progress).render(scaledViews(views, levers), settings, progress);
}

double VolumeRenderer::work(const VolumeLook& look, std::span<const View> views, Progress& progress)
{
    return workOf(prepare(look, progress), views, progress);
}

const Renderer& VolumeRenderer::prepare(const VolumeLook& look, Progress& progress)
{
    if (stamp_ != look.stamp)
        take(look, progress);
    return *renderer_;
}

void VolumeRenderer::take(const VolumeLook& look, Progress& progress)
{
    stamp_.reset(); // unless all of it succeeds
    const bool fromProgram = look.options.data.empty();
    const SceneOptions options = withColorField(look.options, look.transferFunction);
    if (!fromProgram && needsReading(data_->options, options)) {
        data_ = readVolume(options, progress);
        renderer_.reset();
    }
    Scene scene = data_->prepared.scene; // what is large in it is shared
    if (look.transferFunction)
        scene.transferFunction = *look.transferFunction;
    if (!fromProgram) {
        scene.surfaces = isoSurfaces(look.options, scene.transferFunction);
        scene.planes = contourPlanes(look.options);
        scene.clip = clipRegion(look.options);
    }
    if (look.occluders)
        scene.occluders = look.occluders;
    if (renderer_) {
        renderer_->setTransferFunction(scene.transferFunction);
        renderer_->setSurfaces(std::move(scene.surfaces));
        renderer_->setPlanes(std::move(scene.planes));
        renderer_->setClip(std::move(scene.clip));
        renderer_->setOccluders(std::move(scene.occluders));
    } else {
        executor_.emplace(look.options.threads);
        renderer_.emplace(std::move(scene), *executor_);
    }
    stamp_ = look.stamp;
}

} // namespace brickwall
