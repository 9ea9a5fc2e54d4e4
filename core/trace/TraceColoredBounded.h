// Copyright 2026 The Brickwall authors. SPDX-License-Identifier: Apache-2.0
#pragma once

#include "brickwall/core/trace/TraceTile.h"

namespace brickwall {

/// traceBounded of a scene whose colours are those of another field (TraceScene::colors). By itself, because either of
/// the two takes minutes to compile.
void traceColoredBounded(const TraceScene& scene, const BoundedParameters& parameters, const RayTile& rays,
                         TileResult& result);

} // namespace brickwall
