// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/Renderer.h"

namespace brickwall {

// What a Renderer expects of what it is given. All throw Error.

/// Regions and fields are there and belong together, the pyramid's members ascend.
void checkScene(const Scene& scene);
/// The scene has what the transfer function's colours are of.
void checkColorField(const Scene& scene, const TransferFunction& tf);
void checkSurface(const IsoSurface& surface);
void checkPlane(const ContourPlane& contour);
/// `halfBounds` are those of the data, in half voxels.
void checkSettings(const RenderSettings& settings, const Box3i& halfBounds);

} // namespace brickwall
