// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#include "brickwall/core/render/TileScene.h"

namespace brickwall {

void integrateVolume(const TraceScene& volume, const ReferenceIntegrator* reference, const RenderSettings& settings,
                     const RayTile& tile, TileResult& result)
{
    const bool headlight = settings.shading == Shading::headlight;
    const StepParameters steps{settings.step.dt, settings.step.terminationOpacity, headlight};
    switch (settings.method) {
    case Method::bounded:
        return traceBounded(volume, {settings.bounded.tolerance, headlight}, tile, result);
    case Method::fixed:
        return traceFixed(volume, steps, tile, result);
    case Method::midpoint:
        return traceMidpoint(volume, steps, tile, result);
    case Method::bracket:
        return traceBracket(volume, steps, tile, result);
    case Method::preintegrated:
        return tracePreintegrated(volume, steps, tile, result);
    case Method::reference:
        return traceReference(*reference, volume.origin, tile, result);
    }
}

} // namespace brickwall
