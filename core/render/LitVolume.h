// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/render/LightVisibility.h"

#include <functional>

namespace brickwall {

/// Integrates a volume along the rays of a tile as `integrate` does, its colour as far as the light reaches it.
///
/// A ray is taken in steps, at whose ends the light's visibility is looked for, where what the step adds to the pixel
/// could make a difference. The mean of both is taken; if half their difference times what the step adds is more than
/// the step's share of the light's tolerance (half by length, half by opacity, as in ErrorBudget.h), it is halved.
void integrateLit(const std::function<void(const RayTile&, TileResult&)>& integrate, const Light& light,
                  const LightVisibility& visibility, const RayTile& tile, TileResult& result);

} // namespace brickwall
