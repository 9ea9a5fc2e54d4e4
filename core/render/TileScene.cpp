// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/TileScene.h"

namespace brickwall {

void integrateVolume(const TileScene& scene, const RenderSettings& settings, const RayTile& tile, TileResult& result)
{
    const bool headlight = settings.shading == Shading::headlight;
    const StepParameters steps{settings.step.dt, settings.step.terminationOpacity, headlight};
    switch (settings.method) {
    case Method::bounded:
        return traceBounded(scene.volume, {settings.bounded.tolerance, headlight}, tile, result);
    case Method::fixed:
        return traceFixed(scene.volume, steps, tile, result);
    case Method::midpoint:
        return traceMidpoint(scene.volume, steps, tile, result);
    case Method::bracket:
        return traceBracket(scene.volume, steps, tile, result);
    case Method::preintegrated:
        return tracePreintegrated(scene.volume, steps, tile, result);
    case Method::reference:
        return traceReference(*scene.reference, scene.volume.origin, tile, result);
    }
}

} // namespace brickwall
